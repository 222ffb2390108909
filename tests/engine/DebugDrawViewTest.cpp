// SPDX-License-Identifier: MIT
// The items that b2Draw::SetView omits, and those that it must not.
#include "DynamicsScene.h"
#include "MixedWorld.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace
{

using dynamics::Scene;

struct Call
{
    uint32 layer;
    int32 body;
    int kind;
    std::vector<b2Vec2> points;
    float32 radius;
    b2Color color;

    bool operator==(const Call& other) const
    {
        return layer == other.layer && body == other.body && kind == other.kind &&
               std::equal(points.begin(), points.end(), other.points.begin(), other.points.end()) &&
               radius == other.radius && color.r == other.color.r && color.g == other.color.g &&
               color.b == other.color.b;
    }
    b2AABB Box() const
    {
        b2AABB box;
        box.lowerBound = box.upperBound = points[0];
        for (const b2Vec2& p : points)
        {
            box.lowerBound = b2Min(box.lowerBound, p);
            box.upperBound = b2Max(box.upperBound, p);
        }
        box.lowerBound -= b2Vec2(radius, radius);
        box.upperBound += b2Vec2(radius, radius);
        return box;
    }
};

class CallRecorder : public b2Draw
{
public:
    std::vector<Call> calls;
    std::vector<int32> bodies; // as they begin

    void DrawPolygon(const b2Vec2* v, int32 n, const b2Color& c) override { Add(0, v, n, 0, c); }
    void DrawSolidPolygon(const b2Vec2* v, int32 n, const b2Color& c) override
    {
        Add(1, v, n, 0, c);
    }
    void DrawCircle(const b2Vec2& p, float32 r, const b2Color& c) override { Add(2, &p, 1, r, c); }
    void DrawSolidCircle(const b2Vec2& p, float32 r, const b2Vec2&, const b2Color& c) override
    {
        Add(3, &p, 1, r, c);
    }
    void DrawSegment(const b2Vec2& a, const b2Vec2& b, const b2Color& c) override
    {
        const b2Vec2 both[2] = {a, b};
        Add(4, both, 2, 0, c);
    }
    void DrawTransform(const b2Transform& xf) override { Add(5, &xf.p, 1, 0, b2Color()); }
    void BeginLayer(uint32 flag) override { m_layer = flag; }
    void BeginBody(int32 number) override
    {
        m_body = number;
        bodies.push_back(number);
    }

private:
    void Add(int kind, const b2Vec2* v, int32 count, float32 radius, const b2Color& color)
    {
        calls.push_back({m_layer, m_body, kind, {v, v + count}, radius, color});
    }
    uint32 m_layer = 0;
    int32 m_body = -1;
};

constexpr uint32 kEverything = 0x1f;

b2AABB Box(float32 x0, float32 y0, float32 x1, float32 y1)
{
    b2AABB box;
    box.lowerBound.Set(x0, y0);
    box.upperBound.Set(x1, y1);
    return box;
}

CallRecorder Drawn(b2World& world, const b2AABB* view, uint32 flags = kEverything)
{
    CallRecorder draw;
    draw.SetFlags(flags);
    if (view != nullptr)
    {
        draw.SetView(view->lowerBound, view->upperBound);
    }
    world.SetDebugDraw(&draw);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
    return draw;
}

/// By more than a broad-phase box is larger than the shape of a body that has not moved.
b2AABB Grown(b2AABB box)
{
    box.lowerBound -= b2Vec2(0.2f, 0.2f);
    box.upperBound += b2Vec2(0.2f, 0.2f);
    return box;
}

} // namespace

TEST(DebugDrawView, DrawsAllThatLiesInItInTheSameOrder)
{
    int seen = 0;
    int all = 0;
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        MixedWorld mixed(seed);
        const std::vector<Call> whole = Drawn(mixed.world, nullptr).calls;
        for (int i = 0; i < 10; ++i)
        {
            const b2Vec2 middle = mixed.Place();
            const b2Vec2 half(mixed.Between(0.1f, 15.0f), mixed.Between(0.1f, 15.0f));
            b2AABB view;
            view.lowerBound = middle - half;
            view.upperBound = middle + half;
            const std::vector<Call> part = Drawn(mixed.world, &view).calls;
            auto next = part.begin();
            for (const Call& call : whole)
            {
                if (next != part.end() && *next == call)
                {
                    EXPECT_TRUE(mixed.steps > 0 || b2TestOverlap(Grown(call.Box()), view))
                        << "seed " << seed << ": far outside";
                    ++next;
                }
                else
                {
                    ASSERT_FALSE(b2TestOverlap(call.Box(), view)) << "seed " << seed;
                }
            }
            ASSERT_EQ(next, part.end()) << "seed " << seed << ": in another order, or made up";
            seen += int(part.size());
            all += int(whole.size());
        }
    }
    EXPECT_GT(seen, 5000);
    EXPECT_LT(4 * seen, all);
}

TEST(DebugDrawView, DrawsOnlyTheChildrenOfAChainInView)
{
    Scene scene;
    std::vector<b2Vec2> points;
    for (int i = 0; i <= 1000; ++i)
    {
        points.push_back(b2Vec2(float32(i), 0.0f));
    }
    b2ChainShape chain;
    chain.CreateChain(points.data(), int32(points.size()));
    Scene::Add(scene.Body(b2_staticBody, 0.0f, 0.0f), chain, 0.2f, 0.0f);
    const b2AABB view = Box(500.5f, -1.0f, 502.5f, 1.0f);
    EXPECT_EQ(Drawn(scene.world, &view, b2Draw::e_shapeBit).calls.size(), 3u);
    EXPECT_EQ(Drawn(scene.world, nullptr, b2Draw::e_shapeBit).calls.size(), 1000u);
}

TEST(DebugDrawView, DrawsInactiveBodiesInView)
{
    Scene scene;
    b2Body* body = scene.Box(0.0f, 0.0f);
    scene.Box(50.0f, 0.0f)->SetActive(false);
    const b2AABB view = Box(-1.0f, -1.0f, 1.0f, 1.0f);
    const auto count = [&] { return Drawn(scene.world, &view, b2Draw::e_shapeBit).calls.size(); };
    EXPECT_EQ(count(), 1u);
    body->SetActive(false);
    EXPECT_EQ(count(), 1u);
    EXPECT_EQ(Drawn(scene.world, &view, b2Draw::e_aabbBit).calls.size(), 0u) << "it has no box";
    scene.world.DestroyBody(body);
    EXPECT_EQ(count(), 0u);
    b2BodyDef asleep;
    asleep.active = false;
    Scene::AddBox(scene.world.CreateBody(&asleep), 0.5f, 0.5f);
    EXPECT_EQ(count(), 1u);
}

TEST(DebugDrawView, BeginsOnlyBodiesInView)
{
    Scene scene;
    scene.Box(50.0f, 0.0f);
    scene.Box(0.0f, 0.0f);
    scene.Box(-50.0f, 0.0f);
    const b2AABB view = Box(-1.0f, -1.0f, 1.0f, 1.0f);
    EXPECT_THAT(Drawn(scene.world, &view, b2Draw::e_shapeBit).bodies, testing::ElementsAre(1, -1));
    EXPECT_THAT(Drawn(scene.world, &view, b2Draw::e_centerOfMassBit).bodies,
                testing::ElementsAre(1, -1));
}

TEST(DebugDrawView, HidesNothingWhenCleared)
{
    Scene scene;
    scene.Box(50.0f, 0.0f);
    CallRecorder draw;
    draw.SetFlags(b2Draw::e_shapeBit);
    draw.SetView(b2Vec2(0.0f, 0.0f), b2Vec2(1.0f, 1.0f));
    EXPECT_TRUE(draw.HasView());
    scene.world.SetDebugDraw(&draw);
    scene.world.DrawDebugData();
    EXPECT_EQ(draw.calls.size(), 0u);
    draw.ClearView();
    scene.world.DrawDebugData();
    EXPECT_EQ(draw.calls.size(), 1u);
    scene.world.SetDebugDraw(nullptr);
}

TEST(DebugDrawView, ReportsTheNumberOfABody)
{
    Scene scene;
    scene.world.DestroyBody(scene.Box(0.0f, 0.0f));
    EXPECT_EQ(scene.Box(0.0f, 0.0f)->GetNumber(), 1) << "none is used again";
    EXPECT_THAT(Drawn(scene.world, nullptr, b2Draw::e_shapeBit).bodies,
                testing::ElementsAre(1, -1));
}
