// SPDX-License-Identifier: MIT
#include "EnergyAccount.h"

#include <algorithm>
#include <cmath>

namespace stability
{

namespace
{

double Inertia(const b2Body& body)
{
    return double(body.GetInertia()) -
           double(body.GetMass()) * double(body.GetLocalCenter().LengthSquared());
}

double Square(double x)
{
    return x * x;
}

double Inverse(double x)
{
    return x > 0.0 ? 1.0 / x : 0.0;
}

/// Returns the effective mass of an impulse along a direction between two points of bodies.
double EffectiveMass(const b2Body& a, const b2Vec2& pointA, const b2Body& b, const b2Vec2& pointB,
                     const b2Vec2& direction)
{
    double inverse = 0.0;
    const auto add = [&](const b2Body& body, const b2Vec2& point) {
        if (body.GetType() == b2_dynamicBody)
        {
            const double lever = double(b2Cross(point - body.GetWorldCenter(), direction));
            inverse += Inverse(double(body.GetMass())) + lever * lever * Inverse(Inertia(body));
        }
    };
    add(a, pointA);
    add(b, pointB);
    return Inverse(inverse);
}

double Stiffness(double mass, float32 hz)
{
    return mass * Square(2.0 * double(b2_pi) * double(hz));
}

/// Returns the energy of a spring k that pulls with at most F: k x^2 / 2, and linear beyond F / k.
double Bounded(double k, double x, double maximum)
{
    return k * x < maximum ? 0.5 * k * x * x : maximum * x - 0.5 * maximum * maximum / k;
}

} // namespace

EnergyAccount::EnergyAccount(RandomWorld& world) : m_world(world)
{
    m_start = Total();
}

double EnergyAccount::Kinetic() const
{
    double sum = 0.0;
    for (const b2Body* body : m_world.Bodies())
    {
        sum += 0.5 * double(body->GetMass()) * double(body->GetLinearVelocity().LengthSquared()) +
               0.5 * Inertia(*body) * Square(double(body->GetAngularVelocity()));
    }
    return sum;
}

double EnergyAccount::Potential() const
{
    const b2Vec2 g = m_world.Plan().gravity;
    const b2Vec2 half = m_world.Plan().half;
    const double lowest = double(b2Abs(g.x) * half.x + b2Abs(g.y) * half.y);
    double sum = 0.0;
    for (const b2Body* body : m_world.Bodies())
    {
        sum += double(body->GetMass()) * (lowest - double(b2Dot(g, body->GetWorldCenter())));
    }
    return sum;
}

double EnergyAccount::Stored() const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < m_world.Joints().size(); ++i)
    {
        sum += StoredIn(i);
    }
    return sum;
}

EnergyAccount::Spring EnergyAccount::SpringOf(std::size_t index) const
{
    const PlannedJoint& plan = m_world.Plan().joints[index];
    const b2Joint& joint = *m_world.Joints()[index];
    const b2Body& a = *joint.GetBodyA();
    const b2Body& b = *joint.GetBodyB();
    const b2Vec2 pointA = joint.GetAnchorA();
    const b2Vec2 pointB = joint.GetAnchorB();
    Spring spring;
    if (plan.hz == 0.0f)
    {
        return spring;
    }
    if (plan.type == e_distanceJoint)
    {
        b2Vec2 axis = pointB - pointA;
        spring.error =
            double(axis.Normalize() - static_cast<const b2DistanceJoint&>(joint).GetLength());
        spring.stiffness = Stiffness(EffectiveMass(a, pointA, b, pointB, axis), plan.hz);
    }
    else if (plan.type == e_wheelJoint)
    {
        const auto& wheel = static_cast<const b2WheelJoint&>(joint);
        const b2Vec2 axis = a.GetWorldVector(wheel.GetLocalAxisA());
        spring.error = double(b2Dot(axis, pointB - pointA));
        spring.stiffness = Stiffness(EffectiveMass(a, pointB, b, pointB, axis), plan.hz);
    }
    else if (plan.type == e_weldJoint)
    {
        const double inverse =
            (a.GetType() == b2_dynamicBody ? Inverse(Inertia(a)) : 0.0) + Inverse(Inertia(b));
        spring.error = double(b.GetAngle() - a.GetAngle() -
                              static_cast<const b2WeldJoint&>(joint).GetReferenceAngle());
        spring.stiffness = Stiffness(Inverse(inverse), plan.hz);
    }
    return spring;
}

double EnergyAccount::StoredIn(std::size_t index) const
{
    const PlannedJoint& plan = m_world.Plan().joints[index];
    const b2Joint& joint = *m_world.Joints()[index];
    if (plan.type == e_mouseJoint)
    {
        const double way = double(b2Distance(joint.GetAnchorA(), joint.GetAnchorB()));
        return Bounded(Stiffness(double(joint.GetBodyB()->GetMass()), plan.hz), way,
                       double(plan.force));
    }
    const Spring spring = SpringOf(index);
    return 0.5 * spring.stiffness * Square(spring.error);
}

double EnergyAccount::MotorPower(std::size_t index) const
{
    const PlannedJoint& plan = m_world.Plan().joints[index];
    const double speed = plan.motor ? std::abs(double(plan.speed)) : 0.0;
    switch (plan.type)
    {
    case e_revoluteJoint:
    case e_wheelJoint:
        return speed * double(plan.torque);
    case e_prismaticJoint:
        return speed * double(plan.force);
    default:
        return 0.0;
    }
}

double EnergyAccount::PullPower(std::size_t index, float32 step) const
{
    const PlannedJoint& plan = m_world.Plan().joints[index];
    if (plan.type != e_motorJoint)
    {
        return 0.0;
    }
    const auto& motor = static_cast<const b2MotorJoint&>(*m_world.Joints()[index]);
    const b2Body& a = *motor.GetBodyA();
    const b2Body& b = *motor.GetBodyB();
    const b2Vec2 target = a.GetWorldPoint(motor.GetLinearOffset());
    const double way = double(b2Distance(target, b.GetPosition()));
    const double turn = double(b2Abs(b.GetAngle() - a.GetAngle() - motor.GetAngularOffset()));
    const double speed = double(b2Distance(a.GetLinearVelocityFromWorldPoint(target),
                                           b.GetLinearVelocityFromWorldPoint(b.GetPosition())));
    const double spin = double(b2Abs(b.GetAngularVelocity() - a.GetAngularVelocity()));
    const double rate =
        double(motor.GetCorrectionFactor()) * double(m_world.Plan().subSteps) / double(step);
    return double(plan.force) * std::min(speed, rate * way) +
           double(plan.torque) * std::min(spin, rate * turn);
}

void EnergyAccount::BeforeTargets()
{
    m_storedBefore = Stored();
}

void EnergyAccount::AfterTargets()
{
    m_putIn += Stored() - m_storedBefore;
}

void EnergyAccount::BeforeStep()
{
    m_step = m_world.StepLength();
    m_springs.clear();
    m_pulls.clear();
    for (std::size_t i = 0; i < m_world.Joints().size(); ++i)
    {
        m_springs.push_back(SpringOf(i));
        m_putIn += double(m_step) * MotorPower(i);
        m_pulls.push_back(PullPower(i, m_step));
    }
}

void EnergyAccount::AfterStep()
{
    for (std::size_t i = 0; i < m_world.Joints().size(); ++i)
    {
        m_putIn += double(m_step) * std::max(m_pulls[i], PullPower(i, m_step));
        const Spring before = m_springs[i];
        const Spring after = SpringOf(i);
        // At most: at whichever end of the step it counts more.
        const double change = 0.5 * (after.stiffness - before.stiffness);
        m_putIn += std::max(change * Square(before.error), change * Square(after.error));
    }
}

} // namespace stability
