// SPDX-License-Identifier: MIT
#include "SubStepsScene.h"

/// Rigid joints in steps of four sub-steps: they stay rigid and lose no energy.
namespace
{

using namespace dynamics;

template <class Case>
std::string NameOf(const testing::TestParamInfo<Case>& one)
{
    return one.param.name;
}

using Error = std::function<float32()>; ///< of what a joint holds [m], [rad]

/// Two bodies in the air, and what holds them.
struct Pair
{
    const char* name;
    Error (*make)(SmallScene& scene, b2Body* a, b2Body* b);
};

Error MakeHinge(SmallScene& s, b2Body* a, b2Body* b)
{
    return [joint = s.Hinge(a, b, 0.5f, 0.2f)] { return Gap(joint); };
}

Error MakeSlider(SmallScene& s, b2Body* a, b2Body* b)
{
    b2PrismaticJoint* joint = s.Slider(a, b, 0.5f, 0.2f, b2Vec2(0.6f, 0.8f));
    joint->EnableLimit(true);
    joint->SetLimits(-2.0f, 2.0f);
    return [joint] { return b2Max(Across(joint, b2Vec2(0.6f, 0.8f)), Turned(joint)); };
}

Error MakeRod(SmallScene& s, b2Body* a, b2Body* b)
{
    b2DistanceJoint* joint = s.Rod(a, b, b2Vec2(0.0f, 0.1f), b2Vec2(1.4f, 0.1f));
    return [joint] { return b2Abs(Gap(joint) - joint->GetLength()); };
}

Error MakeWeld(SmallScene& s, b2Body* a, b2Body* b)
{
    return [joint = s.Weld(a, b, 0.5f, 0.2f)] { return b2Max(Gap(joint), Turned(joint)); };
}

Error MakeWheel(SmallScene& s, b2Body* a, b2Body* b)
{
    b2WheelJointDef def;
    def.Initialize(a, b, b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, 1.0f));
    def.frequencyHz = 2.0f;
    def.dampingRatio = 0.0f;
    auto* joint = s.Create<b2WheelJoint>(def);
    return [joint] { return Across(joint, b2Vec2(0.0f, 1.0f)); };
}

class HeldPair : public testing::TestWithParam<Pair>
{
protected:
    HeldPair()
        : scene(b2Vec2(0.0f, 0.0f)), a(scene.Part(0.0f, 0.0f)),
          b(scene.Part(1.0f, 0.0f, 0.3f, 0.2f)), error(GetParam().make(scene, a, b))
    {
        a->SetLinearVelocity(b2Vec2(0.3f, -1.0f));
        b->SetLinearVelocity(b2Vec2(-0.2f, 1.5f));
        a->SetAngularVelocity(2.0f);
        b->SetAngularVelocity(-1.0f);
        scene.Step(); // what the joint does not allow is gone
    }

    SmallScene scene;
    b2Body* a;
    b2Body* b;
    Error error;
};

TEST_P(HeldPair, StaysTogetherInTheAir)
{
    for (int i = 0; i < 600; ++i)
    {
        scene.Step();
        ASSERT_LT(error(), kHeld) << "step " << i;
    }
}

TEST_P(HeldPair, KeepsMomentumAndSpin)
{
    const b2Vec2 momentum = scene.Momentum();
    const float32 spin = scene.Spin();
    ASSERT_GT(b2Abs(spin), 0.1f);
    scene.Step(600);
    EXPECT_LT(b2Distance(scene.Momentum(), momentum), 1e-4f);
    EXPECT_NEAR(scene.Spin(), spin, 1e-4f);
}

TEST_P(HeldPair, StaysClosedWhenShaken)
{
    for (int i = 0; i < 600; ++i)
    {
        b->ApplyForceToCenter(30.0f * b->GetMass() * b2Vec2(scene.Random(), scene.Random()));
        b->ApplyTorque(30.0f * b->GetInertia() * scene.Random());
        scene.Step();
        ASSERT_LT(error(), kHeld) << "step " << i;
    }
}

TEST_P(HeldPair, ClosesAgainAfterItWasOpened)
{
    b->SetTransform(b->GetPosition() + b2Vec2(0.01f, 0.02f), b->GetAngle() + 0.02f);
    const double before = scene.Kinetic();
    scene.Step(60);
    EXPECT_LT(error(), kHeld);
    EXPECT_LT(scene.Kinetic(), 1.5 * before);
}

INSTANTIATE_TEST_SUITE_P(SubSteps, HeldPair,
                         testing::Values(Pair{"Hinge", MakeHinge}, Pair{"Slider", MakeSlider},
                                         Pair{"Rod", MakeRod}, Pair{"Weld", MakeWeld},
                                         Pair{"Wheel", MakeWheel}),
                         NameOf<Pair>);

/// A machine that runs without friction below gravity.
struct Machine
{
    const char* name;
    Error (*make)(SmallScene& scene);
};

Error Largest(std::vector<Error> errors)
{
    return [errors = std::move(errors)] {
        float32 largest = 0.0f;
        for (const Error& error : errors)
        {
            largest = b2Max(largest, error());
        }
        return largest;
    };
}

Error MakeDoublePendulum(SmallScene& s)
{
    b2Body* a = s.Part(0.5f, 0.0f);
    b2Body* b = s.Part(1.5f, 0.0f);
    return Largest({[joint = s.Hinge(s.Post(), a, 0.0f, 0.0f)] { return Gap(joint); },
                    [joint = s.Hinge(a, b, 1.0f, 0.0f)] { return Gap(joint); }});
}

Error MakeRodPendulum(SmallScene& s)
{
    b2Body* a = s.Part(1.0f, 0.0f, 0.2f, 0.2f);
    b2Body* b = s.Part(2.0f, 0.0f, 0.2f, 0.2f);
    b2DistanceJoint* first = s.Rod(s.Post(), a, b2Vec2(0.0f, 0.0f), b2Vec2(0.9f, 0.0f));
    b2DistanceJoint* second = s.Rod(a, b, b2Vec2(1.1f, 0.0f), b2Vec2(2.0f, 0.0f));
    return Largest({[first] { return b2Abs(Gap(first) - first->GetLength()); },
                    [second] { return b2Abs(Gap(second) - second->GetLength()); }});
}

Error MakeWeldedPendulum(SmallScene& s)
{
    b2Body* a = s.Part(0.5f, 0.0f);
    b2Body* b = s.Part(1.5f, 0.0f);
    b2Body* c = s.Part(1.5f, 0.6f, 0.1f, 0.5f);
    s.Hinge(s.Post(), a, 0.0f, 0.0f);
    return Largest(
        {[joint = s.Weld(a, b, 1.0f, 0.0f)] { return b2Max(Gap(joint), Turned(joint)); },
         [joint = s.Weld(b, c, 1.5f, 0.1f)] { return b2Max(Gap(joint), Turned(joint)); }});
}

/// A slider on an arm that swings, drawn to the middle by a weight on the arm's other side.
Error MakeSliderOnAnArm(SmallScene& s)
{
    b2Body* arm = s.Part(0.0f, 0.0f, 1.0f, 0.05f);
    b2Body* slider = s.Part(0.8f, 0.0f, 0.1f, 0.1f);
    s.Hinge(s.Post(), arm, 0.0f, 0.0f);
    arm->SetAngularVelocity(0.3f);
    b2PrismaticJoint* joint = s.Slider(arm, slider, 0.8f, 0.0f, b2Vec2(1.0f, 0.0f));
    return [joint] { return b2Max(Across(joint, b2Vec2(1.0f, 0.0f)), Turned(joint)); };
}

/// Both weights swing on their ropes, and one goes down.
Error MakePulley(SmallScene& s)
{
    b2Body* a = s.Part(-2.0f, 0.0f, 0.2f, 0.2f);
    b2Body* b = s.Part(2.0f, 0.0f, 0.2f, 0.21f);
    b2PulleyJointDef def;
    def.Initialize(a, b, b2Vec2(-2.0f, 10.0f), b2Vec2(2.0f, 10.0f), b2Vec2(-2.0f, 0.2f),
                   b2Vec2(2.0f, 0.2f), 1.0f);
    auto* joint = s.Create<b2PulleyJoint>(def);
    a->SetLinearVelocity(b2Vec2(2.0f, 0.0f));
    b->SetLinearVelocity(b2Vec2(-1.0f, 0.0f));
    const float32 sum = def.lengthA + def.lengthB;
    return [joint, sum] {
        return b2Abs(joint->GetCurrentLengthA() + joint->GetCurrentLengthB() - sum);
    };
}

/// Two pendulums on a third that turns, geared 1 to 2: all four bodies of the gear move, one twice.
Error MakeGear(SmallScene& s)
{
    b2Body* frame = s.Part(0.0f, 0.0f, 1.0f, 0.1f);
    b2Body* a = s.Part(-1.0f, -0.5f, 0.1f, 0.5f);
    b2Body* b = s.Part(1.4f, 0.0f, 0.4f, 0.1f);
    s.Hinge(s.Post(), frame, 0.0f, 0.0f);
    b2GearJointDef def;
    def.joint1 = s.Hinge(frame, a, -1.0f, 0.0f);
    def.joint2 = s.Hinge(frame, b, 1.0f, 0.0f);
    def.bodyA = a;
    def.bodyB = b;
    def.ratio = 2.0f;
    s.Create<b2GearJoint>(def);
    return [first = def.joint1, second = def.joint2] {
        return b2Abs(static_cast<b2RevoluteJoint*>(first)->GetJointAngle() +
                     2.0f * static_cast<b2RevoluteJoint*>(second)->GetJointAngle());
    };
}

/// A wheel that rolls along a rack suspended by a spring.
Error MakeRack(SmallScene& s)
{
    b2Body* wheel = s.Part(0.0f, 0.0f, 0.5f, 0.5f);
    b2Body* rack = s.Part(0.5f, 0.0f, 0.1f, 1.0f);
    b2Body* post = s.Post();
    b2GearJointDef def;
    def.joint1 = s.Hinge(post, wheel, 0.0f, 0.0f);
    def.joint2 = s.Slider(post, rack, 0.5f, 0.0f, b2Vec2(0.0f, 1.0f));
    def.bodyA = wheel;
    def.bodyB = rack;
    def.ratio = -2.0f;
    s.Create<b2GearJoint>(def);
    rack->SetLinearVelocity(b2Vec2(0.0f, 20.0f));
    wheel->SetAngularVelocity(40.0f);
    return [first = def.joint1, second = def.joint2] {
        return b2Abs(static_cast<b2RevoluteJoint*>(first)->GetJointAngle() -
                     2.0f * static_cast<b2PrismaticJoint*>(second)->GetJointTranslation());
    };
}

/// A crank drives a rocker over a rod: a closed loop.
Error MakeFourBars(SmallScene& s)
{
    b2Body* post = s.Post();
    b2Body* crank = s.Part(0.0f, 0.25f, 0.05f, 0.25f);
    b2Body* rod = s.Part(0.75f, 0.75f, 0.8f, 0.05f);
    b2Body* rocker = s.Part(1.5f, 0.5f, 0.05f, 0.5f);
    crank->SetAngularVelocity(6.0f);
    return Largest({[joint = s.Hinge(post, crank, 0.0f, 0.0f)] { return Gap(joint); },
                    [joint = s.Hinge(crank, rod, 0.0f, 0.5f)] { return Gap(joint); },
                    [joint = s.Hinge(rod, rocker, 1.5f, 1.0f)] { return Gap(joint); },
                    [joint = s.Hinge(post, rocker, 1.5f, 0.0f)] { return Gap(joint); }});
}

/// Every part carries two more.
Error MakeTree(SmallScene& s)
{
    std::vector<b2Body*> bodies{s.Part(0.0f, -0.5f, 0.05f, 0.5f)};
    std::vector<Error> errors{
        [joint = s.Hinge(s.Post(), bodies[0], 0.0f, 0.0f)] { return Gap(joint); }};
    for (std::size_t i = 1; i < 15; ++i)
    {
        b2Body* parent = bodies[(i - 1) / 2];
        const b2Vec2 tip = parent->GetWorldPoint(b2Vec2(0.0f, -0.5f));
        const float32 side = i % 2 == 0 ? 0.3f : -0.3f;
        b2Body* body =
            s.Body(b2_dynamicBody, tip.x + side, tip.y - 0.4f, 0.6435f * (side < 0 ? -1.0f : 1.0f));
        Scene::AddBox(body, 0.05f, 0.5f);
        body->GetFixtureList()->SetSensor(true);
        body->SetSleepingAllowed(false);
        s.parts.push_back(body);
        bodies.push_back(body);
        errors.push_back([joint = s.Hinge(parent, body, tip.x, tip.y)] { return Gap(joint); });
    }
    bodies[0]->SetAngularVelocity(2.0f);
    return Largest(errors);
}

class HeldMachine : public testing::TestWithParam<Machine>
{};

TEST_P(HeldMachine, StaysTogetherAndKeepsItsEnergy)
{
    SmallScene scene;
    const Error error = GetParam().make(scene);
    scene.Step(); // what the joints do not allow is gone
    const double before = scene.Energy();
    double maximum = scene.Kinetic();
    double off = 0.0;
    float32 worst = 0.0f;
    for (int i = 0; i < 600; ++i)
    {
        scene.Step();
        maximum = std::max(maximum, scene.Kinetic());
        off = std::max(off, std::abs(scene.Energy() - before));
        worst = b2Max(worst, error());
    }
    EXPECT_LT(worst, kHeld);
    EXPECT_LT(off, 0.005 * maximum);
    RecordProperty("gap", std::to_string(worst * 1e6f) + " um");
    RecordProperty("energy", std::to_string(100.0 * off / maximum) + " %");
}

INSTANTIATE_TEST_SUITE_P(SubSteps, HeldMachine,
                         testing::Values(Machine{"DoublePendulum", MakeDoublePendulum},
                                         Machine{"RodPendulum", MakeRodPendulum},
                                         Machine{"WeldedPendulum", MakeWeldedPendulum},
                                         Machine{"SliderOnAnArm", MakeSliderOnAnArm},
                                         Machine{"Pulley", MakePulley}, Machine{"Gear", MakeGear},
                                         Machine{"Rack", MakeRack},
                                         Machine{"FourBars", MakeFourBars},
                                         Machine{"Tree", MakeTree}),
                         NameOf<Machine>);

/// A weld drifts several times in a sub-step, and the platform has to be where it is then. It left
/// the box turned by 0.3 rad, and 0.28 m off if the joint was beside the axis.
TEST(SubStepsWeld, HoldsABoxOnASpinningPlatform)
{
    for (const int32 count : {2, 4, 8})
    {
        for (const float32 speed : {20.0f, 30.0f, 60.0f})
        {
            SmallScene s(b2Vec2(0.0f, 0.0f), count);
            b2Body* platform = s.Body(b2_kinematicBody, 0.0f, 0.0f);
            platform->SetAngularVelocity(speed);
            b2Body* box = s.Part(2.0f, 0.0f, 0.2f, 0.2f);
            box->SetLinearVelocity(b2Vec2(0.0f, 2.0f * speed));
            box->SetAngularVelocity(speed);
            const b2Joint* weld = s.Weld(platform, box, 1.0f, 0.0f);
            s.Step(120);
            EXPECT_LT(Gap(weld), 1e-3f) << count << " sub-steps, " << speed << " rad/s";
            EXPECT_NEAR(box->GetAngle(), platform->GetAngle(), 1e-3f) << count << ", " << speed;
        }
    }
}

/// A hinge with a rod between the centres of its links, as long as the straight pose. There the rod
/// and the hinge hold the same direction, and closing them took ever larger velocities. In free
/// flight the energy grew by up to 145 % with 8 sub-steps.
TEST(SubStepsKnee, GainsNothingWhereARodHoldsItStraight)
{
    for (const int32 count : {2, 4, 8})
    {
        for (int i = 0; i < 40; ++i)
        {
            SmallScene s(b2Vec2(0.0f, -kGravity), count);
            const float32 angle = 0.15f * float32(i) - 3.0f;
            const float32 spin = 0.25f * float32(i) - 5.0f;
            const b2Vec2 axis(std::cos(angle), std::sin(angle));
            b2Body* links[2];
            for (int k = 0; k < 2; ++k)
            {
                const b2Vec2 place = 0.6f * float32(k) * axis;
                links[k] = s.Part(place.x, place.y, 0.3f, 0.1f);
                links[k]->SetTransform(place, angle);
                links[k]->SetAngularVelocity(spin);
                links[k]->SetLinearVelocity(b2Vec2(2.0f, -4.0f) + b2Cross(spin, place));
            }
            (void)s.Hinge(links[0], links[1], 0.3f * axis.x, 0.3f * axis.y);
            (void)s.Rod(links[0], links[1], links[0]->GetPosition(), links[1]->GetPosition());
            const double start = s.Energy();
            double most = start;
            for (int step = 0; step < 60; ++step)
            {
                s.Step();
                most = b2Max(most, s.Energy());
            }
            EXPECT_LT(most - start, 0.02 * s.Kinetic())
                << count << " sub-steps, " << spin << " rad/s";
        }
    }
}

/// The ball does not rotate, but its rod does: by up to 0.4 rad a drift. What closing the rod adds
/// for that is no gain.
TEST(SubStepsRod, KeepsTheSpeedOfABallThatTurnsFast)
{
    for (const int32 count : {2, 4, 8, 16})
    {
        SmallScene s(b2Vec2_zero, count);
        b2Body* ball = s.Part(1.0f, 0.0f, 0.1f, 0.1f);
        (void)s.Rod(s.Post(), ball, b2Vec2_zero, b2Vec2(1.0f, 0.0f));
        const float32 speed = count == 2 ? 50.0f : 90.0f;
        ball->SetLinearVelocity(b2Vec2(0.0f, speed));
        s.Step(60);
        EXPECT_NEAR(ball->GetLinearVelocity().Length(), speed, 0.001f * speed) << count;
    }
}

} // namespace
