// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <vector>

namespace boxreel
{

namespace
{

constexpr float32 kPlankLength = 1.5f;     ///< from weld to weld [m]
constexpr float32 kPlankHalfHeight = 0.2f; ///< [m]
constexpr float32 kKerb = 0.55f;           ///< half height of what keeps balls on a beam [m]
constexpr float32 kBallRadius = 0.5f;      ///< [m]
constexpr float32 kKick = 3.0f;            ///< of the hanging beams' lower ends [m/s]
constexpr Material kWood{.density = 4.0f};
constexpr Material kLead{.density = 2.0f};

/// The weld between the planks of a beam.
struct Weld
{
    float32 hertz;
    float32 damping;
};
constexpr Weld kRigid{.hertz = 0.0f, .damping = 0.0f};
constexpr Weld kSoft{.hertz = 26.0f, .damping = 4.0f};
constexpr Weld kSofter{.hertz = 11.0f, .damping = 1.0f};

/// Beams of planks welded end to end, each twice: with rigid welds and, below or to the right of
/// it, with soft ones. Two stick out of a wall, two hang from a ceiling, two lie on blocks.
class Cantilever : public Scene
{
public:
    explicit Cantilever(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // with one step, a row of welds bends
        AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(18.0f, 0.0f));
        AddOutOfTheWall();
        AddHanging();
        AddLying(b2Vec2(4.0f, 10.0f), kRigid, "rigid middle");
        AddLying(b2Vec2(4.0f, 4.0f), kSofter, "soft middle");
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(-1.2f, 7.5f), .halfSize = b2Vec2(15.5f, 8.0f)};
    }

private:
    /// Adds a row of planks from `start` [m] at this angle [rad]. The first is welded to `holder`
    /// if there is one.
    std::vector<b2Body*> AddBeam(b2Body* holder, const b2Vec2& start, float32 angle, int32 planks,
                                 const Weld& weld)
    {
        const b2Vec2 direction = b2Rot(angle).GetXAxis();
        std::vector<b2Body*> beam;
        for (int32 i = 0; i < planks; ++i)
        {
            const b2Vec2 end = start + kPlankLength * static_cast<float32>(i) * direction;
            b2Body* plank = AddBox(m_world, end + 0.5f * kPlankLength * direction,
                                   0.5f * kPlankLength, kPlankHalfHeight, kWood, angle);
            b2Body* previous = beam.empty() ? holder : beam.back();
            if (previous != nullptr)
            {
                AddWeld(m_world, previous, plank, end, weld.hertz, weld.damping);
            }
            beam.push_back(plank);
        }
        return beam;
    }

    void AddOutOfTheWall()
    {
        constexpr int32 kPlanks = 6;
        b2Body* wall = AddGroundBox(m_world, b2Vec2(-16.0f, 7.5f), 0.5f, 7.5f);
        const auto add = [&](float32 height, const Weld& weld, const char* name) {
            b2Body* tip = AddBeam(wall, b2Vec2(-15.5f, height), 0.0f, kPlanks, weld).back();
            Name(*tip, name);
            AttachBox(*tip, 0.08f, kKerb, kWood, b2Vec2(0.5f * kPlankLength, kKerb));
            for (int32 i = 0; i < 2; ++i)
            {
                const b2Vec2 above(-0.1f - 1.05f * static_cast<float32>(i), 0.72f);
                AddBall(m_world, tip->GetPosition() + above, kBallRadius, kLead);
            }
        };
        add(11.0f, kRigid, "rigid tip");
        add(6.5f, kSoft, "soft tip");
    }

    void AddHanging()
    {
        constexpr int32 kPlanks = 4;
        b2Body* ceiling = AddGroundBox(m_world, b2Vec2(-2.0f, 14.0f), 3.0f, 0.4f);
        const auto add = [&](float32 x, const Weld& weld, const char* name) {
            b2Body* tip = AddBeam(ceiling, b2Vec2(x, 13.6f), -0.5f * b2_pi, kPlanks, weld).back();
            tip->SetLinearVelocity(b2Vec2(kKick, 0.0f));
            Name(*tip, name);
        };
        add(-3.7f, kRigid, "rigid end");
        add(-0.3f, kSofter, "soft end");
    }

    /// On two blocks, with balls in the middle.
    void AddLying(const b2Vec2& leftBlock, const Weld& weld, const char* name)
    {
        constexpr int32 kPlanks = 6;
        constexpr float32 kBlock = 0.4f;
        const float32 length = kPlankLength * static_cast<float32>(kPlanks);
        AddGroundBox(m_world, leftBlock, kBlock, kBlock);
        AddGroundBox(m_world, leftBlock + b2Vec2(length - 2.0f * kBlock, 0.0f), kBlock, kBlock);
        const b2Vec2 start = leftBlock + b2Vec2(-kBlock, kBlock + kPlankHalfHeight);
        Name(*AddBeam(nullptr, start, 0.0f, kPlanks, weld)[kPlanks / 2], name);
        for (int32 i = 0; i < 2; ++i)
        {
            const float32 above = 1.5f + 1.2f * static_cast<float32>(i);
            AddBall(m_world, start + b2Vec2(0.5f * length, above), kBallRadius, kLead);
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeCantilever(const SceneSettings& settings)
{
    return std::make_unique<Cantilever>(settings);
}

} // namespace boxreel
