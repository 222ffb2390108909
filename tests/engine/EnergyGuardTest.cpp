// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <Dynamics/Energy/EnergyGuard.h>
#include <Dynamics/Solver/SolverMemory.h>
#include <Dynamics/State/World.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// The guard alone. A test begins a step, plays the role of a bad solver, and checks that the gain
/// is removed. Worlds in which the real solver gains energy are in tests/stability.
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
    box2d::SolverMemory& Arrays() { return *World().solver; }
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

TEST(EnergyGuard, LeavesAnIslandWithoutGainUnchanged)
{
    Pair pair;
    pair.Begin();
    pair.At(pair.b).v.y = 1.9f;
    const box2d::SolverBody before = pair.At(pair.b);
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).v, before.v);
    EXPECT_EQ(pair.At(pair.b).w, before.w);
}

TEST(EnergyGuard, TakesTheGainOfAFreePairFromItsRelativeMotion)
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

TEST(EnergyGuard, ScalesAllVelocitiesOfAHeldPairAlike)
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

TEST(EnergyGuard, CountsWorkOfGravityAlongThePath)
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

TEST(EnergyGuard, LimitsMotorsToTheirMaximumWork)
{
    Pair pair;
    pair.hinge->EnableMotor(true);
    pair.hinge->SetMotorSpeed(6.0f);
    pair.hinge->SetMaxMotorTorque(100.0f);
    const double maximum = 6.0 * 100.0 * double(kStep); // 10 J
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.b).v.y += 2.0f; // 6 J
    const double driven = pair.Energy();
    ASSERT_LT(driven, start + maximum);
    pair.Balance();
    EXPECT_EQ(pair.Energy(), driven);

    pair.At(pair.b).v.y += 10.0f;
    pair.Begin(); // from what the bodies had, with an account that is even
    pair.At(pair.b).v.y += 10.0f;
    pair.Balance();
    EXPECT_LT(pair.Energy(), start + 2.0 * maximum + 1e-3);
}

TEST(EnergyGuard, IgnoresBodiesJoinedToAMovingPlatform)
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

TEST(EnergyGuard, IgnoresBodiesWithoutJoints)
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

TEST(EnergyGuard, IgnoresBodiesWhoseJointIsDestroyed)
{
    Pair pair;
    pair.Begin();
    pair.scene.world.DestroyJoint(pair.hinge);
    b2Body* other = pair.scene.Box(20.0f, 0.0f);
    b2RevoluteJointDef def;
    def.Initialize(pair.scene.Ground(), other, b2Vec2(20.0f, 8.0f));
    pair.scene.world.CreateJoint(&def);
    other->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    pair.Begin(); // one account again, of another island
    pair.At(pair.b).v.y = 50.0f;
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).v.y, 50.0f);
    EXPECT_EQ(pair.At(other).v.x, 1.0f) << "pays for what is not its own";
}

/// True if a gain is removed.
bool IsGuarded(Pair& pair)
{
    pair.Begin();
    pair.At(pair.b).v.y = 50.0f;
    pair.Balance();
    return pair.At(pair.b).v.y < 50.0f;
}

TEST(EnergyGuard, WatchesOnlyPairsWithLongLevers)
{
    Pair near(b2Vec2_zero, 0.0f);
    EXPECT_FALSE(IsGuarded(near));
    Pair far(b2Vec2_zero, 2.0f); // five radii of gyration of a box of 1 m
    EXPECT_TRUE(IsGuarded(far));
}

/// A pull along a line turns the body straight in a moment.
TEST(EnergyGuard, WatchesShorterLeversWithRodsRopesAndPulleys)
{
    const auto isGuarded = [](float32 lever, b2JointType type) {
        Pair pair(b2Vec2_zero, 0.0f);
        b2DistanceJointDef rod;
        rod.Initialize(pair.a, pair.b, b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, lever));
        b2RopeJointDef rope;
        rope.bodyA = pair.a;
        rope.bodyB = pair.b;
        rope.localAnchorB.Set(0.0f, lever);
        rope.maxLength = 3.0f;
        b2PulleyJointDef pulley;
        pulley.Initialize(pair.a, pair.b, b2Vec2(0.0f, 5.0f), b2Vec2(2.0f, 5.0f),
                          b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, lever), 1.0f);
        const b2JointDef* defs[] = {&rod, &rope, &pulley};
        const auto isOne = [type](const b2JointDef* def) { return def->type == type; };
        pair.scene.world.CreateJoint(*std::find_if(defs, defs + 3, isOne));
        return IsGuarded(pair);
    };
    for (const b2JointType type : {e_distanceJoint, e_ropeJoint, e_pulleyJoint})
    {
        EXPECT_FALSE(isGuarded(0.7f, type)) << type; // 1.7 radii of gyration
        EXPECT_TRUE(isGuarded(1.0f, type)) << type;  // 2.4
    }
}

TEST(EnergyGuard, WatchesAPairOnceItsMassesAreUnequal)
{
    Pair pair(b2Vec2_zero, 0.0f);
    EXPECT_FALSE(IsGuarded(pair));
    pair.a->GetFixtureList()->SetDensity(20.0f);
    pair.a->ResetMassData();
    EXPECT_TRUE(IsGuarded(pair));
}

TEST(EnergyGuard, WatchesASliderThatHasMovedFar)
{
    Pair pair(b2Vec2_zero, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(pair.a, pair.b, b2Vec2(2.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    pair.scene.world.CreateJoint(&def);
    EXPECT_FALSE(IsGuarded(pair));
    pair.b->SetTransform(b2Vec2(12.0f, 0.0f), 0.0f);
    pair.World().stepNumber += box2d::World::kUserChangeSteps;
    EXPECT_TRUE(IsGuarded(pair));
}

/// Leaves alone what `give` has moved, for as long as it may matter, and then no longer.
template <class Function>
void ExpectGift(Pair& pair, const char* what, Function&& give)
{
    EXPECT_TRUE(IsGuarded(pair)) << what;
    give();
    EXPECT_FALSE(IsGuarded(pair)) << what;
    pair.World().stepNumber += box2d::World::kUserChangeSteps;
    EXPECT_TRUE(IsGuarded(pair)) << what;
}

TEST(EnergyGuard, IgnoresBodiesMovedByTheUser)
{
    Pair pair;
    b2Body* post = pair.scene.Body(b2_staticBody, 5.0f, 0.0f);
    b2RevoluteJointDef def;
    def.Initialize(post, pair.b, b2Vec2(5.0f, 0.0f));
    pair.scene.world.CreateJoint(&def);
    ExpectGift(pair, "its anchor", [&] { post->SetTransform(b2Vec2(5.0f, 0.1f), 0.0f); });
    ExpectGift(pair, "a body of it", [&] { pair.a->SetTransform(b2Vec2(0.0f, 0.1f), 0.0f); });
    b2Body* other = pair.scene.Box(50.0f, 0.0f);
    other->SetTransform(b2Vec2(60.0f, 0.0f), 0.0f);
    EXPECT_TRUE(IsGuarded(pair)) << "nothing of it was moved";
}

TEST(EnergyGuard, IgnoresBodiesThatAMovedBodyTouches)
{
    Pair pair;
    b2Body* wall = pair.scene.Body(b2_staticBody, 3.0f, 0.0f);
    Scene::AddBox(wall, 0.5f, 0.5f);
    pair.scene.world.Step(1e-6f, 8, 3); // finds the contact
    ASSERT_NE(pair.b->GetContactList(), nullptr);
    ASSERT_TRUE(pair.b->GetContactList()->contact->IsTouching());
    ExpectGift(pair, "a wall", [&] { wall->SetTransform(b2Vec2(2.95f, 0.0f), 0.0f); });
}

TEST(EnergyGuard, IgnoresBodiesOfAChangedJoint)
{
    Pair pair;
    b2Body* ground = pair.scene.Ground();
    ExpectGift(pair, "hinge's limits", [&] { pair.hinge->SetLimits(0.5f, 1.0f); });
    ExpectGift(pair, "a limit switched on", [&] { pair.hinge->EnableLimit(true); });
    b2PrismaticJointDef slide;
    slide.Initialize(ground, pair.b, b2Vec2(2.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    auto* slider = static_cast<b2PrismaticJoint*>(pair.scene.world.CreateJoint(&slide));
    ExpectGift(pair, "slider's limits", [&] { slider->SetLimits(0.5f, 1.0f); });
    ExpectGift(pair, "a limit switched on", [&] { slider->EnableLimit(true); });
    b2RopeJointDef tie;
    tie.bodyA = ground;
    tie.bodyB = pair.b;
    tie.maxLength = 5.0f;
    auto* rope = static_cast<b2RopeJoint*>(pair.scene.world.CreateJoint(&tie));
    ExpectGift(pair, "a rope's length", [&] { rope->SetMaxLength(1.0f); });
    b2DistanceJointDef hold;
    hold.Initialize(ground, pair.b, b2Vec2(0.0f, 5.0f), b2Vec2(2.0f, 0.0f));
    hold.frequencyHz = 1.0f;
    auto* rod = static_cast<b2DistanceJoint*>(pair.scene.world.CreateJoint(&hold));
    ExpectGift(pair, "a rod's length", [&] { rod->SetLength(1.0f); });
    ExpectGift(pair, "a spring made rigid", [&] { rod->SetFrequency(0.0f); });
    b2WeldJointDef glue;
    glue.Initialize(ground, pair.b, b2Vec2(2.0f, 0.0f));
    glue.frequencyHz = 1.0f;
    auto* weld = static_cast<b2WeldJoint*>(pair.scene.world.CreateJoint(&glue));
    ExpectGift(pair, "a weld made rigid", [&] { weld->SetFrequency(0.0f); });
    b2RevoluteJointDef axle;
    axle.Initialize(ground, pair.a, b2Vec2(0.0f, 0.0f));
    b2GearJointDef teeth;
    teeth.joint1 = pair.scene.world.CreateJoint(&axle);
    teeth.joint2 = slider;
    teeth.bodyA = pair.a;
    teeth.bodyB = pair.b;
    auto* gear = static_cast<b2GearJoint*>(pair.scene.world.CreateJoint(&teeth));
    ExpectGift(pair, "a gear's ratio", [&] { gear->SetRatio(2.0f); });
}

/// User changes between steps are not gains of the step: velocities, impulses, masses, weight.
TEST(EnergyGuard, KeepsMotionGivenByTheUser)
{
    Pair pair(b2Vec2(0.0f, -10.0f));
    const auto expectKept = [&](const char* what) {
        pair.Begin();
        const double start = pair.Energy();
        pair.Balance();
        EXPECT_EQ(pair.Energy(), start) << what;
        pair.WriteBack();
    };
    expectKept("nothing");
    pair.b->SetLinearVelocity(b2Vec2(0.0f, 50.0f));
    pair.a->SetAngularVelocity(20.0f);
    expectKept("velocities");
    pair.b->ApplyLinearImpulse(b2Vec2(100.0f, 0.0f), pair.b->GetWorldCenter(), true);
    pair.b->ApplyAngularImpulse(10.0f, true);
    expectKept("impulses");
    pair.b->GetFixtureList()->SetDensity(100.0f);
    pair.b->ResetMassData();
    expectKept("masses");
    pair.scene.world.SetGravity(b2Vec2(0.0f, -1000.0f));
    pair.b->SetGravityScale(-10.0f);
    expectKept("weight");

    // Forces, and their work along the path.
    pair.b->ApplyForceToCenter(b2Vec2(6000.0f, 0.0f), true);
    pair.Begin();
    pair.At(pair.b).v.x += kStep * 6000.0f / pair.b->GetMass();
    pair.At(pair.b).d = kStep * pair.At(pair.b).v;
    const double driven = pair.Energy();
    pair.Balance();
    EXPECT_EQ(pair.Energy(), driven);
}

TEST(EnergyGuard, KeepsEnergyGivenByAMouseJoint)
{
    Pair pair;
    b2MouseJointDef def;
    def.bodyA = pair.scene.Ground();
    def.bodyB = pair.b;
    def.target = pair.b->GetWorldCenter();
    def.maxForce = 1000.0f;
    auto* mouse = static_cast<b2MouseJoint*>(pair.scene.world.CreateJoint(&def));
    mouse->SetTarget(b2Vec2(2.0f, 5.0f));
    pair.Begin();
    pair.At(pair.b).v.y += 10.0f;
    pair.At(pair.b).d.y = 0.3f; // along which the pull does more than that
    const double driven = pair.Energy();
    pair.Balance();
    EXPECT_EQ(pair.Energy(), driven);
}

/// A ball on a link whose anchor is moved to and fro by user changes or as a platform. Its swing
/// must not depend on a mass slightly below or above the ratio from which it is guarded.
double WidestSwing(float32 ratio, b2BodyType type, int32 subSteps)
{
    Scene scene;
    scene.world.SetSubStepCount(subSteps);
    b2Body* post = scene.Body(type, 0.0f, 0.0f);
    b2Body* link = scene.Body(b2_dynamicBody, 0.0f, -0.5f);
    Scene::AddBox(link, 0.1f, 0.5f);
    b2Body* ball = scene.Body(b2_dynamicBody, 0.0f, -1.0f);
    Scene::AddBox(ball, 0.3f, 0.3f);
    ball->GetFixtureList()->SetDensity(0.2f * ratio / 0.36f);
    ball->ResetMassData();
    b2RevoluteJointDef def;
    def.Initialize(post, link, b2Vec2(0.0f, 0.0f));
    scene.world.CreateJoint(&def);
    def.Initialize(link, ball, b2Vec2(0.0f, -1.0f));
    scene.world.CreateJoint(&def);
    double widest = 0.0;
    for (int i = 0; i < 600; ++i)
    {
        const double time = double(i) * double(kStep);
        if (type == b2_staticBody)
        {
            post->SetTransform(b2Vec2(float32(0.3 * std::sin(3.0 * time)), 0.0f), 0.0f);
        }
        else
        {
            post->SetLinearVelocity(b2Vec2(float32(0.9 * std::cos(3.0 * time)), 0.0f));
        }
        scene.world.Step(kStep, 8, 3);
        widest = std::max(widest, double(b2Abs(ball->GetPosition().x)));
    }
    return widest;
}

TEST(EnergyGuard, KeepsTheSwingGivenByAMovedAnchor)
{
    for (const int32 subSteps : {1, 4})
    {
        for (const b2BodyType type : {b2_staticBody, b2_kinematicBody})
        {
            const double below = WidestSwing(9.95f, type, subSteps);
            EXPECT_GT(below, 0.35) << "farther than the anchor";
            EXPECT_NEAR(WidestSwing(10.05f, type, subSteps), below, 0.01)
                << type << ' ' << subSteps;
        }
    }
}

TEST(EnergyGuard, UndoesCorrectionsThatLoadASpring)
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

/// All that moves would not pay for the spring: it must not have gone anywhere.
TEST(EnergyGuard, UndoesMotionThatLoadsSpringTooMuch)
{
    Pair pair;
    b2WeldJointDef def;
    def.Initialize(pair.scene.Ground(), pair.b, b2Vec2(2.0f, 0.0f));
    def.frequencyHz = 5.0f;
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.b).angle = 30.0f;
    pair.At(pair.b).w = 30.0f / kStep;
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).angle, 0.0f);
    EXPECT_EQ(pair.At(pair.b).d, b2Vec2_zero);
    EXPECT_LT(pair.Energy(), 1.02 * start);
}

TEST(EnergyGuard, GivesNoCreditForUndoneFall)
{
    Pair pair(b2Vec2(0.0f, -10.0f));
    b2WeldJointDef def;
    def.Initialize(pair.scene.Ground(), pair.b, b2Vec2(2.0f, 0.0f));
    def.frequencyHz = 5.0f;
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    const double start = pair.Energy();
    pair.At(pair.b).angle = 30.0f;
    pair.At(pair.b).d.Set(0.0f, -5.0f); // 50 J
    pair.At(pair.b).v.Set(10.0f, 0.0f); // the same
    pair.Balance();
    EXPECT_EQ(pair.At(pair.b).d.y, 0.0f);
    EXPECT_LT(pair.Energy(), 1.2 * start);
}

TEST(EnergyGuard, AccumulatesSmallGains)
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

TEST(EnergyGuard, AllowsEnergyThatWasLostShortlyBefore)
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
TEST(EnergyGuard, ChargesHeightGainedByImpactWithinStep)
{
    Pair pair(b2Vec2(0.0f, -10.0f));
    pair.Begin();
    box2d::BodyData& data = box2d::Data(*pair.b);
    const box2d::EnergyGuard::Path fallen = {data.pose, data.linearVelocity, data.angularVelocity};
    data.pose.y += 0.25; // 1 kg, back up with the same speed
    pair.guard.NoteImpact(data, fallen);
    EXPECT_NEAR(data.energyDebt, 2.5f, 1e-4f);
    data.pose.y -= 0.25;
    data.linearVelocity.SetZero(); // of 5 m^2/s^2
    data.angularVelocity = 0.0f;
    pair.guard.NoteImpact(data, fallen);
    EXPECT_NEAR(data.energyDebt, 2.5f - 0.5f * 5.0f - 0.5f * data.inertia * 4.0f, 1e-4f);
}

TEST(EnergyGuard, ChargesSpringEnergyOfImpactWithinStep)
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
    EXPECT_NEAR(data.energyDebt, 0.5f * data.inertia * omega * omega * 0.01f, 1e-3f);
}

/// The stiffness of a spring depends on the pose. No body reached the end of a path that an impact
/// shortened.
TEST(EnergyGuard, GivesNoCreditForPathUndoneByImpact)
{
    Pair pair;
    b2DistanceJointDef def;
    def.Initialize(pair.scene.Ground(), pair.b, b2Vec2(2.4f, 3.0f), b2Vec2(2.4f, 0.0f));
    def.length = 2.5f;
    def.frequencyHz = 0.5f;
    pair.scene.world.CreateJoint(&def);
    pair.Begin();
    box2d::SolverBody& turned = pair.At(pair.b);
    turned.angle = 0.5f * b2_pi; // which slackens it, and makes it twice as stiff
    turned.q.Set(turned.angle);
    pair.Balance();
    const auto debt = [&] {
        return box2d::Data(*pair.a).energyDebt + box2d::Data(*pair.b).energyDebt;
    };
    EXPECT_LT(debt(), -1.0f);
    pair.guard.ChargeImpacts();
    EXPECT_NEAR(debt(), 0.0f, 0.01f);
}

TEST(EnergyGuard, StopsBodiesWithNanAndBalancesTheRest)
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

TEST(EnergyGuard, SlowsDownLittleForASmallOldDebt)
{
    Pair pair;
    pair.Begin();
    const double start = pair.Energy();
    for (b2Body* body : {pair.a, pair.b})
    {
        box2d::Data(*body).energyScale = float32(100.0 * start);
        box2d::Data(*body).energyDebt = 0.02f * box2d::Data(*body).energyScale;
    }
    pair.Balance(); // it owes twice what it has
    EXPECT_LT(pair.Energy(), start);
    EXPECT_GT(pair.Energy(), 0.89 * start);
}

TEST(EnergyGuard, KeepsCreditWhileTheEnergyScaleDecays)
{
    Pair pair;
    for (b2Body* body : {pair.a, pair.b})
    {
        box2d::Data(*body).energyScale = 1000.0f;
        box2d::Data(*body).energyDebt = -500.0f;
    }
    for (int32 step = 0; step < 300; ++step)
    {
        pair.Begin();
        pair.Balance();
    }
    EXPECT_NEAR(box2d::Data(*pair.a).energyDebt, -500.0f, 1.0f);
    EXPECT_LT(box2d::Data(*pair.a).energyScale, 610.0f);
}

/// Boxes at a slack rope that start 2 cm deep in the ground. What lifted them was charged to them,
/// and they could not move until it was paid.
TEST(EnergyGuard, ChargesNothingForAPushOutOfAnOverlap)
{
    for (const int32 count : {1, 2, 4, 8})
    {
        Scene scene;
        scene.world.SetSubStepCount(count);
        Scene::AddBox(scene.Body(b2_staticBody, 0.0f, -0.5f), 10.0f, 0.5f, 0.0f);
        b2Body* a = scene.Box(0.0f, 0.49f);
        b2Body* b = scene.Box(1.5f, 0.49f);
        b2RopeJointDef def;
        def.bodyA = a;
        def.bodyB = b;
        def.maxLength = 9.0f;
        scene.world.CreateJoint(&def);
        for (int32 i = 0; i < 600; ++i)
        {
            a->ApplyForceToCenter(b2Vec2(0.1f, 0.0f), true);
            b->ApplyForceToCenter(b2Vec2(0.1f, 0.0f), true);
            scene.Step();
        }
        EXPECT_NEAR(a->GetLinearVelocity().x, 1.0f, 0.01f) << count;
    }
}

} // namespace
