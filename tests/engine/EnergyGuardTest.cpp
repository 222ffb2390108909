// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/EnergyGuard.h>
#include <Dynamics/SolverArrays.h>
#include <Dynamics/World.h>

#include <gtest/gtest.h>

#include <cmath>

/// The guard by itself: a step is begun, a bad solver is played, and what it has won is taken away.
/// Worlds in which the real one wins are in tests/stability.
namespace
{

using namespace dynamics;

/// Two boxes on a hinge, 2 kg and 1 kg. It is so far away that they are at risk.
struct Pair
{
    explicit Pair(const b2Vec2& gravity = b2Vec2(0.0f, 0.0f), float32 lever = 8.0f) : scene(gravity)
    {
        a = scene.Body(b2_dynamicBody, 0.0f, 0.0f);
        Scene::AddBox(a, 0.5f, 1.0f);
        b = scene.Body(b2_dynamicBody, 2.0f, 0.0f);
        Scene::AddBox(b, 0.5f, 0.5f);
        b2RevoluteJointDef def;
        def.Initialize(a, b, b2Vec2(1.0f, lever));
        hinge = static_cast<b2RevoluteJoint*>(scene.world.CreateJoint(&def));
        a->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
        b->SetLinearVelocity(b2Vec2(1.0f, 2.0f));
        b->SetAngularVelocity(2.0f);
    }

    box2d::World& World() { return *box2d::Data(*a).world; }
    box2d::SolverArrays& Arrays() { return *World().solver; }
    box2d::SolverBody& At(const b2Body* body)
    {
        return Arrays().bodies[std::size_t(box2d::Data(*body).SolverIndex())];
    }
    static double Energy(const b2Body& body, const box2d::SolverBody& s)
    {
        return box2d::KineticEnergy(s, double(box2d::Data(body).mass),
                                    double(box2d::Data(body).inertia));
    }
    double Energy() { return Energy(*a, At(a)) + Energy(*b, At(b)); }

    void Begin()
    {
        Arrays().bodies.assign(World().awakeBodies.size() + 1, box2d::SolverBody());
        for (const b2Body* body : World().awakeBodies)
        {
            At(body).v = body->GetLinearVelocity();
            At(body).w = body->GetAngularVelocity();
        }
        guard.Begin(World(), Arrays(), kStep);
    }
    void Balance() { guard.Balance(World(), Arrays()); }
    /// The velocities of the next step's start.
    void WriteBack()
    {
        for (b2Body* body : {a, b})
        {
            body->SetLinearVelocity(At(body).v);
            body->SetAngularVelocity(At(body).w);
        }
    }

    Scene scene;
    b2Body* a;
    b2Body* b;
    b2RevoluteJoint* hinge;
    box2d::EnergyGuard guard;
};

TEST(EnergyGuard, LeavesEveryBitOfWhatHasWonNothing)
{
    Pair pair;
    pair.Begin();
    pair.At(pair.b).v.y = 1.9f;
    const box2d::SolverBody before = pair.At(pair.b);
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).v, before.v);
    EXPECT_EQ(pair.At(pair.b).w, before.w);
}

TEST(EnergyGuard, TakesWhatAFreePairHasWonFromWhatMovesWithinIt)
{
    Pair pair;
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.a).v.x += 2.0f; // 2 kg, and along the line between them
    pair.At(pair.b).v.x -= 4.0f; // 1 kg
    const auto momentum = [&] { return 2.0f * pair.At(pair.a).v + pair.At(pair.b).v; };
    const b2Vec2 before = momentum();
    ASSERT_GT(pair.Energy(), 3.0 * start);
    pair.Balance();
    EXPECT_NEAR(pair.Energy(), start, 1e-4 * start);
    EXPECT_NEAR(b2Distance(momentum(), before), 0.0f, 1e-5f);
}

TEST(EnergyGuard, KeepsTheAngularMomentumOfAFreePair)
{
    Pair pair;
    pair.Begin();
    const auto angular = [&] {
        double sum = 0.0;
        for (const b2Body* body : {pair.a, pair.b})
        {
            const box2d::SolverBody& s = pair.At(body);
            sum += double(body->GetMass() * b2Cross(body->GetWorldCenter(), s.v)) +
                   double(box2d::Data(*body).inertia * s.w);
        }
        return sum;
    };
    pair.At(pair.a).w += 5.0f;
    pair.At(pair.b).w -= 5.0f * box2d::Data(*pair.a).inertia / box2d::Data(*pair.b).inertia;
    const double before = angular();
    pair.Balance();
    EXPECT_NEAR(angular(), before, 1e-5 * std::abs(before));
}

TEST(EnergyGuard, SlowsDownAllOfWhatIsHeldAlike)
{
    Pair pair;
    b2RevoluteJointDef def;
    def.Initialize(pair.scene.Ground(), pair.a, b2Vec2(0.0f, 0.0f));
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.a).v *= 4.0f;
    pair.At(pair.b).v *= 4.0f;
    pair.At(pair.b).w *= 4.0f;
    pair.Balance();
    EXPECT_NEAR(pair.Energy(), start, 1e-4 * start);
    EXPECT_NEAR(pair.At(pair.a).v.x, 1.0f, 1e-3f);
    EXPECT_NEAR(pair.At(pair.b).v.y, 2.0f, 1e-3f);
    EXPECT_NEAR(pair.At(pair.b).w, 2.0f, 1e-3f);
}

TEST(EnergyGuard, CountsTheWorkOfGravityAlongTheWay)
{
    Pair fallen(b2Vec2(0.0f, -10.0f));
    Pair not_(b2Vec2(0.0f, -10.0f));
    for (Pair* pair : {&fallen, &not_})
    {
        pair->Begin();
        for (const b2Body* body : {pair->a, pair->b})
        {
            pair->At(body).v.y -= 3.0f;
            pair->At(body).d.y = pair == &fallen ? -1.0f : 0.0f;
        }
    }
    const double much = fallen.Energy();
    fallen.Balance();
    not_.Balance();
    EXPECT_EQ(fallen.Energy(), much);
    EXPECT_LT(not_.Energy(), 0.9 * much);
}

TEST(EnergyGuard, LetsMotorsGiveWhatTheyCanAndNoMore)
{
    Pair pair;
    pair.hinge->EnableMotor(true);
    pair.hinge->SetMotorSpeed(6.0f);
    pair.hinge->SetMaxMotorTorque(100.0f);
    const double most = 6.0 * 100.0 * double(kStep); // 10 J
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.b).v.y += 2.0f; // 6 J
    const double driven = pair.Energy();
    ASSERT_LT(driven, start + most);
    pair.Balance();
    EXPECT_EQ(pair.Energy(), driven);

    pair.At(pair.b).v.y += 10.0f;
    pair.Begin(); // from what the bodies had, with an account that is even
    pair.At(pair.b).v.y += 10.0f;
    pair.Balance();
    EXPECT_LT(pair.Energy(), start + 2.0 * most + 1e-3);
}

TEST(EnergyGuard, LeavesWhatAPlatformMovesAlone)
{
    Pair pair;
    b2Body* platform = pair.scene.Body(b2_kinematicBody, 5.0f, 0.0f);
    b2RevoluteJointDef def;
    def.Initialize(platform, pair.b, b2Vec2(5.0f, 0.0f));
    pair.scene.world.CreateJoint(&def);
    platform->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    pair.Begin();
    pair.At(pair.b).v.y += 100.0f;
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).v.y, 102.0f);
}

TEST(EnergyGuard, DoesNotLookAtWhatHasNoJoints)
{
    Pair pair;
    pair.scene.world.DestroyJoint(pair.hinge);
    b2Body* other = pair.scene.Box(20.0f, 0.0f);
    b2RevoluteJointDef def;
    def.Initialize(pair.scene.Ground(), other, b2Vec2(20.0f, 8.0f));
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    pair.At(pair.b).v.y = 50.0f;
    pair.At(other).v.y = 50.0f;
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).v.y, 50.0f);
    EXPECT_EQ(pair.At(other).v.y, 0.0f);
}

/// Whether a gain is taken away.
bool IsGuarded(Pair& pair)
{
    pair.Begin();
    pair.At(pair.b).v.y = 50.0f;
    pair.Balance();
    return pair.At(pair.b).v.y < 50.0f;
}

TEST(EnergyGuard, LooksOnlyAtWhatIsAtRisk)
{
    Pair near(b2Vec2_zero, 0.0f);
    EXPECT_FALSE(IsGuarded(near));
    Pair far(b2Vec2_zero, 2.0f); // five radii of gyration of a box of 1 m
    EXPECT_TRUE(IsGuarded(far));
}

TEST(EnergyGuard, NoticesThatMassesHaveBecomeUnequal)
{
    Pair pair(b2Vec2_zero, 0.0f);
    EXPECT_FALSE(IsGuarded(pair));
    pair.a->GetFixtureList()->SetDensity(20.0f);
    pair.a->ResetMassData();
    EXPECT_TRUE(IsGuarded(pair));
}

TEST(EnergyGuard, NoticesThatASliderHasGoneFar)
{
    Pair pair(b2Vec2_zero, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(pair.a, pair.b, b2Vec2(2.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    pair.scene.world.CreateJoint(&def);
    EXPECT_FALSE(IsGuarded(pair));
    pair.b->SetTransform(b2Vec2(12.0f, 0.0f), 0.0f);
    EXPECT_TRUE(IsGuarded(pair));
}

TEST(EnergyGuard, TakesCorrectionsBackThatWindUpASpring)
{
    Pair pair;
    b2WeldJointDef def;
    def.Initialize(pair.scene.Ground(), pair.b, b2Vec2(2.0f, 0.0f));
    def.frequencyHz = 5.0f;
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    pair.At(pair.b).angle = 30.0f;
    pair.At(pair.b).d.Set(0.5f, 0.0f);
    pair.Balance();
    EXPECT_NEAR(pair.At(pair.b).angle, kStep * 2.0f, 1e-5f);
    EXPECT_NEAR(pair.At(pair.b).d.x, kStep * 1.0f, 1e-5f);
}

TEST(EnergyGuard, RemembersWhatIsWonLittleByLittle)
{
    Pair pair;
    pair.Begin();
    pair.Balance();
    const double start = pair.Energy();
    for (int i = 0; i < 60; ++i)
    {
        pair.WriteBack();
        pair.Begin();
        pair.At(pair.b).w *= 1.002f;
        pair.Balance();
    }
    EXPECT_GT(pair.Energy(), start); // a hundredth is truncation
    EXPECT_LT(pair.Energy(), 1.013 * start);
}

TEST(EnergyGuard, GivesBackWhatWasLostShortlyBefore)
{
    Pair pair;
    pair.Begin();
    pair.Balance();
    const double start = pair.Energy();
    pair.WriteBack();
    pair.Begin();
    pair.At(pair.b).v.y = 0.0f;
    pair.Balance();
    pair.WriteBack();
    pair.Begin();
    pair.At(pair.b).v.y = 2.0f;
    pair.Balance();
    EXPECT_EQ(pair.Energy(), start);
}

/// With one step a body that is taken back to an impact keeps the speed of its whole fall.
TEST(EnergyGuard, ChargesWhatAnImpactWithinTheStepHasLifted)
{
    Pair pair(b2Vec2(0.0f, -10.0f));
    pair.Begin();
    box2d::BodyData& data = box2d::Data(*pair.b);
    const box2d::EnergyGuard::Way fallen = {data.pose, data.linearVelocity, data.angularVelocity};
    data.pose.y += 0.25; // 1 kg, back up with the same speed
    pair.guard.NoteImpact(data, fallen);
    EXPECT_NEAR(data.energyOwed, 2.5f, 1e-4f);
    data.pose.y -= 0.25;
    data.linearVelocity.SetZero(); // of 5 m^2/s^2
    data.angularVelocity = 0.0f;
    pair.guard.NoteImpact(data, fallen);
    EXPECT_NEAR(data.energyOwed, 2.5f - 0.5f * 5.0f - 0.5f * data.inertia * 4.0f, 1e-4f);
}

TEST(EnergyGuard, ChargesWhatAnImpactWithinTheStepHasPutIntoASpring)
{
    Pair pair;
    b2WeldJointDef def;
    def.Initialize(pair.scene.Ground(), pair.b, b2Vec2(2.0f, 0.0f));
    def.frequencyHz = 5.0f;
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    box2d::BodyData& data = box2d::Data(*pair.b);
    data.pose.angle += 0.1;
    pair.guard.ChargeImpacts();
    const float32 omega = 2.0f * b2_pi * 5.0f;
    EXPECT_NEAR(data.energyOwed, 0.5f * data.inertia * omega * omega * 0.01f, 1e-3f);
}

TEST(EnergyGuard, StopsWhatIsNoNumberAndJudgesTheRest)
{
    Pair pair;
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.a).v.x = NAN;
    pair.At(pair.b).v.y = 100.0f;
    pair.Balance();
    EXPECT_TRUE(box2d::IsFinite(pair.At(pair.a)));
    EXPECT_LT(pair.Energy(), 1.001 * start);
}

} // namespace
