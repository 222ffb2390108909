// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kMaxDrops = 300;
constexpr float32 kPerSecond = 60.0f;
constexpr float32 kHeight = 22.0f;        ///< of the cloud [m]
constexpr float32 kReach = 11.0f;         ///< of the cloud to either side [m]
constexpr float32 kSize = 0.3f;           ///< half the size of a drop [m]
const b2Vec2 kBirthVelocity(0.0f, -8.0f); ///< [m/s]

// Pegs in rows, each beside the gaps of the row above.
constexpr int32 kPegRows = 4;
constexpr int32 kPegs = 8;
constexpr float32 kPegStep = 3.0f;   ///< [m]
constexpr float32 kPegRadius = 0.4f; ///< [m]

/// Balls, boxes and triangles rain through rows of pegs into a basin.
class Rain : public Scene
{
public:
    explicit Rain(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(14.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(-14.0f, 26.0f));
        AddGroundEdge(m_world, b2Vec2(14.0f, 0.0f), b2Vec2(14.0f, 26.0f));
        b2Body* pegs = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        for (int32 row = 0; row < kPegRows; ++row)
        {
            const float32 left = -0.5f * kPegStep * (static_cast<float32>(kPegs - 1 + row % 2));
            for (int32 i = 0; i < kPegs + row % 2; ++i)
            {
                AttachCircle(*pegs, kPegRadius, {.friction = 0.1f, .restitution = 0.4f},
                             b2Vec2(left + kPegStep * static_cast<float32>(i),
                                    8.0f + 3.0f * static_cast<float32>(row)));
            }
        }
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        // Due by now, however long a step is.
        const int32 due = b2Min(1 + static_cast<int32>(m_time * kPerSecond), kMaxDrops);
        for (; m_drops < due; ++m_drops)
        {
            AddDrop();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    void VisitState(SceneState& state) override { state(m_random, m_drops, m_time); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 12.5f), .halfSize = b2Vec2(15.0f, 13.5f)};
    }

private:
    void AddDrop()
    {
        const float32 x = m_random.Between(-kReach, kReach);
        const float32 angle = m_random.Between(-b2_pi, b2_pi);
        b2Body* drop = AddBody(m_world, b2_dynamicBody, b2Vec2(x, kHeight), angle);
        switch (m_drops % 3)
        {
        case 0:
            AttachCircle(*drop, kSize, {});
            break;
        case 1:
            AttachBox(*drop, kSize, kSize, {});
            break;
        default:
            AttachPolygon(*drop, {{-kSize, -0.7f * kSize}, {kSize, -0.7f * kSize}, {0.0f, kSize}},
                          {});
            break;
        }
        drop->SetLinearVelocity(kBirthVelocity);
    }

    Random m_random;
    int32 m_drops = 0;     ///< so far
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeRain(const SceneSettings& settings)
{
    return std::make_unique<Rain>(settings);
}

} // namespace boxreel
