// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kColumnCount = 5;
constexpr int32 kBoxesPerColumn = 10;
constexpr int32 kUntrueColumn = 2;       ///< the one in the middle is laid carelessly
constexpr float32 kCarelessness = 0.03f; ///< how far its boxes are off their place, at most [m]
constexpr float32 kHalfSize = 0.5f;      ///< [m]
constexpr float32 kColumnStep = 3.0f;    ///< [m]

constexpr float32 kThrowTime = 5.0f; ///< long enough to see that the columns stand [s]
const b2Vec2 kThrow(20.0f, 4.0f);    ///< [m/s]

class VerticalStack : public Scene
{
public:
    explicit VerticalStack(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-15.0f, 0.0f), b2Vec2(14.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(14.0f, 0.0f), b2Vec2(14.0f, 12.0f));
        AddGroundBox(m_world, b2Vec2(-13.0f, 1.5f), 1.5f, 1.5f);
        m_ball = AddBall(m_world, b2Vec2(-13.0f, 4.0f), 1.0f, {.density = 6.0f});

        Random random(settings.seed);
        for (int32 column = 0; column < kColumnCount; ++column)
        {
            const float32 middle = kColumnStep * static_cast<float32>(column - kColumnCount / 2);
            for (int32 i = 0; i < kBoxesPerColumn; ++i)
            {
                const float32 reach = column == kUntrueColumn ? kCarelessness : 0.0f;
                const float32 x = middle + random.Between(-reach, reach);
                const float32 y = kHalfSize + 2.0f * kHalfSize * static_cast<float32>(i);
                AddBox(m_world, b2Vec2(x, y), kHalfSize, kHalfSize);
            }
        }
    }

    void Step(const StepSettings& settings) override
    {
        if (!m_thrown && m_time >= kThrowTime)
        {
            m_ball->SetLinearVelocity(kThrow);
            m_thrown = true;
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    void VisitState(SceneState& state) override { state(m_ball, m_thrown, m_time); }

private:
    b2Body* m_ball;        ///< waits on its pedestal
    bool m_thrown = false; ///< true after the columns have stood for a while
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeVerticalStack(const SceneSettings& settings)
{
    return std::make_unique<VerticalStack>(settings);
}

} // namespace boxreel
