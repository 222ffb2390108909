// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Box2D/Collision/b2TimeOfImpact.h>
#include <Dynamics/Contacts/Sweeps.h>
#include <Dynamics/State/Access.h>
#include <Dynamics/State/World.h>

#include <gtest/gtest.h>

#include <memory>
#include <random>

/// Pairs that the cheap sweep tests exclude have no time of impact.
namespace
{

using namespace box2d;
using dynamics::Scene;

class RandomWays
{
public:
    explicit RandomWays(unsigned seed) : m_random(seed) {}

    float32 operator()(float32 low, float32 high)
    {
        return low + (high - low) * float32(m_random() % 100001u) / 100000.0f;
    }

    /// From small to a hundred times as large, flat or round, not always about the origin.
    std::unique_ptr<b2Shape> Shape()
    {
        auto& self = *this;
        const float32 size = std::pow(10.0f, self(-1.0f, 1.0f));
        switch (m_random() % 4)
        {
        case 0: {
            auto circle = std::make_unique<b2CircleShape>();
            circle->m_radius = size * self(0.0f, 0.5f);
            circle->m_p = m_random() % 2 == 0 ? b2Vec2_zero : b2Vec2(self(-size, size), 0.0f);
            return circle;
        }
        case 1: {
            auto polygon = std::make_unique<b2PolygonShape>();
            polygon->SetAsBox(size * self(0.01f, 1.0f), size * self(0.01f, 1.0f),
                              b2Vec2(self(-size, size), self(-size, size)), self(-3.0f, 3.0f));
            return polygon;
        }
        case 2: {
            auto edge = std::make_unique<b2EdgeShape>();
            edge->Set(b2Vec2(-size, 0.0f), b2Vec2(self(0.0f, size), self(-size, size)));
            return edge;
        }
        default: {
            const b2Vec2 corners[] = {b2Vec2(-size, size), b2Vec2(0.0f, self(-size, 0.0f)),
                                      b2Vec2(size, size)};
            auto chain = std::make_unique<b2ChainShape>();
            chain->CreateChain(corners, 3);
            return chain;
        }
        }
    }

    /// A way of a body around `place`, now and then none at all, or a turn in place.
    void Move(BodyData& body, double place)
    {
        auto& self = *this;
        const float32 reach = std::pow(10.0f, self(-1.0f, 1.3f));
        const float32 far = m_random() % 5 == 0 ? 0.0f : std::pow(10.0f, self(-3.0f, 1.3f));
        const float32 turn = m_random() % 2 == 0 ? 0.0f : self(-1.5f, 1.5f);
        body.previous =
            Pose{place + self(-reach, reach), place + self(-reach, reach), self(-7.0f, 7.0f)};
        body.pose = Pose{body.previous.x + self(-far, far), body.previous.y + self(-far, far),
                         body.previous.angle + turn};
        SynchronizePose(body);
    }

    std::mt19937& Engine() { return m_random; }

private:
    std::mt19937 m_random;
};

/// A body of a world with one shape, to be moved by hand.
BodyData& Make(Scene& scene, const b2Shape& shape)
{
    b2Body* body = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
    body->CreateFixture(&shape, 1.0f);
    return Data(*body);
}

TEST(Sweeps, ExcludeOnlyPairsWithoutATimeOfImpact)
{
    RandomWays random(71);
    int front = 0;
    int circles = 0;
    int touching = 0;
    for (int i = 0; i < 20000; ++i)
    {
        Scene scene;
        const std::unique_ptr<b2Shape> shapeA = random.Shape();
        const std::unique_ptr<b2Shape> shapeB = random.Shape();
        BodyData& a = Make(scene, *shapeA);
        BodyData& b = Make(scene, *shapeB);
        const double place = i % 4 == 0 ? 1.0e7 : 0.0;
        random.Move(a, place);
        random.Move(b, place);
        const bool isFront = StaysInFront(a, a.previous, *shapeA, 0, b, b.previous);
        const bool isApart = !CirclesMeet(a, a.previous, b, b.previous);

        b2TOIInput input;
        input.sweepA = SweepFrom(a, a.previous, a.previous);
        input.sweepB = SweepFrom(b, b.previous, a.previous);
        input.proxyA.Set(shapeA.get(), 0);
        input.proxyB.Set(shapeB.get(), 0);
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        if (isFront || isApart)
        {
            ASSERT_EQ(output.state, b2TOIOutput::e_separated) << i << (isFront ? " front" : "");
        }
        front += isFront;
        circles += isApart;
        touching += output.state == b2TOIOutput::e_touching;
    }
    EXPECT_GT(front, 2000);
    EXPECT_GT(circles, 2000);
    EXPECT_GT(touching, 1000);
}

TEST(Sweeps, HandleNearMissesAndGrazingHits)
{
    // A small box beside a long wall that turns or not, ever closer: the answers change from apart
    // to not sure before there is a time of impact.
    for (const double turn : {0.0, 0.01, -0.3})
    {
        Scene scene;
        b2PolygonShape wall;
        wall.SetAsBox(10.0f, 0.5f);
        b2PolygonShape box;
        box.SetAsBox(0.1f, 0.1f);
        BodyData& a = Make(scene, wall);
        BodyData& b = Make(scene, box);
        a.pose.angle = turn;
        SynchronizePose(a);
        int apart = 0;
        for (int i = 0; i < 400; ++i)
        {
            b.previous = Pose{3.0, 4.0 - 0.01 * i, 0.0};
            b.pose = Pose{3.0, b.previous.y - 0.05, 0.5};
            SynchronizePose(b);
            b2TOIInput input;
            input.sweepA = SweepFrom(a, a.previous, a.previous);
            input.sweepB = SweepFrom(b, b.previous, a.previous);
            input.proxyA.Set(&wall, 0);
            input.proxyB.Set(&box, 0);
            b2TOIOutput output;
            b2TimeOfImpact(&output, &input);
            const bool isFront = StaysInFront(a, a.previous, wall, 0, b, b.previous);
            ASSERT_FALSE(isFront && output.state != b2TOIOutput::e_separated) << turn << " " << i;
            apart += isFront;
        }
        EXPECT_GT(apart, 100) << turn;
        EXPECT_LT(apart, 340) << turn;
    }
}

TEST(CircleImpact, EqualsTheResultOfTheSearch)
{
    RandomWays random(73);
    int touching = 0;
    int missing = 0;
    int atOnce = 0;
    for (int i = 0; i < 20000; ++i)
    {
        Scene scene;
        b2CircleShape shapes[2];
        BodyData* bodies[2];
        for (int k = 0; k < 2; ++k)
        {
            shapes[k].m_radius = std::pow(10.0f, random(-3.0f, 0.5f));
            shapes[k].m_p = i % 3 == 0 ? b2Vec2(random(-1.0f, 1.0f), 0.3f) : b2Vec2_zero;
            bodies[k] = &Make(scene, shapes[k]);
            random.Move(*bodies[k], i % 4 == 0 ? 1.0e7 : 0.0);
            ASSERT_TRUE(IsRoundAbout(*bodies[k], shapes[k]));
        }
        const BodyData& a = *bodies[0];
        const BodyData& b = *bodies[1];
        const float32 radii = shapes[0].m_radius + shapes[1].m_radius;
        const float32 t = CircleImpact(a, a.previous, b, b.previous, radii);

        b2TOIInput input;
        input.sweepA = SweepFrom(a, a.previous, a.previous);
        input.sweepB = SweepFrom(b, b.previous, a.previous);
        input.proxyA.Set(&shapes[0], 0);
        input.proxyB.Set(&shapes[1], 0);
        b2TOIOutput output;
        b2TimeOfImpact(&output, &input);
        const double wx = (b.pose.x - b.previous.x) - (a.pose.x - a.previous.x);
        const double wy = (b.pose.y - b.previous.y) - (a.pose.y - a.previous.y);
        const auto distanceAt = [&](double time) {
            return std::hypot(b.previous.x - a.previous.x + time * wx,
                              b.previous.y - a.previous.y + time * wy);
        };
        // The search ends anywhere between the target and a quarter of the slop above.
        const double target = b2Max(b2_linearSlop, radii - 3.0f * b2_linearSlop);
        const double maximum = target + 0.25 * double(b2_linearSlop);
        const double rounding = 1e-5 * (1.0 + std::hypot(wx, wy));
        if (output.state == b2TOIOutput::e_touching && output.t < 1.0f)
        {
            ASSERT_LE(t, output.t + 1e-6f) << i;
            ASSERT_TRUE(t == 0.0f || std::abs(distanceAt(double(t)) - maximum) < rounding) << i;
            ++touching;
            atOnce += t == 0.0f;
        }
        else
        {
            // Pairs that the search lets pass do not come nearer than its target distance.
            ASSERT_TRUE(t == 1.0f || distanceAt(double(t)) > target - rounding) << i;
            missing += t == 1.0f;
        }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_GT(atOnce, 100);
    EXPECT_GT(missing, 5000);
}

TEST(SweptBox, EqualsTheBoxOfBothTransformsForACircle)
{
    RandomWays random(72);
    for (int i = 0; i < 2000; ++i)
    {
        Scene scene;
        b2CircleShape circle;
        circle.m_radius = random(0.0f, 3.0f);
        BodyData& body = Make(scene, circle);
        body.localCenter = i % 2 == 0 ? b2Vec2_zero : b2Vec2(random(-1.0f, 1.0f), 0.5f);
        random.Move(body, i % 4 == 0 ? 1.0e7 : 0.0);
        const b2Sweep sweep = SweepFrom(body, body.previous, Pose());
        b2Transform from;
        b2Transform to;
        sweep.GetTransform(&from, 0.0f);
        sweep.GetTransform(&to, 1.0f);
        b2AABB start;
        b2AABB expected;
        circle.ComputeAABB(&start, from, 0);
        circle.ComputeAABB(&expected, to, 0);
        expected.Combine(start);
        const b2AABB box = SweptBox(circle, 0, sweep, circle.m_radius);
        ASSERT_EQ(box.lowerBound, expected.lowerBound) << i;
        ASSERT_EQ(box.upperBound, expected.upperBound) << i;
    }
}

/// A rod that is level at the start and at the end has been upright between.
TEST(SweptBox, ContainsWideRotationAtEveryTime)
{
    b2PolygonShape rod;
    rod.SetAsBox(1.0f, 0.1f);
    b2Sweep sweep;
    sweep.localCenter.SetZero();
    sweep.c0.SetZero();
    sweep.c.Set(0.5f, 0.0f);
    sweep.a0 = 0.0f;
    sweep.a = 4.0f * b2_pi;
    sweep.alpha0 = 0.0f;
    const b2AABB box = SweptBox(rod, 0, sweep, b2Vec2(1.0f, 0.1f).Length() + b2_polygonRadius);
    for (int i = 0; i <= 100; ++i)
    {
        b2Transform at;
        sweep.GetTransform(&at, 0.01f * float32(i));
        b2AABB now;
        rod.ComputeAABB(&now, at, 0);
        now.lowerBound += b2Vec2(b2_polygonRadius, b2_polygonRadius); // both stand out by a skin
        now.upperBound -= b2Vec2(b2_polygonRadius, b2_polygonRadius);
        ASSERT_TRUE(box.Contains(now)) << i;
    }
}

} // namespace
