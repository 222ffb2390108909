// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBallCount = 6;
constexpr float32 kRadius = 1.0f; ///< [m]

// The balls seem to touch. A tiny gap between them makes every impact one between two balls: the
// solver handles them one after the other, like the shock wave in a real cradle. Balls that touch
// exactly would be solved at once. Newton's law of restitution for one instant does not determine
// which of them carry the momentum on.
constexpr float32 kGap = 0.01f;                   ///< [m]
constexpr float32 kPitch = 2.0f * kRadius + kGap; ///< from ball to ball [m]

constexpr float32 kStringLength = 8.0f; ///< [m]
constexpr float32 kBeamHeight = 12.0f;  ///< of the points the strings hang from [m]

// The initial angle of the first ball. The 3-4-5 triangle puts it exactly on its string's arc.
constexpr float32 kRaisedSine = 0.6f;
constexpr float32 kRaisedCosine = 0.8f;

// Collisions are elastic and without friction, so the cradle keeps its energy.
constexpr Material kSteel{.density = 5.0f, .friction = 0.0f, .restitution = 1.0f};

class NewtonsCradle : public Scene
{
public:
    explicit NewtonsCradle(const SceneSettings& settings) : Scene(settings)
    {
        const float32 firstX = -0.5f * kPitch * static_cast<float32>(kBallCount - 1);
        b2Body* beam =
            AddGroundBox(m_world, b2Vec2(0.0f, kBeamHeight + 0.25f), -firstX + 2.0f, 0.25f);
        for (int32 i = 0; i < kBallCount; ++i)
        {
            const b2Vec2 hook(firstX + kPitch * static_cast<float32>(i), kBeamHeight);
            const b2Vec2 string =
                i == 0 ? b2Vec2(-kRaisedSine, -kRaisedCosine) : b2Vec2(0.0f, -1.0f);
            b2Body* ball = AddBall(m_world, hook + kStringLength * string, kRadius, kSteel);

            b2DistanceJointDef joint;
            joint.Initialize(beam, ball, hook, ball->GetPosition());
            m_world.CreateJoint(&joint);
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeNewtonsCradle(const SceneSettings& settings)
{
    return std::make_unique<NewtonsCradle>(settings);
}

} // namespace boxreel
