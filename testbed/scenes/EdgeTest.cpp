// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kEdgeCount = 24;
constexpr float32 kEdgeLength = 1.0f; ///< [m]
constexpr float32 kHalfLength = 0.5f * kEdgeLength * static_cast<float32>(kEdgeCount);
constexpr float32 kLanes[] = {6.0f, 0.0f}; ///< heights: without and with neighbours [m]
constexpr float32 kHalfSize = 0.5f;        ///< of what slides [m]
constexpr float32 kSpeed = 8.0f;           ///< [m/s]
constexpr float32 kRoom = 1.5f;            ///< from where it turns to the end of the lane [m]

// Nothing but the seams could take their speed.
constexpr Material kSlippery{.density = 1.0f, .friction = 0.0f};

constexpr KeyBinding kKeys[] = {{'a', "sends them to the left"}, {'d', "sends them to the right"}};

/// A box and a disc on each of two rows of edges. The edges of the lower row know their neighbours
/// and so collide as one smooth line; those of the upper row are each alone.
class EdgeTest : public Scene
{
public:
    explicit EdgeTest(const SceneSettings& settings) : Scene(settings)
    {
        AddLane(kLanes[0], false);
        AddLane(kLanes[1], true);
        for (const float32 height : kLanes)
        {
            // They pass each other by: only the seams are of interest.
            SetGroup(*AddBox(m_world, b2Vec2(-5.0f, height + kHalfSize), kHalfSize, kHalfSize,
                             kSlippery),
                     -1);
            SetGroup(*AddBall(m_world, b2Vec2(-8.0f, height + kHalfSize), kHalfSize, kSlippery),
                     -1);
        }
        Send(1.0f);
    }

    void Step(const StepSettings& settings) override
    {
        ForEachMover([this](b2Body& body) {
            const float32 x = m_lane->GetLocalPoint(body.GetPosition()).x;
            const bool isAtEnd = b2Abs(x) > kHalfLength - kRoom;
            if (isAtEnd && x * body.GetLinearVelocity().x >= 0.0f)
            {
                body.SetLinearVelocity(b2Vec2(x > 0.0f ? -kSpeed : kSpeed, 0.0f));
            }
        });
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'a' || key == 'd')
        {
            Send(key == 'a' ? -1.0f : 1.0f);
        }
    }

    void VisitState(SceneState& state) override { state(m_lane); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 3.5f), .halfSize = b2Vec2(12.5f, 4.5f)};
    }

private:
    void AddLane(float32 height, bool knowsNeighbours)
    {
        m_lane = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, height));
        const auto vertex = [](int32 i) {
            return b2Vec2(-kHalfLength + kEdgeLength * static_cast<float32>(i), 0.0f);
        };
        for (int32 i = 0; i < kEdgeCount; ++i)
        {
            b2EdgeShape edge;
            edge.Set(vertex(i), vertex(i + 1));
            edge.m_hasVertex0 = edge.m_hasVertex3 = knowsNeighbours;
            edge.m_vertex0 = vertex(i - 1);
            edge.m_vertex3 = vertex(i + 2);
            m_lane->CreateFixture(&edge, 0.0f)->SetFriction(0.0f);
        }
    }

    template <class Do>
    void ForEachMover(const Do& act)
    {
        for (b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            if (body->GetType() == b2_dynamicBody)
            {
                act(*body);
            }
        }
    }

    void Send(float32 direction)
    {
        ForEachMover([direction](b2Body& body) {
            body.SetLinearVelocity(b2Vec2(direction * kSpeed, 0.0f));
        });
    }

    b2Body* m_lane = nullptr; ///< the last one: both have their middle at the same x
};

} // namespace

std::unique_ptr<Scene> MakeEdgeTest(const SceneSettings& settings)
{
    return std::make_unique<EdgeTest>(settings);
}

} // namespace boxreel
