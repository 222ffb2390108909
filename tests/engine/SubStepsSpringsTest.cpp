// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

/// Springs, in steps of four sub-steps.
namespace
{

using namespace dynamics;

/// An oscillation as a distance from rest, and its expected frequency.
struct Swing
{
    std::function<float32()> way;
    float32 frequency;
};

struct Spring
{
    const char* name;
    Swing (*make)(SmallScene& scene, float32 frequencyHz);
};

Swing MakeHungWeight(SmallScene& s, float32 hz)
{
    b2Body* load = s.Part(0.0f, -5.0f, 0.3f, 0.3f);
    b2DistanceJoint* joint = s.Rod(s.Post(), load, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, -5.0f));
    joint->SetFrequency(hz);
    load->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    const float32 omega = 2.0f * b2_pi * hz;
    const float32 rest = -5.0f - kGravity / (omega * omega);
    return {[load, rest] { return load->GetPosition().y - rest; }, hz};
}

/// In the air, and turning, so that the spring has to hold them against it.
Swing MakeTwoWeights(SmallScene& s, float32 hz)
{
    b2Body* a = s.Part(-2.0f, 0.0f, 0.3f, 0.3f);
    b2Body* b = s.Part(2.0f, 0.0f, 0.2f, 0.2f);
    b2DistanceJoint* joint = s.Rod(a, b, a->GetPosition(), b->GetPosition());
    joint->SetFrequency(hz);
    a->SetLinearVelocity(b2Vec2(-0.5f, 0.0f));
    b->SetLinearVelocity(b2Vec2(0.5f, 0.0f));
    return {[joint] { return Gap(joint) - joint->GetLength(); }, hz};
}

Swing MakeSoftWeld(SmallScene& s, float32 hz)
{
    b2Body* a = s.Part(0.0f, 0.0f);
    b2Body* b = s.Part(0.0f, 0.0f, 0.3f, 0.3f);
    b2WeldJoint* joint = s.Weld(a, b, 0.0f, 0.0f);
    joint->SetFrequency(hz);
    b->SetAngularVelocity(2.0f);
    return {[a, b] { return b->GetAngle() - a->GetAngle(); }, hz};
}

/// The frequency is that of the wheel against the car, both free to move.
Swing MakeWheel(SmallScene& s, float32 hz)
{
    b2Body* car = s.Part(0.0f, 0.0f, 1.0f, 0.3f);
    b2Body* wheel = s.Part(0.0f, -0.5f, 0.3f, 0.3f);
    b2WheelJointDef def;
    def.Initialize(car, wheel, b2Vec2(0.0f, -0.5f), b2Vec2(0.0f, 1.0f));
    def.frequencyHz = hz;
    def.dampingRatio = 0.0f;
    auto* joint = s.Create<b2WheelJoint>(def);
    wheel->SetLinearVelocity(b2Vec2(0.0f, 1.0f));
    return {[joint] { return joint->GetJointTranslation(); }, hz};
}

/// The spring is along an arm that can only slide: the mass it moves is that of both.
Swing MakeSpringOnASlider(SmallScene& s, float32 hz)
{
    b2Body* post = s.Post();
    b2Body* slider = s.Part(1.0f, 0.0f, 0.3f, 0.3f);
    b2Body* load = s.Part(1.0f, 0.5f, 0.2f, 0.2f);
    s.Slider(post, slider, 1.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    s.Weld(slider, load, 1.0f, 0.3f);
    b2DistanceJoint* joint = s.Rod(post, slider, b2Vec2(-4.0f, 0.0f), b2Vec2(1.0f, 0.0f));
    joint->SetFrequency(hz);
    slider->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
    const float32 own = slider->GetMass();
    return {[slider] { return slider->GetPosition().x - 1.0f; },
            hz * std::sqrt(own / (own + load->GetMass()))};
}

struct Case
{
    Spring spring;
    int hz;
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.spring.name << " at " << c.hz << " Hz";
}

class FreeSpring : public testing::TestWithParam<Case>
{};

TEST_P(FreeSpring, KeepsItsFrequencyAndAmplitudeForTwentyPeriods)
{
    const bool falls = std::string(GetParam().spring.name) == "HungWeight";
    SmallScene scene(b2Vec2(0.0f, falls ? -kGravity : 0.0f));
    const Swing swing = GetParam().spring.make(scene, float32(GetParam().hz));
    const double seconds = 21.0 / double(swing.frequency);
    const auto steps = int(seconds * 60.0);
    const int period = int(60.0f / swing.frequency) + 1;
    double first = 0.0;
    double last = 0.0;
    int crossings = -1;
    // A sine sampled at a few points a period shows its top seldom: from the way and its speed.
    float32 amplitude[2] = {};
    float32 before = swing.way();
    const float32 omega = 2.0f * b2_pi * swing.frequency;
    for (int i = 0; i < steps; ++i)
    {
        scene.Step();
        const float32 way = swing.way();
        if (before < 0.0f && way >= 0.0f)
        {
            last = double(i) - double(way) / (double(way) - double(before));
            first = ++crossings == 0 ? last : first;
        }
        // Two points of a sine make its amplitude.
        const float32 turn = omega * kStep;
        const float32 top =
            std::sqrt(way * way + before * before - 2.0f * way * before * std::cos(turn)) /
            std::sin(turn);
        if (i > 0 && i <= period)
        {
            amplitude[0] += top / float32(period);
        }
        if (i >= steps - period)
        {
            amplitude[1] += top / float32(period);
        }
        before = way;
    }
    ASSERT_GE(crossings, 18);
    const double frequency = 60.0 * double(crossings) / (last - first);
    RecordProperty("frequency", std::to_string(frequency / double(swing.frequency)));
    RecordProperty("amplitude", std::to_string(amplitude[1] / amplitude[0]));
    EXPECT_NEAR(frequency, double(swing.frequency), 0.01 * double(swing.frequency));
    EXPECT_NEAR(amplitude[1], amplitude[0], 0.02f * amplitude[0]);
}

std::vector<Case> AllSprings()
{
    std::vector<Case> cases;
    for (const Spring& spring :
         {Spring{"HungWeight", MakeHungWeight}, Spring{"TwoWeights", MakeTwoWeights},
          Spring{"SoftWeld", MakeSoftWeld}, Spring{"Wheel", MakeWheel},
          Spring{"OnASlider", MakeSpringOnASlider}})
    {
        for (int hz = 1; hz <= 5; ++hz)
        {
            cases.push_back({spring, hz});
        }
    }
    return cases;
}

INSTANTIATE_TEST_SUITE_P(SubSteps, FreeSpring, testing::ValuesIn(AllSprings()));

// x = exp(-z w t) (cos(v t) + z w / v sin(v t)),  v = w sqrt(1 - z^2)
TEST(SubStepsSpring, HasItsDampingRatio)
{
    for (const float32 hz : {1.0f, 4.0f})
    {
        for (const float32 ratio : {0.1f, 0.5f, 0.9f})
        {
            SmallScene s(b2Vec2(0.0f, 0.0f));
            b2Body* load = s.Part(0.0f, -5.0f, 0.3f, 0.3f);
            b2DistanceJoint* joint = s.Rod(s.Post(), load, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, -5.0f));
            joint->SetFrequency(hz);
            joint->SetDampingRatio(ratio);
            joint->SetLength(4.0f);
            const float32 omega = 2.0f * b2_pi * hz;
            const float32 turns = omega * std::sqrt(1.0f - ratio * ratio);
            float32 off = 0.0f;
            for (int i = 1; i <= 120; ++i)
            {
                s.Step();
                const float32 t = float32(i) * kStep;
                const float32 way =
                    std::exp(-ratio * omega * t) *
                    (std::cos(turns * t) + ratio * omega / turns * std::sin(turns * t));
                off = b2Max(off, b2Abs(-4.0f - load->GetPosition().y - way));
            }
            EXPECT_LT(off, 0.01f) << hz << " Hz, ratio " << ratio;
            RecordProperty("off " + std::to_string(hz) + " " + std::to_string(ratio),
                           std::to_string(off));
        }
    }
}

// Several on a body, each stiffer than a small step resolves.
TEST(SubStepsSpring, IsStableAtAnyStiffness)
{
    for (const float32 hz : {30.0f, 120.0f, 1000.0f, 1e5f})
    {
        SmallScene s;
        b2Body* load = s.Part(0.0f, 0.0f, 0.3f, 0.3f);
        b2Body* post = s.Post();
        for (const float32 x : {-1.0f, -0.5f, 0.0f, 0.5f, 1.0f})
        {
            b2DistanceJoint* joint =
                s.Rod(post, load, b2Vec2(3.0f * x, 2.0f), b2Vec2(0.2f * x, 0.3f));
            joint->SetFrequency(hz);
        }
        const double before = s.Kinetic();
        load->SetLinearVelocity(b2Vec2(0.5f, 0.0f));
        const double pushed = s.Kinetic() - before;
        double maximum = 0.0;
        for (int i = 0; i < 600; ++i)
        {
            s.Step();
            maximum = std::max(maximum, s.Kinetic());
        }
        EXPECT_LT(maximum, 3.0 * pushed) << hz << " Hz";
        EXPECT_LT(load->GetPosition().Length(), 0.1f) << hz << " Hz";
    }
}

TEST(SubStepsSpring, ComesToRestAtAnyStiffnessWhenDamped)
{
    for (const float32 hz : {10.0f, 100.0f, 1000.0f, 1e5f})
    {
        SmallScene s;
        b2Body* load = s.Part(0.0f, -2.0f, 0.3f, 0.3f);
        b2DistanceJoint* joint = s.Rod(s.Post(), load, b2Vec2(0.0f, 0.0f), b2Vec2(0.0f, -2.0f));
        joint->SetFrequency(hz);
        joint->SetDampingRatio(1.0f);
        load->SetLinearVelocity(b2Vec2(0.0f, -3.0f));
        s.Step(60);
        EXPECT_LT(load->GetLinearVelocity().Length(), 1e-3f) << hz << " Hz";
        const float32 weight = load->GetMass() * kGravity;
        EXPECT_NEAR(joint->GetReactionForce().y, weight, 0.005f * weight) << hz << " Hz";
    }
}

TEST(SubStepsSpring, CanBecomeRigidAndSoftAgain)
{
    SmallScene s;
    b2Body* load = s.Part(0.5f, 0.0f);
    b2WeldJoint* joint = s.Weld(s.Post(), load, 0.0f, 0.0f);
    s.Step(30);
    EXPECT_NEAR(load->GetAngle(), 0.0f, kHeld);
    joint->SetFrequency(1.0f);
    s.Step(15);
    EXPECT_LT(load->GetAngle(), -0.02f);
    joint->SetFrequency(0.0f);
    s.Step(30);
    EXPECT_NEAR(load->GetAngle(), 0.0f, kHeld);
}

TEST(SubStepsMouse, DragsABodyToItsTarget)
{
    SmallScene s;
    b2Body* load = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2MouseJointDef def;
    def.bodyA = s.Post();
    def.bodyB = load;
    def.target.Set(0.0f, 0.5f);
    def.maxForce = 1000.0f * load->GetMass();
    auto* joint = s.Create<b2MouseJoint>(def);
    joint->SetTarget(b2Vec2(2.0f, 1.0f));
    s.Step(1800); // it swings below
    const float32 omega = 2.0f * b2_pi * joint->GetFrequency();
    const b2Vec2 target(2.0f, 1.0f - kGravity / (omega * omega));
    EXPECT_LT(b2Distance(joint->GetAnchorB(), target), 2e-3f);
    const float32 weight = load->GetMass() * kGravity;
    EXPECT_NEAR(joint->GetReactionForce().y, weight, 0.005f * weight);
}

TEST(SubStepsMouse, PullsWithAtMostItsMaximumForce)
{
    SmallScene s(b2Vec2(0.0f, 0.0f));
    b2Body* load = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2MouseJointDef def;
    def.bodyA = s.Post();
    def.bodyB = load;
    def.target.Set(0.0f, 0.0f);
    def.maxForce = 2.0f * load->GetMass();
    auto* joint = s.Create<b2MouseJoint>(def);
    joint->SetTarget(b2Vec2(30.0f, 40.0f));
    s.Step(60);
    EXPECT_NEAR(load->GetLinearVelocity().x, 1.2f, 0.01f);
    EXPECT_NEAR(load->GetLinearVelocity().y, 1.6f, 0.01f);
    EXPECT_NEAR(joint->GetReactionForce().Length(), 2.0f * load->GetMass(), 1e-3f);
}

} // namespace
