// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Notes.h>
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

// Only the seams can slow the bodies down.
constexpr Material kSlippery{.density = 1.0f, .friction = 0.0f};

constexpr KeyBinding kKeys[] = {{'a', "sends them to the left"}, {'d', "sends them to the right"}};

// The mark below a lane for each of its edges. A single edge ends at its vertices, an edge with
// neighbours extends into both of them.
constexpr float32 kBelow = 0.35f;    ///< [m]
constexpr float32 kGap = 0.12f;      ///< between two that are alone, half of it [m]
constexpr float32 kOverlap = 0.3f;   ///< into a neighbour [m]
constexpr float32 kLossScale = 4.0f; ///< of the arrows for lost speed [s]
constexpr float32 kSeen = 0.02f;     ///< less lost speed than this has no arrow [m/s]

/// A box and a disc on each of two rows of edges. The edges of the lower row have neighbours (blue)
/// and collide as one smooth line. Those of the upper row are single (orange), so a disc that sinks
/// in by the engine's slop hits the end of the next one. Arrows show the loss of speed.
class EdgeTest : public Scene
{
public:
    explicit EdgeTest(const SceneSettings& settings) : Scene(settings)
    {
        AddLane(kLanes[0], false);
        AddLane(kLanes[1], true);
        for (const float32 height : kLanes)
        {
            // They do not collide with each other, because only the seams are of interest.
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
        ForEachMover(m_world, [this](b2Body& body) {
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

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        float32 lost[2] = {0.0f, 0.0f};
        ForEachMover(m_world, [&](const b2Body& body) {
            float32& maximum = lost[IsOnUpperLane(body) ? 0 : 1];
            maximum = b2Max(maximum, LostSpeed(body));
        });
        return {{"lost on edges alone (orange)", WithUnit(lost[0], "m/s")},
                {"lost on edges with neighbours (blue)", WithUnit(lost[1], "m/s")}};
    }

    void Draw(b2Draw& draw) const override
    {
        const b2Vec2 lower = m_lane->GetPosition() - b2Vec2(kHalfLength, kBelow);
        const b2Vec2 upper = lower + b2Vec2(0.0f, kLanes[0] - kLanes[1]);
        for (int32 i = 0; i < kEdgeCount; ++i)
        {
            const b2Vec2 start(kEdgeLength * static_cast<float32>(i), 0.0f);
            const b2Vec2 end = start + b2Vec2(kEdgeLength, 0.0f);
            DrawBar(draw, upper + start + b2Vec2(kGap, 0.0f), upper + end - b2Vec2(kGap, 0.0f),
                    kOrange);
            // By turns higher and lower, so that both are seen where they overlap.
            const b2Vec2 row(0.0f, i % 2 == 0 ? 0.0f : -0.5f * kBelow);
            DrawBar(draw, lower + row + start - b2Vec2(i > 0 ? kOverlap : 0.0f, 0.0f),
                    lower + row + end + b2Vec2(i + 1 < kEdgeCount ? kOverlap : 0.0f, 0.0f),
                    kSkyBlue);
        }
        ForEachMover(m_world, [&](const b2Body& body) {
            if (LostSpeed(body) < kSeen)
            {
                return;
            }
            const float32 way = body.GetLinearVelocity().x > 0.0f ? -1.0f : 1.0f;
            const b2Vec2 from = body.GetPosition() + b2Vec2(0.0f, 2.0f * kHalfSize);
            DrawArrow(draw, from, from + b2Vec2(way * kLossScale * LostSpeed(body), 0.0f),
                      IsOnUpperLane(body) ? kOrange : kSkyBlue);
        });
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
        Name(*m_lane, knowsNeighbours ? "edges with neighbours" : "edges alone");
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

    /// With a tick at both of its ends.
    static void DrawBar(b2Draw& draw, const b2Vec2& from, const b2Vec2& to, const b2Color& color)
    {
        const b2Vec2 tick(0.0f, 0.08f);
        draw.DrawSegment(from, to, color);
        draw.DrawSegment(from - tick, from + tick, color);
        draw.DrawSegment(to - tick, to + tick, color);
    }

    bool IsOnUpperLane(const b2Body& body) const
    {
        return body.GetPosition().y - m_lane->GetPosition().y > 0.5f * (kLanes[0] - kLanes[1]);
    }

    /// Returns the loss of speed since the start [m/s].
    static float32 LostSpeed(const b2Body& body)
    {
        return b2Max(kSpeed - b2Abs(body.GetLinearVelocity().x), 0.0f);
    }

    template <class World, class Do>
    static void ForEachMover(World& world, const Do& act)
    {
        for (auto* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            if (body->GetType() == b2_dynamicBody)
            {
                act(*body);
            }
        }
    }

    void Send(float32 direction)
    {
        ForEachMover(m_world, [direction](b2Body& body) {
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
