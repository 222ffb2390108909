// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <Box2D/Dynamics/b2Snapshot.h>

#include <limits>
#include <string>

/// Distance joints between a minimum and a maximum length, with one step and with sub-steps.
namespace
{

using namespace dynamics;

constexpr float32 kInfinity = std::numeric_limits<float32>::infinity();

/// A load that hangs below a post, or is supported above it.
struct Hanger : JointScene
{
    Hanger(int32 subSteps, float32 y, const b2DistanceJointDef& numbers)
    {
        world.SetSubStepCount(subSteps);
        load = Load(0.0f, y);
        b2DistanceJointDef def = numbers;
        def.bodyA = Post();
        def.bodyB = load;
        joint = Create<b2DistanceJoint>(def);
    }
    float32 Length() const { return joint->GetCurrentLength(); }
    float32 Pull() const { return joint->GetReactionForce(1.0f / kStep).y; }

    b2Body* load;
    b2DistanceJoint* joint;
};

b2DistanceJointDef Numbers(float32 minLength, float32 maxLength, float32 frequencyHz = 0.0f)
{
    b2DistanceJointDef def;
    def.length = 3.0f;
    def.minLength = minLength;
    def.maxLength = maxLength;
    def.frequencyHz = frequencyHz;
    def.dampingRatio = 0.5f;
    return def;
}

class DistanceLimits : public testing::TestWithParam<int32>
{};

TEST_P(DistanceLimits, LeaveTheLengthFreeBetweenThem)
{
    Hanger h(GetParam(), -1.0f, Numbers(0.5f, 8.0f));
    h.Step(60); // falls 5 m
    EXPECT_NEAR(h.load->GetLinearVelocity().y, -kGravity, 1e-3f);
    EXPECT_NEAR(h.Length(), 6.0f, 0.1f);
    EXPECT_EQ(h.Pull(), 0.0f);
}

TEST_P(DistanceLimits, HoldALoadAtTheMaximum)
{
    Hanger h(GetParam(), -1.0f, Numbers(0.0f, 4.0f));
    for (int i = 0; i < 300; ++i)
    {
        h.Step();
        ASSERT_LT(h.Length(), 4.0f + 2.0f * b2_linearSlop) << i;
    }
    EXPECT_NEAR(h.Length(), 4.0f, b2_linearSlop);
    EXPECT_NEAR(h.Pull(), kGravity, 0.01f) << "the weight of 1 kg";
}

TEST_P(DistanceLimits, HoldALoadAtTheMinimum)
{
    Hanger h(GetParam(), 3.0f, Numbers(2.0f, b2_maxFloat));
    for (int i = 0; i < 60; ++i)
    {
        h.Step();
        ASSERT_GT(h.Length(), 2.0f - 2.0f * b2_linearSlop) << i;
    }
    EXPECT_NEAR(h.Length(), 2.0f, 2.0f * b2_linearSlop);
    EXPECT_NEAR(h.Pull(), kGravity, 0.1f);
}

TEST_P(DistanceLimits, HoldALoadThatASpringDoesNot)
{
    // A spring of f Hz sags by g / (2 pi f)^2: 1.01 m here.
    const b2DistanceJointDef soft = Numbers(2.5f, 3.4f, 0.5f);
    Hanger h(GetParam(), -3.0f, soft);
    for (int i = 0; i < 600; ++i)
    {
        h.Step();
        ASSERT_GT(h.Length(), 2.5f - 2.0f * b2_linearSlop) << i;
        ASSERT_LT(h.Length(), 3.4f + 2.0f * b2_linearSlop) << i;
    }
    EXPECT_NEAR(h.Length(), 3.4f, b2_linearSlop);
    EXPECT_NEAR(h.Pull(), kGravity, 0.02f) << "spring and limit together";
}

TEST_P(DistanceLimits, LeaveASpringAloneBetweenThem)
{
    Hanger limited(GetParam(), -3.2f, Numbers(1.0f, 6.0f, 1.0f));
    Hanger plain(GetParam(), -3.2f, Numbers(0.0f, b2_maxFloat, 1.0f));
    for (int i = 0; i < 300; ++i)
    {
        limited.Step();
        plain.Step();
        ASSERT_NEAR(limited.Length(), plain.Length(), 1e-3f) << i;
    }
}

TEST_P(DistanceLimits, MakeARodWhenEqual)
{
    Hanger h(GetParam(), -3.4f, Numbers(3.4f, 3.4f, 1.0f));
    EXPECT_FALSE(h.joint->IsSpring());
    h.load->SetLinearVelocity(b2Vec2(2.0f, 0.0f));
    for (int i = 0; i < 300; ++i)
    {
        h.Step();
        ASSERT_NEAR(h.Length(), 3.4f, 2.0f * b2_linearSlop) << i;
    }
}

TEST_P(DistanceLimits, GainNoEnergy)
{
    Hanger h(GetParam(), -2.0f, Numbers(1.0f, 3.0f));
    h.load->SetLinearVelocity(b2Vec2(6.0f, 0.0f));
    const auto energy = [&] {
        const float32 w = h.load->GetAngularVelocity();
        return 0.5f * h.load->GetLinearVelocity().LengthSquared() +
               0.5f * h.load->GetInertia() * w * w + kGravity * h.load->GetPosition().y;
    };
    float32 before = energy();
    for (int i = 0; i < 600; ++i)
    {
        h.Step();
        const float32 now = energy();
        ASSERT_LT(now, before + 0.3f) << i;
        before = b2Min(before, now);
    }
}

// Sub-steps find a limit within a drift of up to 70 m/s, like ropes: only Shake's own checks.
TEST_P(DistanceLimits, HoldWhileTheLoadIsShaken)
{
    const float32 maximum = GetParam() == 1 ? 3.0f + 4.0f * b2_linearSlop : b2_maxFloat;
    for (const float32 frequency : {0.0f, 4.0f})
    {
        Hanger h(GetParam(), -2.0f, Numbers(1.0f, 3.0f, frequency));
        h.Shake(h.load, 600, [&] { EXPECT_LT(h.Length(), maximum); });
    }
}

TEST_P(DistanceLimits, ContinueFromASnapshotToTheLastBit)
{
    Hanger h(GetParam(), -2.0f, Numbers(1.0f, 3.0f, 0.4f));
    h.Step(90);
    const std::vector<uint8> bytes = b2SaveSnapshot(h.world);
    h.Step(60);
    const b2Vec2 there = h.load->GetPosition();
    b2World again(b2Vec2(0.0f, 0.0f));
    ASSERT_EQ(b2RestoreSnapshot(again, bytes), nullptr);
    for (int i = 0; i < 60; ++i)
    {
        again.Step(kStep, 8, 3);
    }
    EXPECT_EQ(again.GetJointList()->GetBodyB()->GetPosition(), there);
    const auto& joint = static_cast<const b2DistanceJoint&>(*again.GetJointList());
    EXPECT_EQ(joint.GetMinLength(), 1.0f);
    EXPECT_EQ(joint.GetMaxLength(), 3.0f);
}

INSTANTIATE_TEST_SUITE_P(SubSteps, DistanceLimits, testing::Values(1, 4));

TEST(DistanceLimitsTogether, AreSolvedAsAlone)
{
    // Eight at once, of all kinds: a block of lanes. Alone each is a lane by itself.
    const b2DistanceJointDef kinds[] = {
        Numbers(0.0f, b2_maxFloat), Numbers(0.0f, b2_maxFloat, 1.0f), Numbers(1.0f, 3.2f),
        Numbers(1.0f, 3.2f, 0.4f),  Numbers(3.2f, 3.2f, 1.0f),        Numbers(0.0f, 2.0f),
        Numbers(3.5f, b2_maxFloat), Numbers(2.9f, 3.1f, 0.2f)};
    JointScene together;
    std::vector<b2Body*> loads;
    for (const b2DistanceJointDef& numbers : kinds)
    {
        const float32 x = 10.0f * float32(loads.size());
        loads.push_back(together.Load(x, -3.0f));
        b2DistanceJointDef def = numbers;
        def.bodyA = together.Post(x);
        def.bodyB = loads.back();
        together.Create<b2DistanceJoint>(def);
    }
    std::vector<b2Vec2> ends;
    for (std::size_t i = 0; i < std::size(kinds); ++i)
    {
        JointScene alone;
        const float32 x = 10.0f * float32(i);
        b2Body* load = alone.Load(x, -3.0f);
        b2DistanceJointDef def = kinds[i];
        def.bodyA = alone.Post(x);
        def.bodyB = load;
        alone.Create<b2DistanceJoint>(def);
        load->SetLinearVelocity(b2Vec2(1.0f, 2.0f));
        alone.Step(200);
        ends.push_back(load->GetPosition());
    }
    for (b2Body* load : loads)
    {
        load->SetLinearVelocity(b2Vec2(1.0f, 2.0f));
    }
    together.Step(200);
    for (std::size_t i = 0; i < loads.size(); ++i)
    {
        EXPECT_EQ(loads[i]->GetPosition(), ends[i]) << i;
    }
}

TEST(DistanceLimitsDefinition, IsClampedAsIn24)
{
    const struct
    {
        float32 minimum, maximum, clampedLeast, clampedMost;
    } cases[] = {{5.0f, 2.0f, 5.0f, 5.0f},
                 {-1.0f, 4.0f, b2_linearSlop, 4.0f},
                 {0.0f, 4.0f, b2_linearSlop, 4.0f},
                 {0.0f, 0.0f, b2_linearSlop, b2_linearSlop},
                 {-2.0f, -3.0f, b2_linearSlop, b2_linearSlop},
                 {-1.0f, b2_maxFloat, b2_linearSlop, b2_maxFloat},
                 {0.0f, kInfinity, 0.0f, b2_maxFloat},
                 {2.0f, kInfinity, 2.0f, b2_maxFloat},
                 {2.0f, 2.0f, 2.0f, 2.0f}};
    for (const auto& c : cases)
    {
        Hanger h(1, -3.0f, Numbers(c.minimum, c.maximum));
        ASSERT_NE(h.joint, nullptr) << c.minimum << ' ' << c.maximum;
        EXPECT_EQ(h.joint->GetMinLength(), c.clampedLeast) << c.minimum << ' ' << c.maximum;
        EXPECT_EQ(h.joint->GetMaxLength(), c.clampedMost) << c.minimum << ' ' << c.maximum;
    }
}

TEST(DistanceLimitsDefinition, IsARodWithALengthAloneAsIn23)
{
    Hanger rod(1, -3.0f, Numbers(0.0f, b2_maxFloat));
    Hanger loose(1, -3.0f, Numbers(b2_linearSlop, b2_maxFloat)); // what 2.4 makes of it
    rod.Step(60);
    loose.Step(60);
    EXPECT_NEAR(rod.Length(), 3.0f, b2_linearSlop);
    EXPECT_NEAR(loose.Length(), 8.0f, 0.1f) << "free fall";
}

TEST(DistanceLimitsSetters, ClampToTheSlopAndLeaveFree)
{
    for (const bool setsMinimum : {true, false})
    {
        Hanger h(1, -3.0f, Numbers(0.0f, b2_maxFloat)); // a rod until they are called
        EXPECT_EQ(setsMinimum ? h.joint->SetMinLength(-1.0f) : h.joint->SetMaxLength(b2_maxFloat),
                  setsMinimum ? b2_linearSlop : b2_maxFloat);
        EXPECT_EQ(h.joint->GetMinLength(), b2_linearSlop);
        h.Step(60);
        EXPECT_NEAR(h.Length(), 8.0f, 0.1f) << "free fall";
    }
}

TEST(DistanceLimitsSetters, KeepTheMinimumBelowTheMaximum)
{
    Hanger h(1, -2.0f, Numbers(1.0f, 3.0f));
    EXPECT_EQ(h.joint->SetMinLength(5.0f), 3.0f);
    EXPECT_EQ(h.joint->GetMinLength(), 3.0f);
    EXPECT_EQ(h.joint->SetMinLength(2.0f), 2.0f);
    EXPECT_EQ(h.joint->SetMaxLength(1.0f), 2.0f);
    EXPECT_EQ(h.joint->SetMaxLength(b2_maxFloat), b2_maxFloat);
    EXPECT_EQ(h.joint->SetMaxLength(-1.0f), 2.0f);
    EXPECT_EQ(h.joint->SetMaxLength(kInfinity), b2_maxFloat);
    EXPECT_EQ(h.joint->GetMaxLength(), b2_maxFloat);
}

TEST(DistanceJointLength, IsReturnedAndKeptBelowTheSlop)
{
    b2DistanceJointDef def = Numbers(0.0f, b2_maxFloat);
    def.length = 0.0f;
    Hanger h(1, -3.0f, def);
    EXPECT_EQ(h.joint->GetLength(), 0.0f);
    EXPECT_EQ(h.joint->SetLength(2.0f), 2.0f);
    EXPECT_EQ(h.joint->SetLength(0.25f * b2_linearSlop), 0.25f * b2_linearSlop);
    EXPECT_EQ(h.joint->GetLength(), 0.25f * b2_linearSlop);
}

TEST(DistanceLimitsSetters, WakeTheBodiesThatTheyMove)
{
    for (const int32 subSteps : {1, 4})
    {
        Hanger h(subSteps, -3.0f, Numbers(0.0f, 3.0f));
        h.load->SetSleepingAllowed(true);
        h.Step(300);
        ASSERT_FALSE(h.load->IsAwake());
        h.joint->SetMaxLength(4.0f);
        EXPECT_TRUE(h.load->IsAwake());
        h.Step(300);
        EXPECT_NEAR(h.Length(), 4.0f, b2_linearSlop);
        ASSERT_FALSE(h.load->IsAwake());
        h.joint->SetMinLength(4.0f); // rigid
        EXPECT_TRUE(h.load->IsAwake());
    }
}

std::string s_log;

void Collect(const char* text)
{
    s_log += text;
}

TEST(DistanceLimitsDump, NamesLimitsOnlyWhereThereAreSome)
{
    b2SetLog(Collect);
    s_log.clear();
    Hanger(1, -2.0f, Numbers(0.0f, b2_maxFloat)).joint->Dump();
    EXPECT_EQ(s_log.find("Length"), std::string::npos);
    Hanger(1, -2.0f, Numbers(0.0f, 3.0f)).joint->Dump();
    b2SetLog(nullptr);
    EXPECT_NE(s_log.find("jd.minLength = "), std::string::npos);
    EXPECT_NE(s_log.find("jd.maxLength = 3."), std::string::npos);
}

TEST(Stiffness, EqualsThatOfAHarmonicOscillator)
{
    JointScene scene;
    b2Body* a = scene.Load(0.0f, 0.0f);              // 1 kg
    b2Body* b = scene.Load(2.0f, 0.0f, 1.0f, 0.75f); // 3 kg
    float32 stiffness = 0.0f;
    float32 damping = 0.0f;
    b2LinearStiffness(stiffness, damping, 2.0f, 0.5f, a, b);
    const float32 omega = 4.0f * b2_pi;
    EXPECT_NEAR(stiffness, 0.75f * omega * omega, 1e-3f);
    EXPECT_NEAR(damping, 0.75f * omega, 1e-4f);
    b2LinearStiffness(stiffness, damping, 2.0f, 0.5f, scene.Post(), b);
    EXPECT_NEAR(stiffness, 3.0f * omega * omega, 1e-3f) << "one that does not move";
    b2AngularStiffness(stiffness, damping, 2.0f, 0.5f, a, scene.Post());
    EXPECT_NEAR(stiffness, a->GetInertia() * omega * omega, 1e-3f);
    EXPECT_NEAR(damping, a->GetInertia() * omega, 1e-4f);
}

} // namespace
