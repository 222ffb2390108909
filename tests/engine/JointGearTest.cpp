// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <set>

/// Gears: q1 + ratio * q2 is constant, where q is an angle or a translation.
namespace
{

using namespace dynamics;

/// Two bodies without weight on two posts, each on a hinge or a slider along x, geared.
struct Gearing : JointScene
{
    Gearing(bool firstSlides, bool secondSlides, float32 ratio) : JointScene(b2Vec2(0.0f, 0.0f))
    {
        world.SetDestructionListener(&listener);
        Make(0, firstSlides);
        Make(1, secondSlides);
        b2GearJointDef def;
        def.bodyA = bodies[0];
        def.bodyB = bodies[1];
        def.joint1 = joints[0];
        def.joint2 = joints[1];
        def.ratio = ratio;
        gear = Create<b2GearJoint>(def);
    }
    ~Gearing() { world.SetDestructionListener(nullptr); }

    void Make(int i, bool slides)
    {
        const float32 x = 10.0f * float32(i);
        posts[i] = Post(x, 0.0f);
        bodies[i] = Ball(x, 0.0f, 1.0f);
        bodies[i]->SetSleepingAllowed(false);
        isSlider[i] = slides;
        if (slides)
        {
            b2PrismaticJointDef def;
            def.Initialize(posts[i], bodies[i], posts[i]->GetPosition(), b2Vec2(1.0f, 0.0f));
            joints[i] = world.CreateJoint(&def);
        }
        else
        {
            b2RevoluteJointDef def;
            def.Initialize(posts[i], bodies[i], posts[i]->GetPosition());
            joints[i] = world.CreateJoint(&def);
        }
    }

    float32 Coordinate(int i) const
    {
        return isSlider[i] ? bodies[i]->GetPosition().x - posts[i]->GetPosition().x
                           : bodies[i]->GetAngle();
    }
    float32 Rate(int i) const
    {
        return isSlider[i] ? bodies[i]->GetLinearVelocity().x : bodies[i]->GetAngularVelocity();
    }
    float32 Inertia(int i) const
    {
        return isSlider[i] ? bodies[i]->GetMass() : bodies[i]->GetInertia();
    }
    void Push(int i, float32 effort)
    {
        if (isSlider[i])
        {
            bodies[i]->ApplyForceToCenter(b2Vec2(effort, 0.0f));
        }
        else
        {
            bodies[i]->ApplyTorque(effort);
        }
    }

    struct Listener : b2DestructionListener
    {
        void SayGoodbye(b2Joint* joint) override { gone.insert(joint); }
        using b2DestructionListener::SayGoodbye;
        std::set<b2Joint*> gone;
    };
    Listener listener;
    b2Body* posts[2];
    b2Body* bodies[2];
    b2Joint* joints[2];
    bool isSlider[2];
    b2GearJoint* gear;
};

class GearJoint : public testing::TestWithParam<std::tuple<bool, bool, float32>>
{
protected:
    Gearing g{std::get<0>(GetParam()), std::get<1>(GetParam()), std::get<2>(GetParam())};
    float32 ratio = std::get<2>(GetParam());
};

TEST_P(GearJoint, KeepsTheSumOfItsCoordinates)
{
    for (int i = 0; i < 300; ++i)
    {
        g.Push(0, 20.0f * g.Random());
        g.Push(1, 20.0f * g.Random());
        g.Step();
        ASSERT_NEAR(g.Coordinate(0) + ratio * g.Coordinate(1), 0.0f, b2_linearSlop) << i;
        ASSERT_EQ(WhyBroken(g.world, true), "");
    }
    EXPECT_GT(b2Abs(g.Coordinate(0)), 0.1f) << "it does move";
}

// alpha1 = effort / (I1 + I2 / ratio^2), for body 2 turns 1 / ratio times as fast.
TEST_P(GearJoint, AddsTheInertiaOfTheDrivenSide)
{
    const float32 inertia = g.Inertia(0) + g.Inertia(1) / (ratio * ratio);
    for (int i = 0; i < 30; ++i)
    {
        g.Push(0, 3.0f);
        g.Step();
    }
    EXPECT_NEAR(g.Rate(0), 0.5f * 3.0f / inertia, 1e-3f);
    EXPECT_NEAR(g.Rate(1), -g.Rate(0) / ratio, 1e-3f);
}

TEST_P(GearJoint, BalancesEffortsInItsRatio)
{
    for (int i = 0; i < 120; ++i)
    {
        g.Push(0, 3.0f);
        g.Push(1, 3.0f * ratio);
        g.Step();
    }
    EXPECT_NEAR(g.Coordinate(0), 0.0f, 1e-3f);
    EXPECT_NEAR(g.Coordinate(1), 0.0f, 1e-3f);
    // The force of the gear on body B opposes the one that pushes it.
    const float32 effort = g.isSlider[1] ? g.gear->GetReactionForce(1.0f / kStep).x
                                         : g.gear->GetReactionTorque(1.0f / kStep);
    EXPECT_NEAR(effort, -3.0f * ratio, 0.01f);
}

INSTANTIATE_TEST_SUITE_P(Pairings, GearJoint,
                         testing::Combine(testing::Bool(), testing::Bool(),
                                          testing::Values(1.0f, 2.5f, -0.5f, -3.0f)));

TEST(GearJoints, UseANewRatioFromTheNextStep)
{
    Gearing g(false, false, 1.0f);
    g.gear->SetRatio(-2.0f);
    EXPECT_EQ(g.gear->GetRatio(), -2.0f);
    EXPECT_EQ(g.gear->GetJoint1(), g.joints[0]);
    EXPECT_EQ(g.gear->GetJoint2(), g.joints[1]);
    g.Push(0, 50.0f);
    g.Step(10);
    EXPECT_NEAR(g.Rate(0), 2.0f * g.Rate(1), 1e-3f);
}

// A gear is destroyed with any of its joints or bodies, and the listener is notified.
TEST(GearJoints, AreDestroyedWithTheirJointsAndBodies)
{
    for (int what = 0; what < 6; ++what)
    {
        Gearing g(what % 2 == 0, what < 3, 1.5f);
        g.Push(0, 10.0f);
        g.Step(5);
        const b2Joint* gear = g.gear;
        switch (what)
        {
        case 0:
        case 1:
            g.world.DestroyJoint(g.joints[what]);
            break;
        case 2:
        case 3:
            g.world.DestroyBody(g.posts[what - 2]);
            break;
        default:
            g.world.DestroyBody(g.bodies[what - 4]);
            break;
        }
        EXPECT_EQ(g.listener.gone.count(const_cast<b2Joint*>(gear)), 1u) << what;
        EXPECT_EQ(g.world.GetJointCount(), 1) << what;
        EXPECT_EQ(WhyBroken(g.world, false), "") << what;
        g.Step(5);
        EXPECT_EQ(WhyBroken(g.world, true), "") << what;
    }
}

TEST(GearJoints, AreNotReportedWhenDestroyedByTheUser)
{
    Gearing g(false, false, 1.0f);
    g.world.DestroyJoint(g.gear);
    EXPECT_TRUE(g.listener.gone.empty());
    EXPECT_EQ(g.world.GetJointCount(), 2);
    g.Push(0, 50.0f);
    g.Step(10);
    EXPECT_EQ(g.Rate(1), 0.0f) << "nothing is geared any more";
}

/// Two wheels on hinges that were made the other way round: the ground is the second body.
TEST(GearJoint, TakesAnyBodiesOfItsJoints)
{
    for (const bool carried : {false, true})
    {
        JointScene scene(b2Vec2(0.0f, 0.0f));
        b2Body* carrier = carried ? scene.Load(0.0f, 0.0f, 4.0f, 0.25f) : scene.Post();
        b2Body* a = scene.Load(-2.0f, 2.0f);
        b2Body* b = scene.Load(2.0f, 2.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(a, carrier, a->GetPosition());
        auto* hingeA = scene.Create<b2RevoluteJoint>(hinge);
        hinge.Initialize(b, carrier, b->GetPosition());
        auto* hingeB = scene.Create<b2RevoluteJoint>(hinge);
        b2GearJointDef def;
        def.bodyA = a;
        def.bodyB = b;
        def.joint1 = hingeA;
        def.joint2 = hingeB;
        def.ratio = 2.0f;
        auto* gear = scene.Create<b2GearJoint>(def);
        ASSERT_NE(gear, nullptr);
        EXPECT_EQ(gear->GetBodyA(), a);
        EXPECT_EQ(gear->GetBodyB(), b);
        a->SetAngularVelocity(4.0f);
        for (int i = 0; i < 120; ++i)
        {
            scene.Step();
            EXPECT_NEAR(hingeA->GetJointAngle() + 2.0f * hingeB->GetJointAngle(), 0.0f, 0.01f);
        }
        EXPECT_GT(b2Abs(hingeB->GetJointAngle()), 0.2f);
        scene.world.DestroyJoint(hingeA);
        EXPECT_EQ(scene.world.GetJointCount(), 1) << "the gear went with it";
    }
}

TEST(GearJoint, KeepsTheAngularMomentumOfACarrier)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* carrier = scene.Load(0.0f, 0.0f, 4.0f, 0.25f);
    b2Body* wheels[2];
    b2RevoluteJoint* hinges[2];
    for (int i = 0; i < 2; ++i)
    {
        wheels[i] = scene.Load(float32(4 * i - 2), 0.0f, 0.5f, 0.5f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(carrier, wheels[i], wheels[i]->GetPosition());
        hinges[i] = scene.Create<b2RevoluteJoint>(hinge);
    }
    b2GearJointDef def;
    def.bodyA = wheels[0];
    def.bodyB = wheels[1];
    def.joint1 = hinges[0];
    def.joint2 = hinges[1];
    scene.Create<b2GearJoint>(def);
    wheels[0]->ApplyAngularImpulse(3.0f);
    scene.Step(5);
    float32 momentum = 0.0f;
    for (const b2Body* body : {carrier, wheels[0], wheels[1]})
    {
        momentum += body->GetInertia() * body->GetAngularVelocity() +
                    body->GetMass() * b2Cross(body->GetPosition(), body->GetLinearVelocity());
    }
    EXPECT_NEAR(momentum, 3.0f, 0.02f);
    EXPECT_NEAR(hinges[0]->GetJointSpeed() + hinges[1]->GetJointSpeed(), 0.0f, 1e-3f);
}

/// A wheel that an arm carries round a fixed one; both wheels are geared and meet.
struct Planetary : JointScene
{
    explicit Planetary(bool armFirst) : JointScene(b2Vec2(0.0f, 0.0f))
    {
        sun = Post();
        AddBall(sun, 1.0f);
        planet = Ball(2.0f, 0.0f, 1.0f);
        arm = Load(1.0f, 0.0f, 1.0f, 0.1f);
        arm->GetFixtureList()->SetSensor(true);
        b2RevoluteJointDef hinge;
        b2Body* const pair[2][2] = {{sun, arm}, {planet, arm}};
        b2Joint* joints[2];
        for (int i = 0; i < 2; ++i)
        {
            hinge.Initialize(pair[i][armFirst], pair[i][!armFirst], pair[i][0]->GetPosition());
            joints[i] = world.CreateJoint(&hinge);
        }
        b2GearJointDef def;
        def.bodyA = sun;
        def.bodyB = planet;
        def.joint1 = joints[0];
        def.joint2 = joints[1];
        gear = Create<b2GearJoint>(def);
    }

    b2Body* sun;
    b2Body* planet;
    b2Body* arm;
    b2GearJoint* gear;
};

TEST(GearJoint, ConnectsTheBodiesOfItsDefinition)
{
    for (const bool armFirst : {false, true})
    {
        Planetary scene(armFirst);
        ASSERT_NE(scene.gear, nullptr);
        EXPECT_EQ(scene.gear->GetBodyA(), scene.sun);
        EXPECT_EQ(scene.gear->GetBodyB(), scene.planet);
        scene.planet->SetAngularVelocity(2.0f);
        for (int i = 0; i < 60; ++i)
        {
            scene.Step();
            ASSERT_EQ(scene.world.GetContactCount(), 0) << "wheels of a gear do not collide";
        }
    }
}

/// Two wheels that turn on two frames; all may move.
TEST(GearJoint, TakesBodiesNamedInAnyOrder)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* frames[2];
    b2Body* wheels[2];
    b2Joint* joints[2];
    for (int i = 0; i < 2; ++i)
    {
        frames[i] = scene.Load(4.0f * float32(i), 1.0f);
        wheels[i] = scene.Ball(4.0f * float32(i), 0.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(frames[i], wheels[i], wheels[i]->GetPosition());
        joints[i] = scene.world.CreateJoint(&hinge);
    }
    const struct
    {
        b2Body *namedA, *namedB, *takenA, *takenB;
    } cases[] = {{frames[0], wheels[1], frames[0], wheels[1]},
                 {wheels[1], frames[0], frames[0], wheels[1]},
                 {frames[1], frames[0], frames[0], frames[1]},
                 {wheels[0], frames[0], wheels[0], wheels[1]},
                 {frames[1], wheels[1], wheels[0], wheels[1]}};
    for (const auto& c : cases)
    {
        b2GearJointDef def;
        def.bodyA = c.namedA;
        def.bodyB = c.namedB;
        def.joint1 = joints[0];
        def.joint2 = joints[1];
        const b2Joint* gear = scene.world.CreateJoint(&def);
        ASSERT_NE(gear, nullptr) << &c - cases;
        EXPECT_EQ(gear->GetBodyA(), c.takenA) << &c - cases;
        EXPECT_EQ(gear->GetBodyB(), c.takenB) << &c - cases;
    }
}

/// Two wheels on posts of their own, the gear defined with the posts.
TEST(GearJoint, WakesTheWheelsOfTwoPostsTogether)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* posts[2];
    b2Body* wheels[2];
    b2Joint* joints[2];
    for (int i = 0; i < 2; ++i)
    {
        posts[i] = scene.Post(4.0f * float32(i));
        wheels[i] = scene.Ball(4.0f * float32(i), 0.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(posts[i], wheels[i], posts[i]->GetPosition());
        joints[i] = scene.world.CreateJoint(&hinge);
    }
    b2GearJointDef def;
    def.bodyA = posts[0];
    def.bodyB = posts[1];
    def.joint1 = joints[0];
    def.joint2 = joints[1];
    ASSERT_NE(scene.world.CreateJoint(&def), nullptr);
    scene.Step(60);
    ASSERT_FALSE(wheels[0]->IsAwake() || wheels[1]->IsAwake());
    wheels[0]->SetAngularVelocity(3.0f);
    scene.Step();
    EXPECT_TRUE(wheels[1]->IsAwake());
    EXPECT_NEAR(wheels[0]->GetAngularVelocity() + wheels[1]->GetAngularVelocity(), 0.0f, 1e-4f);
}

} // namespace
