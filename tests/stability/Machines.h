// SPDX-License-Identifier: MIT
#pragma once

#include "Trial.h"

/// Machines with forty joints, that run for as long as a test wants: one of all kinds that is
/// driven, and one without friction. For MachineTest and MachineLongTest; judges them too.
namespace stability
{

/// Three equal machines side by side, with fourteen joints of all eleven kinds each. A motor turns
/// a crank, which moves a piston and, over a gear, a wheel with an arm. A spring and a rope connect
/// a weight to the arm. Two weights share a pulley, one slowed down by friction. A cart has a
/// suspension, a platform is moved to and fro, and a mouse joint pulls a body.
class FortyTwo
{
public:
    explicit FortyTwo(Trial& scene) : trial(scene)
    {
        for (int i = 0; i < 3; ++i)
        {
            const float32 x = 20.0f * float32(i);
            MakePiston(x);
            MakeArm(x);
            MakePulley(x);
            MakeMovers(x);
        }
    }

    /// Sets the targets of driven bodies at that time [s].
    void Lead(double time)
    {
        const auto phase = float32(time);
        for (std::size_t i = 0; i < hands.size(); ++i)
        {
            const float32 x = 20.0f * float32(i) + 12.0f;
            hands[i]->SetTarget(b2Vec2(x + std::cos(phase), std::sin(2.0f * phase)));
            platforms[i]->SetLinearOffset(b2Vec2(0.0f, std::sin(0.5f * phase)));
        }
    }

    /// Returns the maximum residual of all rigid joints [m], [rad].
    double Error() const
    {
        double error = 0.0;
        for (const b2Joint* joint : points)
        {
            error = Worst(double(Gap(joint)), error);
        }
        for (const b2Joint* guide : guides)
        {
            error = Worst(double(Across(guide, b2Vec2(0.0f, 1.0f))), error);
        }
        for (const auto& error_ : others)
        {
            error = Worst(error_(), error);
        }
        return error;
    }

    /// Returns the maximum distance of weights beyond their ropes [m]. A falling weight is stopped
    /// in the sub-step after it reaches the end of its rope.
    double Beyond() const
    {
        double beyond = 0.0;
        for (const b2Joint* rope : ropes)
        {
            beyond = Worst(double(Gap(rope)) - 1.7, beyond);
        }
        return beyond;
    }

    Trial& trial;
    std::vector<b2Joint*> points; ///< that keep two anchors together
    std::vector<b2Joint*> guides; ///< that keep to the y axis
    std::vector<std::function<double()>> others;
    std::vector<b2Joint*> ropes; ///< of 1.7 m
    std::vector<b2MouseJoint*> hands;
    std::vector<b2MotorJoint*> platforms;

private:
    void MakePiston(float32 x) // four joints
    {
        b2Body* post = trial.Post();
        m_crank = trial.Part(x, 0.5f, 0.1f, 0.5f);
        b2Body* rod = trial.Part(x, 2.0f, 0.1f, 1.0f);
        b2Body* piston = trial.Part(x, 3.0f, 0.4f, 0.3f);
        m_motor = trial.Hinge(post, m_crank, x, 0.0f);
        m_motor->EnableMotor(true);
        m_motor->SetMotorSpeed(3.0f);
        m_motor->SetMaxMotorTorque(60.0f);
        points.insert(points.end(), {m_motor, trial.Hinge(m_crank, rod, x, 1.0f),
                                     trial.Hinge(rod, piston, x, 3.0f)});
        guides.push_back(trial.Slider(post, piston, x, 3.0f, b2Vec2(0.0f, 1.0f)));
    }
    void MakeArm(float32 x) // five joints
    {
        b2Body* post = trial.Post();
        b2Body* wheel = trial.Part(x + 3.0f, 0.0f, 0.5f, 0.5f);
        b2RevoluteJoint* hinge = trial.Hinge(post, wheel, x + 3.0f, 0.0f);
        b2GearJointDef gear;
        gear.joint1 = m_motor;
        gear.joint2 = hinge;
        gear.bodyA = m_crank;
        gear.bodyB = wheel;
        gear.ratio = 2.0f;
        trial.world.CreateJoint(&gear);
        // After ten minutes an angle in single precision has an error of a tenth of a thousandth.
        others.push_back([motor = m_motor, hinge] {
            const float32 angle = b2Abs(motor->GetJointAngle());
            const double unknown = double(std::nextafter(angle, b2_maxFloat)) - double(angle);
            const double off =
                double(motor->GetJointAngle()) + 2.0 * double(hinge->GetJointAngle());
            return b2Max(std::abs(off) - unknown, 0.0);
        });
        b2Body* arm = trial.Part(x + 4.0f, 0.0f, 0.5f, 0.05f);
        b2Joint* weld = trial.Weld(wheel, arm, x + 3.5f, 0.0f);
        points.insert(points.end(), {hinge, weld});
        b2Body* weight = trial.Part(x + 4.5f, -1.5f, 0.2f, 0.2f);
        b2DistanceJoint* spring =
            trial.Rod(arm, weight, b2Vec2(x + 4.5f, 0.0f), b2Vec2(x + 4.5f, -1.5f));
        spring->SetFrequency(3.0f);
        spring->SetDampingRatio(0.3f);
        b2RopeJointDef rope;
        rope.bodyA = arm;
        rope.bodyB = weight;
        rope.localAnchorA.Set(0.5f, 0.0f);
        rope.localAnchorB.SetZero();
        rope.maxLength = 1.7f;
        b2Joint* limit = trial.world.CreateJoint(&rope);
        ropes.push_back(limit);
    }
    void MakePulley(float32 x) // two joints
    {
        b2Body* a = trial.Part(x + 7.0f, 0.0f, 0.3f, 0.3f);
        b2Body* b = trial.Part(x + 9.0f, 0.0f, 0.3f, 0.32f);
        b2PulleyJointDef def;
        def.Initialize(a, b, b2Vec2(x + 7.0f, 5.0f), b2Vec2(x + 9.0f, 5.0f), a->GetPosition(),
                       b->GetPosition(), 1.0f);
        auto* pulley = trial.Create<b2PulleyJoint>(def);
        a->SetLinearVelocity(b2Vec2(1.0f, 0.0f));
        const float32 sum = def.lengthA + def.lengthB;
        others.push_back([pulley, sum] {
            return double(b2Abs(pulley->GetCurrentLengthA() + pulley->GetCurrentLengthB() - sum));
        });
        b2FrictionJointDef friction;
        friction.Initialize(trial.Post(), b, b->GetPosition());
        friction.maxForce = 0.7f * b->GetMass();
        friction.maxTorque = 0.1f;
        trial.world.CreateJoint(&friction);
    }
    void MakeMovers(float32 x) // three joints
    {
        b2Body* post = trial.Post(x + 15.0f, 0.0f);
        b2Body* platform = trial.Part(x + 15.0f, 0.0f, 1.0f, 0.1f);
        b2MotorJointDef led;
        led.Initialize(post, platform);
        led.maxForce = 200.0f * platform->GetMass();
        led.maxTorque = 100.0f;
        platforms.push_back(trial.Create<b2MotorJoint>(led));
        b2Body* cart = trial.Part(x + 15.0f, -1.0f, 0.3f, 0.3f);
        b2WheelJointDef suspension;
        suspension.Initialize(platform, cart, cart->GetPosition(), b2Vec2(0.0f, 1.0f));
        suspension.frequencyHz = 2.0f;
        suspension.dampingRatio = 0.2f;
        suspension.enableMotor = true;
        suspension.motorSpeed = 5.0f;
        suspension.maxMotorTorque = 1.0f;
        guides.push_back(trial.world.CreateJoint(&suspension));
        b2Body* pulled = trial.Part(x + 12.0f, 0.0f, 0.3f, 0.3f);
        b2MouseJointDef hand;
        hand.bodyA = post;
        hand.bodyB = pulled;
        hand.target.Set(x + 12.0f, 0.2f);
        hand.maxForce = 100.0f * pulled->GetMass();
        hands.push_back(trial.Create<b2MouseJoint>(hand));
    }

    b2Body* m_crank = nullptr;
    b2RevoluteJoint* m_motor = nullptr;
};

/// `seconds` of it; the most kinetic energy of its last nine tenths against that of the first.
inline void RunFortyTwo(int32 subSteps, double seconds)
{
    Trial trial(subSteps);
    FortyTwo machine(trial);
    ASSERT_EQ(trial.world.GetJointCount(), 42);
    double first = 0.0, later = 0.0, error = 0.0, beyond = 0.0;
    trial.Run(seconds, [&](double time) {
        machine.Lead(time);
        double& maximum = time < 0.1 * seconds ? first : later;
        maximum = Worst(trial.KineticOfAll(), maximum);
        error = time > 1.0 ? Worst(machine.Error(), error) : error;
        beyond = time > 1.0 ? Worst(machine.Beyond(), beyond) : beyond;
    });
    const std::string name = "42 joints, " + std::to_string(int(seconds)) + " s";
    Judge(name + ", kinetic energy, first tenth", subSteps, first, "J", kNoBound);
    Judge(name + ", more later", subSteps, 100.0 * (later / first - 1.0), "%", 10.0);
    Judge(name + ", widest gap or angle", subSteps, 1000.0 * error, "mm",
          Bound(subSteps, subSteps >= kRecommended ? 0.1 : 1.0, 50.0));
    // A rope that a drift makes taut is held from the next kick on, after the displacement of one
    // sub-step.
    const double rope = subSteps >= kRecommended ? 1.0 : 2.0;
    Judge(name + ", beyond a rope", subSteps, 1000.0 * beyond, "mm", Bound(subSteps, rope, 50.0));
}

/// A tree of rods that swings without friction: hinges, a weld in every third place, a rod.
inline void RunSwinging(int32 subSteps, double seconds)
{
    Trial trial(subSteps);
    std::vector<b2Joint*> joints;
    std::vector<b2Body*> bodies = {trial.Part(0.0f, -0.5f, 0.05f, 0.5f)};
    joints.push_back(trial.Hinge(trial.Post(), bodies[0], 0.0f, 0.0f));
    for (std::size_t i = 1; i < 40; ++i)
    {
        b2Body* parent = bodies[(i - 1) / 2];
        const b2Vec2 tip = parent->GetWorldPoint(b2Vec2(0.0f, -0.5f));
        b2Body* body = trial.Part(tip.x, tip.y - 0.5f, 0.05f, 0.5f);
        bodies.push_back(body);
        joints.push_back(i % 3 == 0 ? static_cast<b2Joint*>(trial.Weld(parent, body, tip.x, tip.y))
                                    : trial.Hinge(parent, body, tip.x, tip.y));
    }
    bodies[0]->SetAngularVelocity(2.0f);
    bodies[39]->SetLinearVelocity(b2Vec2(3.0f, 0.0f));
    trial.Step(); // what the joints do not allow is gone
    const double before = trial.EnergyOfAll();
    double kinetic = 0.0, off = 0.0, won = 0.0, gap = 0.0;
    trial.Run(seconds, [&](double) {
        kinetic = Worst(trial.KineticOfAll(), kinetic);
        const double energy = trial.EnergyOfAll() - before;
        off = Worst(std::abs(energy), off);
        won = Worst(energy, won);
        for (const b2Joint* joint : joints)
        {
            gap = Worst(double(Gap(joint)), gap);
        }
    });
    const std::string name = "tree of 40, " + std::to_string(int(seconds)) + " s";
    Judge(name + ", energy off", subSteps, 100.0 * off / kinetic, "%",
          subSteps >= kRecommended ? 1.0 : kNoBound);
    Judge(name + ", energy won", subSteps, 100.0 * won / kinetic, "%", Bound(subSteps, 1.0, 10.0));
    Judge(name + ", gap", subSteps, 1000.0 * gap, "mm",
          Bound(subSteps, subSteps >= kRecommended ? 0.1 : 1.0, 50.0));
}

} // namespace stability
