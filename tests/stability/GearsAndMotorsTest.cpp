// SPDX-License-Identifier: MIT
#include "Trial.h"

/// Motors that cannot go on: a jammed gear train, and motors against a wall. The force is what the
/// motor has, nothing creeps and nothing trembles.
namespace
{

using namespace stability;

STABILITY_SUITE(GearsAndMotors);

/// From 10 s on, what pushes in vain has to stand: the farthest way of a number from where it was.
class Rest
{
public:
    void Look(double time, double value)
    {
        if (time > 10.0)
        {
            m_first = m_started ? m_first : value;
            m_started = true;
            m_way = Worst(std::abs(value - m_first), m_way);
        }
    }
    double Way() const { return m_started ? m_way : kNoBound; }

private:
    bool m_started = false;
    double m_first = 0.0, m_way = 0.0;
};

/// Wheels of radius 1 in a row, each geared to the next: they turn by turns to the left and right.
class Train
{
public:
    explicit Train(Trial& scene) : trial(scene)
    {
        for (int i = 0; i < int(kWheels); ++i)
        {
            b2Body* wheel = trial.Part(2.0f * float32(i), 0.0f, 0.7f, 0.7f);
            hinges.push_back(trial.Hinge(trial.Post(), wheel, 2.0f * float32(i), 0.0f));
        }
        for (std::size_t i = 0; i + 1 < kWheels; ++i)
        {
            b2GearJointDef def;
            def.joint1 = hinges[i];
            def.joint2 = hinges[i + 1];
            def.bodyA = hinges[i]->GetBodyB();
            def.bodyB = hinges[i + 1]->GetBodyB();
            def.ratio = 1.0f;
            trial.world.CreateJoint(&def);
        }
        hinges[0]->EnableMotor(true);
        hinges[0]->SetMotorSpeed(kSpeed);
        hinges[0]->SetMaxMotorTorque(kTorque);
    }

    /// Returns the distance of the wheels from the angle of their gears [rad].
    double Slip() const
    {
        double slip = 0.0;
        for (std::size_t i = 0; i + 1 < kWheels; ++i)
        {
            const float32 sum = hinges[i]->GetJointAngle() + hinges[i + 1]->GetJointAngle();
            slip = Worst(double(b2Abs(sum)), slip);
        }
        return slip;
    }

    static constexpr std::size_t kWheels = 6;
    static constexpr float32 kTorque = 200.0f; // [N m]
    static constexpr float32 kSpeed = 5.0f;    // [rad/s]

    Trial& trial;
    std::vector<b2RevoluteJoint*> hinges;
};

/// A gear that slips by this [rad] is a millimetre off at a metre.
constexpr double kSlip = 1e-3;
/// Tolerance of a motor's limit for rounding.
constexpr double kRounding = 1e-4;

void JudgeTrain(const Train& train, const std::string& name)
{
    Trial& trial = train.trial;
    const int32 n = trial.world.GetSubStepCount();
    Rest rest;
    double slip = 0.0, speed = 0.0, torque = 0.0;
    trial.Run(20.0, [&](double time) {
        slip = Worst(train.Slip(), slip);
        rest.Look(time, double(train.hinges[0]->GetJointAngle()));
        for (const b2RevoluteJoint* hinge : train.hinges)
        {
            speed = time > 10.0 ? Worst(double(b2Abs(hinge->GetJointSpeed())), speed) : 0.0;
        }
        torque = Worst(double(b2Abs(train.hinges[0]->GetMotorTorque())), torque);
    });
    Judge(name + ", slip of the gears", n, slip, "rad", Bound(n, kSlip, 0.05));
    Judge(name + ", creep in 10 s", n, rest.Way(), "rad", 1e-3);
    Judge(name + ", trembling", n, speed, "rad/s", 0.01);
    Judge(name + ", torque above the motor's", n, torque / double(Train::kTorque) - 1.0, "",
          kRounding);
}

TEST_P(GearsAndMotors, StandStillWhenJammedByAWeld)
{
    Trial trial(GetParam());
    const Train train(trial);
    trial.Weld(trial.Post(), train.hinges.back()->GetBodyB(), 10.0f, 0.0f);
    JudgeTrain(train, "gears, last one welded");
}

TEST_P(GearsAndMotors, StandStillWhenJammedByALimit)
{
    Trial trial(GetParam());
    const Train train(trial);
    train.hinges.back()->EnableLimit(true);
    train.hinges.back()->SetLimits(-1.0f, 1.0f);
    JudgeTrain(train, "gears, last one at its limit");
}

TEST_P(GearsAndMotors, StandStillWhenJammedByABar)
{
    Trial trial(GetParam());
    const Train train(trial);
    b2Filter all;
    b2Body* last = train.hinges.back()->GetBodyB();
    last->GetFixtureList()->SetFilterData(all);
    b2Body* bar = trial.Post(12.0f, 0.0f);
    Scene::AddBox(bar, 1.2f, 0.1f); // its end is in the way of the corners
    JudgeTrain(train, "gears, a bar in the last one");
}

TEST_P(GearsAndMotors, TurnAtTheSpeedOfTheStrongerMotor)
{
    Trial trial(GetParam());
    const Train train(trial);
    // The last of six turns against the first: the same sign is the other way.
    train.hinges.back()->EnableMotor(true);
    train.hinges.back()->SetMotorSpeed(5.0f);
    train.hinges.back()->SetMaxMotorTorque(2.0f * Train::kTorque);
    double slip = 0.0, off = 0.0;
    trial.Run(20.0, [&](double time) {
        slip = Worst(train.Slip(), slip);
        const double speed = double(train.hinges.back()->GetJointSpeed());
        off = time > 10.0 ? Worst(std::abs(speed - 5.0), off) : 0.0;
    });
    Judge("gears, two motors, slip", GetParam(), slip, "rad", Bound(GetParam(), kSlip, 0.05));
    Judge("gears, two motors, the stronger one's speed off", GetParam(), 100.0 * off / 5.0, "%",
          1.0);
}

/// The verdicts for a motor that pushes a body against a wall.
struct Push
{
    double force = 0.0;     ///< that the motor says it gives, as a share of what it has
    double overlap = 0.0;   ///< [m]
    double trembling = 0.0; ///< [m/s]
    Rest rest;
};

void JudgePush(const std::string& name, int32 n, const Push& push)
{
    Judge(name + ", force above the motor's", n, push.force - 1.0, "", kRounding);
    Judge(name + ", overlap", n, 1000.0 * push.overlap, "mm",
          1000.0 * Bound(n, double(b2_linearSlop) + 0.001, double(b2_polygonRadius)));
    Judge(name + ", creep in 10 s", n, push.rest.Way(), "m", 1e-3);
    Judge(name + ", trembling", n, push.trembling, "m/s", 0.01);
}

/// With a thousand times its weight.
TEST_P(GearsAndMotors, PushABoxAgainstAWall)
{
    Trial trial(GetParam());
    trial.Wall(3.0f);
    b2Body* box = trial.Load(0.0f, 0.0f);
    b2PrismaticJoint* motor = trial.Slider(trial.Post(), box, 0.0f, 0.0f, b2Vec2(1.0f, 0.0f));
    const float32 force = 1000.0f * kGravity * box->GetMass();
    motor->EnableMotor(true);
    motor->SetMotorSpeed(2.0f);
    motor->SetMaxMotorForce(force);
    Push push;
    trial.Run(20.0, [&](double time) {
        push.force = Worst(double(b2Abs(motor->GetMotorForce()) / force), push.force);
        push.rest.Look(time, double(box->GetPosition().x));
        push.overlap = time > 10.0 ? Worst(trial.DeepestOverlap(), push.overlap) : 0.0;
        push.trembling = time > 10.0 ? Worst(trial.FastestSpeed(), push.trembling) : 0.0;
    });
    JudgePush("slider against a wall", GetParam(), push);
}

/// One, two or five boxes on the ground between the slider and the wall: it pushes them, and never
/// comes into them.
TEST_P(GearsAndMotors, PushARowOfBoxesAgainstAWall)
{
    for (const int count : {1, 2, 5})
    {
        Trial trial(GetParam());
        trial.Ground();
        trial.Wall(7.0f);
        std::vector<b2Body*> row;
        for (int i = 0; i < count; ++i)
        {
            row.push_back(trial.Load(1.5f + 1.1f * float32(i), 0.5f + kRestingGap));
        }
        b2Body* box = trial.Load(0.0f, 0.55f);
        b2PrismaticJoint* motor = trial.Slider(trial.Post(), box, 0.0f, 0.55f, b2Vec2(1.0f, 0.0f));
        const float32 force = 20.0f * kGravity * box->GetMass();
        motor->EnableMotor(true);
        motor->SetMotorSpeed(2.0f);
        motor->SetMaxMotorForce(force);
        Push push;
        double into = 0.0, jump = 0.0, before = 0.0;
        Places last({box});
        trial.Run(20.0, [&](double time) {
            push.force = Worst(double(b2Abs(motor->GetMotorForce()) / force), push.force);
            push.rest.Look(time, double(box->GetPosition().x));
            push.overlap = time > 10.0 ? Worst(trial.DeepestOverlap(), push.overlap) : 0.0;
            push.trembling = time > 10.0 ? Worst(trial.FastestSpeed(), push.trembling) : 0.0;
            // The distance of the slider, plus the push back of the first box by the others in the
            // same step.
            const double first = Worst(before, double(row[0]->GetPosition().x));
            into = Worst(1.0 - (first - double(box->GetPosition().x)), into);
            before = double(row[0]->GetPosition().x);
            jump = Worst(last.Farthest(), jump);
            last = Places({box});
        });
        const std::string name = "slider, boxes and a wall, " + std::to_string(count);
        JudgePush(name, GetParam(), push);
        // Contacts are found once a step: bodies meet after up to a step's way, less their skins.
        const double way = double(motor->GetMotorSpeed()) / 60.0 - 2.0 * double(b2_polygonRadius);
        Judge(name + ", into the first box", GetParam(), 1000.0 * into, "mm", 1000.0 * way);
        Judge(name + ", way in a step", GetParam(), jump, "m", 0.1); // the motor's is 0.03
        Judge(name + ", force missing", GetParam(), 1.0 - motor->GetMotorForce() / force, "", 0.01);
    }
}

/// An arm of 2 m presses its end on the ground, with a hundred times what its weight would do.
TEST_P(GearsAndMotors, PressAnArmOnTheGround)
{
    Trial trial(GetParam());
    trial.Ground();
    b2Body* arm = trial.Load(1.0f, 1.0f, 1.0f, 0.1f);
    b2RevoluteJoint* motor = trial.Hinge(trial.Post(), arm, 0.0f, 1.0f);
    const float32 torque = 100.0f * kGravity * arm->GetMass();
    motor->EnableMotor(true);
    motor->SetMotorSpeed(-2.0f);
    motor->SetMaxMotorTorque(torque);
    Push push;
    trial.Run(20.0, [&](double time) {
        push.force = Worst(double(b2Abs(motor->GetMotorTorque()) / torque), push.force);
        push.rest.Look(time, double(motor->GetJointAngle()));
        push.overlap = time > 10.0 ? Worst(trial.DeepestOverlap(), push.overlap) : 0.0;
        push.trembling = time > 10.0 ? Worst(trial.FastestSpeed(), push.trembling) : 0.0;
    });
    JudgePush("arm on the ground", GetParam(), push);
}

/// A car with a driven wheel is in front of a wall; the wheel spins.
TEST_P(GearsAndMotors, DriveACarAgainstAWall)
{
    Trial trial(GetParam());
    trial.Ground();
    trial.Wall(5.0f);
    b2Body* chassis = trial.Load(0.0f, 1.0f, 1.5f, 0.3f);
    b2WheelJoint* motor = nullptr;
    for (const float32 x : {0.9f, -0.9f})
    {
        b2Body* wheel = trial.Ball(x, 0.45f, 0.4f);
        wheel->GetFixtureList()->SetFriction(0.9f);
        b2WheelJointDef def;
        def.Initialize(chassis, wheel, wheel->GetPosition(), b2Vec2(0.0f, 1.0f));
        def.frequencyHz = 4.0f;
        def.dampingRatio = 0.7f;
        motor = trial.Create<b2WheelJoint>(def);
    }
    const float32 torque = 20.0f;
    motor->EnableMotor(true);
    motor->SetMotorSpeed(-20.0f);
    motor->SetMaxMotorTorque(torque);
    Push push;
    trial.Run(20.0, [&](double time) {
        push.force = Worst(double(b2Abs(motor->GetMotorTorque()) / torque), push.force);
        push.rest.Look(time, double(chassis->GetPosition().x));
        push.overlap = time > 10.0 ? Worst(trial.DeepestOverlap(), push.overlap) : 0.0;
        const double speed = double(chassis->GetLinearVelocity().Length());
        push.trembling = time > 10.0 ? Worst(speed, push.trembling) : 0.0;
    });
    JudgePush("car against a wall", GetParam(), push);
}

} // namespace
