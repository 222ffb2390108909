// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

#include "Common/WideInstructions.h"

#include <Box2D/Dynamics/b2Snapshot.h>

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

/// Joints in a pile with more contacts than are solved directly: iterations solve them.
namespace
{

using namespace dynamics;

/// Falls into a container, with an island of its own each at first.
class Pile
{
public:
    explicit Pile(int32 subSteps = 4, int32 threads = 1) : scene(b2Vec2(0.0f, -kGravity), subSteps)
    {
        scene.world.SetThreadCount(threads);
        scene.Ground();
        scene.Wall(-7.0f, 3.0f);
        scene.Wall(7.0f, 3.0f);
    }

    b2Body* Bar(float32 x, float32 y, float32 density = 1.0f)
    {
        b2Body* body = scene.Load(x, y, 0.3f, 0.1f);
        body->GetFixtureList()->SetDensity(density);
        body->ResetMassData();
        scene.parts.push_back(body);
        return body;
    }

    /// Three bars in a row, joined by two hinges with limits.
    void Limb(float32 x, float32 y)
    {
        b2Body* bars[3];
        for (int i = 0; i < 3; ++i)
        {
            bars[i] = Bar(x + 0.7f * float32(i), y);
        }
        for (int i = 0; i < 2; ++i)
        {
            b2RevoluteJointDef def;
            def.Initialize(bars[i], bars[i + 1], b2Vec2(x + 0.7f * float32(i) + 0.35f, y));
            def.enableLimit = true;
            def.lowerAngle = -0.6f;
            def.upperAngle = 0.6f;
            hinges.push_back(scene.Create<b2RevoluteJoint>(def));
        }
    }

    void Limbs(int count)
    {
        for (int i = 0; i < count; ++i)
        {
            Limb(-4.2f + 2.4f * float32(i % 4), 1.0f + 0.5f * float32(i / 4));
        }
    }

    float32 WidestGap() const
    {
        float32 widest = 0.0f;
        for (const b2RevoluteJoint* hinge : hinges)
        {
            widest = b2Max(widest, Gap(hinge));
        }
        return widest;
    }

    std::uint64_t Hash() const
    {
        std::uint64_t hash = 14695981039346656037ull; // FNV-1a
        for (const b2Body* b = scene.world.GetBodyList(); b; b = b->GetNext())
        {
            for (const float32 value :
                 {b->GetPosition().x, b->GetPosition().y, b->GetAngle(), b->GetLinearVelocity().x,
                  b->GetLinearVelocity().y, b->GetAngularVelocity()})
            {
                hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 1099511628211ull;
            }
        }
        return hash;
    }

    SmallScene scene;
    std::vector<b2RevoluteJoint*> hinges;
};

/// Two bars and one of each joint between two bodies, in turn.
void AddPairs(Pile& pile, int count)
{
    for (int i = 0; i < count; ++i)
    {
        const float32 x = -5.0f + 1.7f * float32(i % 6);
        const float32 y = 1.0f + 0.5f * float32(i / 6);
        b2Body* a = pile.Bar(x, y);
        b2Body* b = pile.Bar(x + 0.7f, y);
        const b2Vec2 between(x + 0.35f, y);
        switch (i % 9)
        {
        case 0: {
            b2RevoluteJointDef def;
            def.Initialize(a, b, between);
            def.enableMotor = true;
            def.motorSpeed = 2.0f;
            def.maxMotorTorque = 1.0f;
            (void)pile.scene.Create<b2RevoluteJoint>(def);
            break;
        }
        case 1: {
            b2PrismaticJointDef def;
            def.Initialize(a, b, between, b2Vec2(1.0f, 0.0f));
            def.enableLimit = true;
            def.lowerTranslation = -0.1f;
            def.upperTranslation = 0.3f;
            (void)pile.scene.Create<b2PrismaticJoint>(def);
            break;
        }
        case 2:
            (void)pile.scene.Weld(a, b, between.x, between.y);
            break;
        case 3: {
            b2WeldJointDef def;
            def.Initialize(a, b, between);
            def.frequencyHz = 4.0f;
            def.dampingRatio = 0.5f;
            (void)pile.scene.Create<b2WeldJoint>(def);
            break;
        }
        case 4: {
            b2DistanceJointDef def;
            def.Initialize(a, b, a->GetPosition(), b->GetPosition());
            def.frequencyHz = 3.0f;
            (void)pile.scene.Create<b2DistanceJoint>(def);
            break;
        }
        case 5: {
            b2WheelJointDef def;
            def.Initialize(a, b, between, b2Vec2(0.0f, 1.0f));
            (void)pile.scene.Create<b2WheelJoint>(def);
            break;
        }
        case 6: {
            b2RopeJointDef def;
            def.bodyA = a;
            def.bodyB = b;
            def.localAnchorA.Set(0.3f, 0.0f);
            def.localAnchorB.Set(-0.3f, 0.0f);
            def.maxLength = 0.2f;
            (void)pile.scene.Create<b2RopeJoint>(def);
            break;
        }
        case 7: {
            b2FrictionJointDef def;
            def.Initialize(a, b, between);
            def.maxForce = 2.0f;
            def.maxTorque = 1.0f;
            (void)pile.scene.Create<b2FrictionJoint>(def);
            break;
        }
        default: {
            b2MotorJointDef def;
            def.Initialize(a, b);
            def.maxForce = 50.0f;
            def.maxTorque = 20.0f;
            (void)pile.scene.Create<b2MotorJoint>(def);
            break;
        }
        }
    }
}

TEST(SubStepsPile, KeepsHingesClosed)
{
    for (const int32 subSteps : {2, 4})
    {
        Pile pile(subSteps);
        pile.Limbs(80);
        float32 widest = 0.0f;
        for (int i = 0; i < 300; ++i)
        {
            pile.scene.Step();
            widest = b2Max(widest, pile.WidestGap());
        }
        RecordProperty("widest" + std::to_string(subSteps), std::to_string(widest));
        RecordProperty("atRest" + std::to_string(subSteps), std::to_string(pile.WidestGap()));
        EXPECT_GT(pile.scene.world.GetContactCount(), 150) << "not a pile";
        EXPECT_LT(widest, 0.05f) << subSteps << " sub-steps";
        EXPECT_LT(pile.WidestGap(), b2_linearSlop) << subSteps << " sub-steps";
    }
}

TEST(SubStepsPile, ComesToRest)
{
    Pile pile;
    pile.Limbs(80);
    pile.scene.Step(600);
    EXPECT_LT(pile.scene.Kinetic(), 0.01 * double(pile.scene.parts.size()));
}

TEST(SubStepsPile, HoldsLimits)
{
    Pile pile;
    pile.Limbs(80);
    pile.scene.Step(600);
    for (const b2RevoluteJoint* hinge : pile.hinges)
    {
        EXPECT_LT(b2Abs(hinge->GetJointAngle()), 0.6f + 3.0f * b2_angularSlop);
    }
}

/// Masses of more than 10:1 are solved directly in a pile, too. A load can jerk the chain
/// straight when it falls into the pile. Links are then whipped at 60 m/s, and a hinge opens for a
/// few steps. Which loads do that is chance, so one of these may.
TEST(SubStepsPile, KeepsChainWithHeavyLoadClosed)
{
    int opened = 0;
    for (const float32 density : {80.0f, 120.0f, 160.0f, 180.0f, 200.0f, 220.0f, 260.0f, 300.0f})
    {
        Pile pile;
        pile.Limbs(60);
        b2Body* last = pile.scene.Post(0.0f, 7.0f);
        for (int i = 0; i < 10; ++i)
        {
            b2Body* link = pile.Bar(0.6f * float32(i) + 0.3f, 7.0f, i == 9 ? density : 1.0f);
            pile.hinges.push_back(pile.scene.Hinge(last, link, 0.6f * float32(i), 7.0f));
            last = link;
        }
        float32 widest = 0.0f;
        float32 now = 0.0f;
        for (int i = 0; i < 240; ++i)
        {
            pile.scene.Step();
            now = 0.0f;
            for (std::size_t k = pile.hinges.size() - 10; k < pile.hinges.size(); ++k)
            {
                now = b2Max(now, Gap(pile.hinges[k]));
            }
            widest = b2Max(widest, now);
        }
        opened += widest > 0.05f ? 1 : 0;
        EXPECT_LT(now, b2_linearSlop) << "load of " << density;
    }
    EXPECT_LE(opened, 1);
}

TEST(SubStepsPile, GivesTheSameBitsInAnyNumberOfThreadsAndWidth)
{
    std::uint64_t expected = 0;
    for (const int lanes : {16, 8, 4})
    {
        for (const int32 threads : {1, 3})
        {
            box2d::UseLanes(lanes);
            Pile pile(4, threads);
            pile.Limbs(60);
            AddPairs(pile, 90);
            pile.scene.Step(120);
            expected = expected == 0 ? pile.Hash() : expected;
            EXPECT_EQ(pile.Hash(), expected) << threads << " threads, lanes: " << lanes;
        }
    }
    box2d::UseLanes(16);
}

TEST(SubStepsPile, ContinuesFromASnapshotBitByBit)
{
    Pile pile;
    pile.Limbs(60);
    AddPairs(pile, 90);
    pile.scene.Step(90);
    const std::vector<uint8> saved = b2SaveSnapshot(pile.scene.world);
    pile.scene.Step(30);
    const std::uint64_t expected = pile.Hash();
    ASSERT_EQ(b2RestoreSnapshot(pile.scene.world, saved), nullptr);
    for (int i = 0; i < 30; ++i)
    {
        pile.scene.world.Step(1.0f / 60.0f, 8, 3);
    }
    EXPECT_EQ(pile.Hash(), expected);
}

/// The allocator gives the memory of a destroyed joint to the next: here one between two of the
/// last eight limbs, whose second hinges are solved side by side with the destroyed one.
TEST(SubStepsPile, FollowsAJointInTheMemoryOfAnother)
{
    Pile pile;
    pile.Limbs(80);
    pile.scene.Step(200);
    const b2Joint* destroyed = pile.hinges.back();
    pile.scene.world.DestroyJoint(pile.hinges.back());
    const auto middle = [&pile](int limb) { return pile.scene.parts[std::size_t(3 * limb + 1)]; };
    const auto distance = [&middle](int limb) {
        return b2Distance(middle(72)->GetPosition(), middle(limb)->GetPosition());
    };
    int nearest = 73;
    for (int limb = 74; limb < 79; ++limb)
    {
        nearest = distance(limb) < distance(nearest) ? limb : nearest;
    }
    b2RevoluteJointDef def;
    def.bodyA = middle(72);
    def.bodyB = middle(nearest);
    pile.hinges.back() = pile.scene.Create<b2RevoluteJoint>(def);
    ASSERT_EQ(pile.hinges.back(), destroyed) << "the scene no longer tests what it should";
    Pile restored; // builds everything afresh
    ASSERT_EQ(b2RestoreSnapshot(restored.scene.world, b2SaveSnapshot(pile.scene.world)), nullptr);
    for (int i = 0; i < 30; ++i)
    {
        pile.scene.world.Step(1.0f / 60.0f, 8, 3);
        restored.scene.world.Step(1.0f / 60.0f, 8, 3);
    }
    EXPECT_EQ(pile.Hash(), restored.Hash());
}

/// A cloth has too many loops to be solved directly. Its anchors report its weight.
TEST(SubStepsPile, ReportsReactionsOfHangingNet)
{
    SmallScene s;
    constexpr int kSize = 16;
    b2Body* knots[kSize][kSize];
    float32 weight = 0.0f;
    for (int i = 0; i < kSize; ++i)
    {
        for (int k = 0; k < kSize; ++k)
        {
            knots[i][k] = s.Part(float32(k), -float32(i), 0.1f, 0.1f);
            knots[i][k]->SetAngularDamping(2.0f);
            knots[i][k]->SetLinearDamping(2.0f);
            weight += kGravity * knots[i][k]->GetMass();
            if (k > 0)
            {
                (void)s.Rod(knots[i][k - 1], knots[i][k], knots[i][k - 1]->GetPosition(),
                            knots[i][k]->GetPosition());
            }
            if (i > 0)
            {
                (void)s.Rod(knots[i - 1][k], knots[i][k], knots[i - 1][k]->GetPosition(),
                            knots[i][k]->GetPosition());
            }
            if (i > 0 && k > 0)
            {
                (void)s.Rod(knots[i - 1][k - 1], knots[i][k], knots[i - 1][k - 1]->GetPosition(),
                            knots[i][k]->GetPosition());
            }
        }
    }
    std::vector<b2Joint*> anchors;
    for (int k = 0; k < kSize; ++k)
    {
        anchors.push_back(s.Hinge(s.Post(float32(k), 0.0f), knots[0][k], float32(k), 0.0f));
    }
    s.Step(600);
    float32 held = 0.0f;
    for (b2Joint* anchor : anchors)
    {
        held += anchor->GetReactionForce(60.0f).y;
    }
    EXPECT_NEAR(held, weight, 0.02f * weight);
}

} // namespace
