// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfExtent = 10.0f;   ///< of the drum, wall centre to centre [m]
constexpr float32 kWallHalfWidth = 0.5f; ///< [m]
constexpr float32 kTurningSpeed = 25.0f * b2_pi / 180.0f; ///< [rad/s]
const b2Vec2 kDrumCenter(0.0f, 10.0f);                    ///< [m]

constexpr int32 kBoxCount = 396;
constexpr float32 kBoxHalfSize = 0.25f; ///< [m]

// Boxes come in rows, fast enough to have cleared the place before the next row is due.
constexpr int32 kPerRow = 12;
constexpr float32 kRowsPerSecond = 5.0f;
constexpr float32 kRowStep = 0.75f; ///< from box to box, room for a box turned by any angle [m]
const b2Vec2 kBirthVelocity(0.0f, -3.0f);                                            ///< [m/s]
const b2Vec2 kRowStart(-0.5f * kRowStep * static_cast<float32>(kPerRow - 1), 14.0f); ///< [m]

/// The drum is kinematic: it turns evenly under any load.
class Tumbler : public Scene
{
public:
    explicit Tumbler(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        b2Body* drum = AddBody(m_world, b2_kinematicBody, kDrumCenter);
        const Material wall{.density = 5.0f};
        AttachBox(*drum, kWallHalfWidth, kHalfExtent, wall, b2Vec2(kHalfExtent, 0.0f));
        AttachBox(*drum, kWallHalfWidth, kHalfExtent, wall, b2Vec2(-kHalfExtent, 0.0f));
        AttachBox(*drum, kHalfExtent, kWallHalfWidth, wall, b2Vec2(0.0f, kHalfExtent));
        AttachBox(*drum, kHalfExtent, kWallHalfWidth, wall, b2Vec2(0.0f, -kHalfExtent));
        drum->SetAngularVelocity(kTurningSpeed);
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        // Depends on time, not on steps, so that films at every --hz show the same pour.
        const int32 rowsDue = 1 + static_cast<int32>(m_time * kRowsPerSecond);
        const int32 boxesDue = b2Min(rowsDue * kPerRow, kBoxCount);
        for (; m_boxes < boxesDue; ++m_boxes)
        {
            const float32 x = kRowStep * static_cast<float32>(m_boxes % kPerRow);
            const float32 angle = m_random.Between(-b2_pi, b2_pi);
            b2Body* box = AddBox(m_world, kRowStart + b2Vec2(x, 0.0f), kBoxHalfSize, kBoxHalfSize,
                                 Material{}, angle);
            box->SetLinearVelocity(kBirthVelocity);
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    void VisitState(SceneState& state) override { state(m_random, m_boxes, m_time); }

private:
    Random m_random;
    int32 m_boxes = 0;     ///< poured in so far
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeTumbler(const SceneSettings& settings)
{
    return std::make_unique<Tumbler>(settings);
}

} // namespace boxreel
