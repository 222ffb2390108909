// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Moving bodies never fall asleep, and bodies at rest soon do.
namespace
{

using namespace stability;

STABILITY_SUITE(Sleep);

/// Returns the time that any body sleeps in this many seconds [s].
double Asleep(Trial& trial, double seconds)
{
    double asleep = 0.0;
    trial.Run(seconds, [&](double) {
        for (const b2Body* b = trial.world.GetBodyList(); b; b = b->GetNext())
        {
            if (b->GetType() == b2_dynamicBody && !b->IsAwake())
            {
                asleep += double(kStep);
                break;
            }
        }
    });
    return asleep;
}

void JudgeAwake(Trial& trial, const std::string& name, double seconds = 30.0)
{
    Judge("asleep: " + name, trial.world.GetSubStepCount(), Asleep(trial, seconds), "s", 0.0);
}

/// Reasonable for small bodies that are set down gently [s].
constexpr double kSoon = 5.0;

/// When the last one falls asleep [s]; none when it does not.
void JudgeRest(Trial& trial, const std::string& name, double bound)
{
    double last = 0.0;
    trial.Run(30.0, [&](double time) {
        for (const b2Body* b = trial.world.GetBodyList(); b; b = b->GetNext())
        {
            last = b->GetType() == b2_dynamicBody && b->IsAwake() ? time : last;
        }
    });
    Judge("at rest: " + name, trial.world.GetSubStepCount(), last, "s", bound);
}

/// A body of a machine that may sleep and collides with nothing.
b2Body* Sleeper(Trial& trial, float32 x, float32 y, float32 hx = 0.5f, float32 hy = 0.1f)
{
    b2Body* body = trial.Part(x, y, hx, hy);
    body->SetSleepingAllowed(true);
    return body;
}

TEST_P(Sleep, NeverComesToASlowSlider)
{
    for (const float32 speed : {0.02f, 0.011f})
    {
        Trial trial(GetParam());
        Scene::AddBox(trial.Body(b2_staticBody, 0.0f, -1.0f), 50.0f, 1.0f, 0.0f);
        b2Body* box = trial.Body(b2_dynamicBody, 0.0f, 0.5f + kRestingGap);
        Scene::AddBox(box, 0.5f, 0.5f, 0.0f);
        box->SetLinearVelocity(b2Vec2(speed, 0.0f));
        const double way = 60.0 * double(speed);
        JudgeAwake(trial, "slides at " + std::to_string(speed) + " m/s", 60.0);
        Judge("slides at " + std::to_string(speed) + " m/s, way off", GetParam(),
              100.0 * std::abs(double(box->GetPosition().x) / way - 1.0), "%", 1.0);
    }
}

TEST_P(Sleep, NeverComesToASlowSpin)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    trial.Box(0.0f, 0.0f)->SetAngularVelocity(0.036f);
    JudgeAwake(trial, "spins at 0.036 rad/s");
}

/// A pendulum of this length and amplitude; it is slow for a long time where it reverses.
TEST_P(Sleep, NeverComesToAPendulumThatReverses)
{
    struct Swing
    {
        float32 length, amplitude; // [m]
    };
    for (const Swing swing : {Swing{1.0f, 0.1f}, Swing{10.0f, 0.04f}, Swing{100.0f, 0.3f}})
    {
        Trial trial(GetParam());
        b2Body* load = Sleeper(trial, swing.amplitude, -swing.length, 0.2f, 0.2f);
        trial.Rod(trial.Post(), load, b2Vec2(0.0f, 0.0f), load->GetPosition());
        char name[64];
        std::snprintf(name, sizeof name, "pendulum of %g m, %g m far", double(swing.length),
                      double(swing.amplitude));
        JudgeAwake(trial, name);
    }
}

TEST_P(Sleep, NeverComesToABodyThatFallsSlowly)
{
    for (const float32 gravity : {10.0f, 0.03f, 0.01f})
    {
        Trial trial(GetParam(), b2Vec2(0.0f, -gravity));
        trial.Box(0.0f, 0.0f);                                                  // let go
        trial.Box(5.0f, 0.0f)->SetLinearVelocity(b2Vec2(0.0f, 5.0f * gravity)); // thrown up
        JudgeAwake(trial, "falls and is thrown, g " + std::to_string(gravity));
    }
}

TEST_P(Sleep, NeverComesToASlowMotor)
{
    // A clock's minute hand at sixty times its speed, a lift, and a wheel.
    constexpr float32 kSlow = 0.1f * b2_pi / 30.0f; // [rad/s]
    Trial clock(GetParam());
    b2Body* hand = Sleeper(clock, 0.0f, 0.5f, 0.02f, 0.5f);
    b2RevoluteJoint* turning = clock.Hinge(clock.Post(), hand, 0.0f, 0.0f);
    turning->EnableMotor(true);
    turning->SetMotorSpeed(-kSlow);
    turning->SetMaxMotorTorque(100.0f);
    JudgeAwake(clock, "hand at 0.6 deg/s");
    Judge("hand at 0.6 deg/s, angle off", GetParam(),
          100.0 * std::abs(double(hand->GetAngle()) / double(-30.0f * kSlow) - 1.0), "%", 1.0);

    Trial lift(GetParam());
    b2Body* cabin = Sleeper(lift, 0.0f, 0.0f);
    b2PrismaticJoint* rising = lift.Slider(lift.Post(), cabin, 0.0f, 0.0f, b2Vec2(0.0f, 1.0f));
    rising->EnableMotor(true);
    rising->SetMotorSpeed(0.004f);
    rising->SetMaxMotorForce(1000.0f);
    JudgeAwake(lift, "lift at 4 mm/s");
    Judge("lift at 4 mm/s, way off", GetParam(),
          100.0 * std::abs(double(cabin->GetPosition().y) / 0.12 - 1.0), "%", 1.0);
}

TEST_P(Sleep, NeverComesToASoftSpring)
{
    Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
    b2Body* load = Sleeper(trial, 2.0f, 0.0f, 0.2f, 0.2f);
    b2DistanceJoint* spring = trial.Rod(trial.Post(), load, b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, 0.0f));
    spring->SetFrequency(0.05f); // 20 s to and fro
    spring->SetDampingRatio(0.0f);
    spring->SetLength(1.9f);
    JudgeAwake(trial, "spring of 0.05 Hz, 10 cm");
}

TEST_P(Sleep, NeverComesToABodyThatBalancesForAWhile)
{
    // A rod on its end, a third to a thirtieth of a degree off: it leans for long before it falls.
    for (const float32 off : {0.005f, 0.001f, 0.0005f})
    {
        Trial trial(GetParam());
        b2Body* rod = trial.Body(b2_dynamicBody, 0.0f, 0.0f);
        b2PolygonShape shape;
        shape.SetAsBox(0.05f, 2.0f, b2Vec2(0.0f, 2.0f), 0.0f);
        Scene::Add(rod, shape, 0.2f, 0.0f);
        rod->SetTransform(b2Vec2(0.0f, 0.0f), off);
        trial.Hinge(trial.Post(), rod, 0.0f, 0.0f);
        char name[64];
        std::snprintf(name, sizeof name, "rod on its end, %g rad off", double(off));
        JudgeAwake(trial, name, 8.0);
        Judge(name + std::string(", angle missing to 0.5 rad"), GetParam(),
              b2Max(0.5 - double(b2Abs(rod->GetAngle())), 0.0), "rad", 0.0);
    }
}

TEST_P(Sleep, ComesToPiles)
{
    {
        Trial trial(GetParam());
        trial.Ground();
        trial.Box(0.0f, 1.0f);
        JudgeRest(trial, "box dropped", kSoon);
    }
    {
        Trial trial(GetParam());
        trial.Ground();
        Stack(trial, 0.0f, 10);
        JudgeRest(trial, "stack of 10", kSoon);
    }
    for (const int height : {20, 30, 50})
    {
        Trial trial(GetParam());
        trial.Ground();
        Stack(trial, 0.0f, height);
        JudgeRest(trial, "stack of " + std::to_string(height), GetParam() > 1 ? kSoon : kNoBound);
    }
    {
        Trial trial(GetParam());
        trial.Ground();
        for (int row = 0; row < 10; ++row)
        {
            for (int i = row; i < 10; ++i)
            {
                trial.Box(1.05f * (float32(i) - 0.5f * float32(row)),
                          0.5f + kRestingGap + (1.0f + kRestingGap) * float32(row));
            }
        }
        JudgeRest(trial, "pyramid of base 10", kSoon);
    }
    {
        Trial trial(GetParam());
        trial.Ground();
        for (const float32 x : {-4.0f, 4.0f})
        {
            Scene::AddBox(trial.Body(b2_staticBody, x, 5.0f), 0.5f, 5.0f);
        }
        for (int i = 0; i < 40; ++i)
        {
            trial.Box(3.0f * trial.Random(), 1.0f + 0.8f * float32(i), 0.3f, 0.3f);
        }
        JudgeRest(trial, "forty boxes thrown together", 2.0 * kSoon); // half of it they fall
    }
}

TEST_P(Sleep, ComesToMachinesAndChains)
{
    {
        Trial trial(GetParam());
        b2Body* last = trial.Post();
        for (int i = 0; i < 20; ++i)
        {
            b2Body* link = Sleeper(trial, 0.0f, -0.5f - float32(i), 0.1f, 0.5f);
            trial.Hinge(last, link, 0.0f, -float32(i));
            last = link;
        }
        JudgeRest(trial, "chain of 20 hanging", kSoon);
    }
    // A bridge of planks that the air slows down, with some slack and with none at all. The second
    // is pulled so hard that it buzzes for ever, by some centimetres a second,
    // but for the recommended number of sub-steps.
    for (const float32 slack : {0.5f, 0.0f})
    {
        Trial trial(GetParam());
        b2Body* last = trial.Post();
        for (int i = 0; i < 15; ++i)
        {
            b2Body* plank = Sleeper(trial, 0.5f + float32(i), 0.0f, 0.5f, 0.1f);
            plank->SetLinearDamping(1.0f);
            plank->SetAngularDamping(1.0f);
            trial.Hinge(last, plank, float32(i), 0.0f);
            last = plank;
        }
        b2RevoluteJointDef def;
        def.bodyA = last;
        def.bodyB = trial.Post(15.0f - slack, 0.0f);
        def.localAnchorA.Set(0.5f, 0.0f);
        trial.world.CreateJoint(&def);
        slack > 0.0f ? JudgeRest(trial, "bridge of 15 planks", 4.0 * kSoon)
                     : JudgeRest(trial, "bridge without slack",
                                 GetParam() == kRecommended ? 4.0 * kSoon : kNoBound);
    }
    {
        Trial trial(GetParam());
        trial.Ground();
        trial.Wall(3.0f);
        b2Body* box = Sleeper(trial, 0.0f, 1.0f, 0.5f, 0.5f);
        box->GetFixtureList()->SetFilterData(b2Filter());
        b2PrismaticJoint* motor = trial.Slider(trial.Post(), box, 0.0f, 1.0f, b2Vec2(1.0f, 0.0f));
        motor->EnableMotor(true);
        motor->SetMotorSpeed(2.0f);
        motor->SetMaxMotorForce(100.0f);
        JudgeRest(trial, "motor against a wall", kSoon);
    }
    {
        Trial trial(GetParam());
        b2Body* load = Sleeper(trial, 0.0f, 0.0f, 0.2f, 0.2f);
        b2DistanceJoint* spring =
            trial.Rod(trial.Post(0.0f, 3.0f), load, b2Vec2(0.0f, 3.0f), b2Vec2(0.0f, 0.0f));
        spring->SetFrequency(1.0f);
        spring->SetDampingRatio(0.7f);
        JudgeRest(trial, "load on a damped spring", kSoon);
    }
}

/// Boxes of 1 to 26 times the density, the heaviest on top, on a plate whose hinge or slider is at
/// its limit. The limit gives way by micrometres under the weight, and pushes back.
TEST_P(Sleep, ComesToStacksThatStandOnALimit)
{
    for (const bool slides : {false, true})
    {
        Trial trial(GetParam());
        b2Body* post = trial.Post(0.0f, 5.0f);
        b2Body* plate = Sleeper(trial, 2.0f, 5.0f, 2.0f, 0.1f);
        plate->GetFixtureList()->SetFilterData(b2Filter());
        if (slides)
        {
            b2PrismaticJoint* slider = trial.Slider(post, plate, 2.0f, 5.0f, b2Vec2(0.0f, 1.0f));
            slider->EnableLimit(true);
            slider->SetLimits(0.0f, 3.0f);
        }
        else
        {
            b2RevoluteJoint* hinge = trial.Hinge(post, plate, 0.0f, 5.0f);
            hinge->EnableLimit(true);
            hinge->SetLimits(0.0f, 1.0f);
        }
        for (int i = 0; i < 6; ++i)
        {
            b2Body* box = trial.Box(2.5f, 5.4f + 0.61f * float32(i), 0.3f, 0.3f);
            box->GetFixtureList()->SetDensity(1.0f + float32(i * i));
            box->ResetMassData();
        }
        // With one step such a weight on light boxes sways for ever.
        JudgeRest(trial, slides ? "stack on a slider's limit" : "stack on a hinge's limit",
                  GetParam() == 1 ? kNoBound : kSoon);
    }
}

} // namespace
