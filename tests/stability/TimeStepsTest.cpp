// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Steps that are long, or not of one length.
namespace
{

using namespace stability;

STABILITY_SUITE(TimeSteps);

struct Rhythm
{
    const char* name;
    float32 (*lengthOf)(int step); // [s]
    bool isLong = false;           ///< four steps in one
    bool isWild = false;           ///< up to sixteen times as long as the one before
};

const Rhythm kRhythms[] = {
    {"1/60", [](int) { return 1.0f / 60.0f; }},
    {"1/15", [](int) { return 1.0f / 15.0f; }, true},
    {"1/30", [](int) { return 1.0f / 30.0f; }},
    {"1/30 and 1/120", [](int i) { return i % 2 == 0 ? 1.0f / 30.0f : 1.0f / 120.0f; }},
    {"1/240 to 1/15", [](int i) { return 1.0f / (15.0f + float32((i * 7919) % 226)); }, false,
     true},
};

TEST_P(TimeSteps, KeepAStackStanding)
{
    for (const Rhythm& rhythm : kRhythms)
    {
        Trial trial(GetParam());
        trial.world.SetAllowSleeping(false);
        trial.Ground();
        const std::vector<b2Body*> boxes = Stack(trial, 0.0f, 10);
        const Places places(boxes);
        double fastest = 0.0;
        trial.Run(20.0, rhythm.lengthOf, [&](double time) {
            fastest = time > 10.0 ? Worst(trial.FastestSpeed(), fastest) : 0.0;
        });
        const std::string name = std::string("stack of 10, steps of ") + rhythm.name;
        const bool judged = GetParam() >= kRecommended || (!rhythm.isWild && !rhythm.isLong);
        Judge(name + ", way", GetParam(), places.Farthest(), "m", judged ? 0.05 : kNoBound);
        Judge(name + ", speed", GetParam(), fastest, "m/s",
              judged && !rhythm.isWild ? double(b2_linearSleepTolerance) : kNoBound);
    }
}

/// Ten links, the first half let go level, so that it swings and whips for all of the time.
TEST_P(TimeSteps, KeepAChainClosed)
{
    for (const Rhythm& rhythm : kRhythms)
    {
        Trial trial(GetParam());
        std::vector<b2Joint*> joints;
        b2Body* last = trial.Post();
        for (int i = 0; i < 10; ++i)
        {
            b2Body* link = trial.Part(float32(i) + 0.5f, 0.0f, 0.5f, 0.1f);
            joints.push_back(trial.Hinge(last, link, float32(i), 0.0f));
            last = link;
        }
        const double before = trial.EnergyOfAll();
        double widest = 0.0, won = 0.0, maximum = 0.0;
        trial.Run(20.0, rhythm.lengthOf, [&](double) {
            for (const b2Joint* joint : joints)
            {
                widest = Worst(double(Gap(joint)), widest);
            }
            won = Worst(trial.EnergyOfAll() - before, won);
            maximum = Worst(trial.KineticOfAll(), maximum);
        });
        const std::string name = std::string("chain of 10, steps of ") + rhythm.name;
        // Four sub-steps of 1/15 s are as long as one step of 1/60 s: links that whip turn by half
        // a radian in one.
        const bool fine =
            GetParam() > kRecommended || (GetParam() == kRecommended && !rhythm.isLong);
        Judge(name + ", gap", GetParam(), 1000.0 * widest, "mm",
              fine ? 1000.0 * double(b2_linearSlop) : kNoBound);
        Judge(name + ", energy won", GetParam(), 100.0 * won / maximum, "%", 1.0);
    }
}

/// A crank turned by a motor moves a piston over a rod.
TEST_P(TimeSteps, KeepAMachineClosed)
{
    constexpr float32 kSpeed = 4.0f; // [rad/s]
    for (const Rhythm& rhythm : kRhythms)
    {
        Trial trial(GetParam());
        b2Body* post = trial.Post();
        b2Body* crank = trial.Part(0.0f, 0.5f, 0.1f, 0.5f);
        b2Body* rod = trial.Part(0.0f, 2.0f, 0.1f, 1.0f);
        b2Body* piston = trial.Part(0.0f, 3.0f, 0.4f, 0.3f);
        b2RevoluteJoint* motor = trial.Hinge(post, crank, 0.0f, 0.0f);
        motor->EnableMotor(true);
        motor->SetMotorSpeed(kSpeed);
        motor->SetMaxMotorTorque(100.0f);
        const std::vector<b2Joint*> joints = {motor, trial.Hinge(crank, rod, 0.0f, 1.0f),
                                              trial.Hinge(rod, piston, 0.0f, 3.0f)};
        const b2Joint* guide = trial.Slider(post, piston, 0.0f, 3.0f, b2Vec2(0.0f, 1.0f));
        double widest = 0.0, off = 0.0;
        trial.Run(20.0, rhythm.lengthOf, [&](double) {
            for (const b2Joint* joint : joints)
            {
                widest = Worst(double(Gap(joint)), widest);
            }
            widest = Worst(double(Across(guide, b2Vec2(0.0f, 1.0f))), widest);
            off = Worst(double(b2Abs(motor->GetJointSpeed() - kSpeed)), off);
        });
        const std::string name = std::string("crank and piston, steps of ") + rhythm.name;
        Judge(name + ", gap", GetParam(), 1000.0 * widest, "mm", Bound(GetParam(), 1.0));
        Judge(name + ", speed off", GetParam(), 100.0 * off / double(kSpeed), "%",
              Bound(GetParam(), 1.0));
        // 80 radians in 20 s, but for the first step.
        Judge(name + ", angle off", GetParam(),
              std::abs(double(motor->GetJointAngle()) - 20.0 * double(kSpeed)), "rad",
              Bound(GetParam(), 0.5));
    }
}

} // namespace
