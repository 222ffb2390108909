// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// With sub-steps joints pass on the impulse of a bounce, so that jointed bodies keep as much
/// energy as one body of the same shape.
namespace
{

using namespace dynamics;

/// Kinetic energy, and that of the height [J].
double MechanicalEnergy(const b2World& world)
{
    double sum = 0.0;
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        const double mass = double(body->GetMass());
        const double inertia =
            double(body->GetInertia()) - mass * double(body->GetLocalCenter().LengthSquared());
        const double turning = double(body->GetAngularVelocity());
        sum += 0.5 * mass * double(body->GetLinearVelocity().LengthSquared()) +
               0.5 * inertia * turning * turning -
               mass * double(b2Dot(world.GetGravity(), body->GetWorldCenter()));
    }
    return sum;
}

/// How two balls are held together.
enum class Hold
{
    Shape, ///< they are one body
    Weld,
    Rod,
    LockedHinge,
    LockedSlider,
};

std::string NameOf(Hold hold)
{
    const char* names[] = {"one body", "weld", "rod", "locked hinge", "locked slider"};
    return names[int(hold)];
}

/// Two balls at the ends of a line of 2 m, above a floor without friction.
struct Pair : JointScene
{
    Pair(Hold hold, float32 angle, float32 restitution, int32 subSteps, bool falls)
        : JointScene(b2Vec2(0.0f, falls ? -kGravity : 0.0f))
    {
        world.SetSubStepCount(subSteps);
        world.SetRestitutionThreshold(0.01f);
        b2EdgeShape floor;
        floor.Set(b2Vec2(-500.0f, 0.0f), b2Vec2(500.0f, 0.0f));
        Add(Post(), floor, 0.0f, restitution);
        const b2Vec2 half(std::cos(angle), std::sin(angle));
        const b2Vec2 centre(0.0f, 3.0f);
        const b2Vec2 places[] = {centre - half, centre + half};
        b2Body* first = Body(b2_dynamicBody, places[0].x, places[0].y);
        AddBall(first, 0.3f, 0.0f, restitution);
        bodies.push_back(first);
        if (hold == Hold::Shape)
        {
            b2CircleShape other;
            other.m_radius = 0.3f;
            other.m_p = 2.0f * half;
            Add(first, other, 0.0f, restitution);
        }
        else
        {
            b2Body* second = Body(b2_dynamicBody, places[1].x, places[1].y);
            AddBall(second, 0.3f, 0.0f, restitution);
            bodies.push_back(second);
            Join(hold, *first, *second, half);
        }
        for (b2Body* body : bodies)
        {
            body->SetSleepingAllowed(false);
            body->SetLinearVelocity(b2Vec2(0.0f, falls ? 0.0f : -5.0f));
        }
    }

    void Join(Hold hold, b2Body& a, b2Body& b, const b2Vec2& axis)
    {
        const b2Vec2 middle = 0.5f * (a.GetPosition() + b.GetPosition());
        b2WeldJointDef weld;
        weld.Initialize(&a, &b, middle);
        b2DistanceJointDef rod;
        rod.Initialize(&a, &b, a.GetPosition(), b.GetPosition());
        b2RevoluteJointDef hinge;
        hinge.Initialize(&a, &b, middle);
        hinge.enableLimit = true;
        b2PrismaticJointDef slider;
        slider.Initialize(&a, &b, middle, axis);
        slider.enableLimit = true;
        switch (hold)
        {
        case Hold::Shape:
            break;
        case Hold::Weld:
            world.CreateJoint(&weld);
            break;
        case Hold::Rod:
            world.CreateJoint(&rod);
            break;
        case Hold::LockedHinge:
            world.CreateJoint(&hinge);
            break;
        case Hold::LockedSlider:
            world.CreateJoint(&slider);
            break;
        }
    }

    double Energy() const { return MechanicalEnergy(world); }

    std::vector<b2Body*> bodies;
};

class JointedBounce : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, JointedBounce, testing::Values(2, 4, 8));

constexpr Hold kJoints[] = {Hold::Weld, Hold::Rod, Hold::LockedHinge, Hold::LockedSlider};

/// The bounce of a ball took no notice of its joints, which then took back most of it: 13 to 50 %
/// of the energy was left with restitution 1. A rod does not turn its balls as one body would.
TEST_P(JointedBounce, KeepsTheEnergyThatOneBodyKeeps)
{
    for (const float32 restitution : {1.0f, 0.5f})
    {
        for (const float32 angle : {0.8f, 1.2f})
        {
            for (const bool continuous : {true, false})
            {
                const auto kept = [&](Hold hold) {
                    Pair pair(hold, angle, restitution, GetParam(), false);
                    pair.world.SetContinuousPhysics(continuous);
                    const double before = pair.Energy();
                    pair.Step(40);
                    return pair.Energy() / before;
                };
                const double expected = kept(Hold::Shape);
                for (const Hold hold : kJoints)
                {
                    EXPECT_NEAR(kept(hold), expected, hold == Hold::Rod ? 0.01 : 0.003)
                        << NameOf(hold) << " at " << angle << " rad, restitution " << restitution
                        << (continuous ? "" : ", without continuous collision");
                }
            }
        }
    }
}

/// What falls with its joints has at the time of an impact less speed than at the end of the step.
TEST_P(JointedBounce, NeitherGainsNorLosesEnergyInTenSeconds)
{
    for (const Hold hold : {Hold::Weld, Hold::Rod, Hold::LockedHinge})
    {
        Pair pair(hold, 0.7f, 1.0f, GetParam(), true);
        const double before = pair.Energy();
        for (int i = 0; i < 600; ++i)
        {
            pair.Step();
            EXPECT_LT(pair.Energy(), 1.005 * before) << NameOf(hold) << ", step " << i;
        }
        EXPECT_GT(pair.Energy(), 0.94 * before) << NameOf(hold);
    }
}

/// A pendulum that strikes a wall swings back: its hinge takes part.
TEST_P(JointedBounce, ThrowsBackAPendulum)
{
    JointScene scene;
    scene.world.SetSubStepCount(GetParam());
    b2Body* post = scene.Post(0.0f, 5.0f);
    b2EdgeShape wall;
    wall.Set(b2Vec2(-0.1f, -5.0f), b2Vec2(-0.1f, 5.0f));
    scene.Add(post, wall, 0.0f, 1.0f);
    b2Body* rod = scene.Body(b2_dynamicBody, 1.0f, 5.0f);
    scene.AddBox(rod, 1.0f, 0.1f, 0.0f, 1.0f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, rod, b2Vec2(0.0f, 5.0f));
    scene.world.CreateJoint(&hinge);
    const double before = MechanicalEnergy(scene.world);
    float32 highest = 0.0f;
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        EXPECT_LT(MechanicalEnergy(scene.world), before + 0.5) << i;
        highest = i > 60 ? b2Max(highest, rod->GetPosition().y) : 0.0f;
    }
    EXPECT_GT(highest, 4.8f); // of 5
}

/// The hinges of a cradle took back a third of its energy in 30 s.
TEST_P(JointedBounce, KeepsACradleOnHingesGoing)
{
    JointScene scene;
    scene.world.SetSubStepCount(GetParam());
    b2Body* post = scene.Post();
    std::vector<b2Body*> balls;
    for (int i = 0; i < 5; ++i)
    {
        const float32 x = 1.002f * float32(i);
        b2Body* ball = scene.Body(b2_dynamicBody, x, 3.0f);
        scene.AddBall(ball, 0.5f, 0.0f, 1.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(post, ball, b2Vec2(x, 9.0f));
        scene.world.CreateJoint(&hinge);
        balls.push_back(ball);
    }
    const double rest = MechanicalEnergy(scene.world);
    balls[0]->SetLinearVelocity(b2Vec2(-2.4f, 0.0f));
    balls[0]->SetAngularVelocity(-0.4f);
    const double before = MechanicalEnergy(scene.world) - rest;
    scene.Step(1800);
    EXPECT_NEAR(MechanicalEnergy(scene.world) - rest, before, 0.01 * before);
}

/// The impulse that a listener gets is that of the momentum.
TEST_P(JointedBounce, ReportsTheWholeImpulse)
{
    struct Sum : b2ContactListener
    {
        void PostSolve(b2Contact*, const b2ContactImpulse* impulse) override
        {
            sum += impulse->normalImpulses[0];
        }
        float32 sum = 0.0f;
    };
    for (const bool continuous : {true, false})
    {
        Pair pair(Hold::Weld, 1.2f, 1.0f, GetParam(), false);
        pair.world.SetContinuousPhysics(continuous);
        Sum sum;
        pair.world.SetContactListener(&sum);
        const auto momentum = [&] {
            float32 all = 0.0f;
            for (const b2Body* body : pair.bodies)
            {
                all += body->GetMass() * body->GetLinearVelocity().y;
            }
            return all;
        };
        const float32 before = momentum();
        pair.Step(40);
        EXPECT_NEAR(sum.sum, momentum() - before, 0.01f * sum.sum) << continuous;
    }
}

/// Friction of a bounce is at most its share of the impulse, and acts on all of the pair.
TEST_P(JointedBounce, RubsAsOneBodyDoes)
{
    const auto spinAfter = [&](Hold hold) {
        Pair pair(hold, 1.2f, 0.8f, GetParam(), false);
        for (b2Body* body = pair.world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            for (b2Fixture* f = body->GetFixtureList(); f != nullptr; f = f->GetNext())
            {
                f->SetFriction(0.5f);
            }
        }
        for (b2Body* body : pair.bodies)
        {
            body->SetLinearVelocity(b2Vec2(4.0f, -5.0f));
        }
        pair.Step(40);
        return pair.bodies[0]->GetAngularVelocity();
    };
    EXPECT_NEAR(spinAfter(Hold::Weld), spinAfter(Hold::Shape), 0.02f);
}

/// A torso with two arms and two legs of two parts each, on hinges with limits.
void AddRagdoll(JointScene& scene, float32 x, float32 y, const b2Vec2& v,
                std::vector<b2Joint*>& hinges)
{
    const auto part = [&](float32 px, float32 py, float32 hx, float32 hy) {
        b2Body* body = scene.Load(x + px, y + py, hx, hy);
        body->GetFixtureList()->SetRestitution(0.95f);
        body->GetFixtureList()->SetFriction(0.0f);
        body->SetLinearVelocity(v);
        return body;
    };
    const auto join = [&](b2Body* a, b2Body* b, float32 px, float32 py) {
        b2RevoluteJointDef def;
        def.Initialize(a, b, b2Vec2(x + px, y + py));
        def.enableLimit = true;
        def.lowerAngle = -1.0f;
        def.upperAngle = 1.0f;
        hinges.push_back(scene.world.CreateJoint(&def));
    };
    b2Body* torso = part(0.0f, 0.0f, 0.25f, 0.5f);
    for (const float32 side : {-1.0f, 1.0f})
    {
        b2Body* arm = part(0.45f * side, 0.4f, 0.2f, 0.1f);
        b2Body* hand = part(0.85f * side, 0.4f, 0.2f, 0.08f);
        b2Body* thigh = part(0.15f * side, -0.8f, 0.1f, 0.3f);
        b2Body* foot = part(0.15f * side, -1.4f, 0.08f, 0.3f);
        join(torso, arm, 0.27f * side, 0.4f);
        join(arm, hand, 0.65f * side, 0.4f);
        join(torso, thigh, 0.15f * side, -0.5f);
        join(thigh, foot, 0.15f * side, -1.1f);
    }
}

/// Bodies that joints connect with one that bounces were moved on straight: hinges opened by up to
/// 4 m, and all stopped.
TEST_P(JointedBounce, LeavesElasticRagdollsWhole)
{
    for (int trial = 0; trial < 8; ++trial)
    {
        JointScene scene;
        scene.world.SetSubStepCount(GetParam());
        b2ChainShape room;
        b2Vec2 corners[] = {b2Vec2(-5.0f, 0.0f), b2Vec2(-5.0f, 10.0f), b2Vec2(5.0f, 10.0f),
                            b2Vec2(5.0f, 0.0f)};
        room.CreateLoop(corners, 4);
        scene.Add(scene.Post(), room, 0.0f, 0.95f);
        std::vector<b2Joint*> hinges;
        for (int i = 0; i < 3; ++i)
        {
            const b2Vec2 v(float32((trial * 7 + i * 5) % 17 - 8),
                           float32((trial * 5 + i) % 17 - 8));
            AddRagdoll(scene, -3.0f + 3.0f * float32(i), 4.0f, v, hinges);
        }
        for (int i = 0; i < 300; ++i)
        {
            scene.Step();
            for (const b2Joint* hinge : hinges)
            {
                ASSERT_LT(b2Distance(hinge->GetAnchorA(), hinge->GetAnchorB()), 0.02f)
                    << "trial " << trial << ", step " << i;
            }
        }
    }
}

/// Beyond the bound of the cost bounces ignore joints.
TEST_P(JointedBounce, LeavesLongChainsWhole)
{
    JointScene scene;
    scene.world.SetSubStepCount(GetParam());
    b2EdgeShape floor;
    floor.Set(b2Vec2(-500.0f, 0.0f), b2Vec2(500.0f, 0.0f));
    scene.Add(scene.Post(), floor, 0.2f, 0.5f);
    b2Body* last = nullptr;
    for (int i = 0; i < 100; ++i)
    {
        b2Body* link = scene.Body(b2_dynamicBody, 0.5f * float32(i), 3.0f);
        b2Fixture* f = scene.AddBox(link, 0.25f, 0.06f, 0.2f, 0.5f);
        b2Filter filter;
        filter.groupIndex = -1;
        f->SetFilterData(filter);
        if (last != nullptr)
        {
            b2RevoluteJointDef hinge;
            hinge.Initialize(last, link, b2Vec2(0.5f * float32(i) - 0.25f, 3.0f));
            scene.world.CreateJoint(&hinge);
        }
        last = link;
    }
    for (int i = 0; i < 200; ++i)
    {
        scene.Step();
        EXPECT_EQ(WhyBroken(scene.world, true), "") << "step " << i;
    }
}

} // namespace
