// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/Joints/b2GearJoint.h>

#include "../State/Access.h"
#include "GearKind.h"
#include "GearLanes.h"
#include "JointChecks.h"
#include "JointFrame.h"
#include "JointRows.h"

#include <Box2D/Dynamics/Joints/b2PrismaticJoint.h>
#include <Box2D/Dynamics/Joints/b2RevoluteJoint.h>

// C = q1 + ratio q2 - constant, where each q is a joint's coordinate:
//   hinge:   q = aBody - aFrame - reference     Jv = 0,  Jw(body) = 1,  Jw(frame) = 1
//   slider:  q = dot(axis, pBody - pFrame)      Jv = n
//            Jw(body) = rBody x n,  Jw(frame) = (d + rFrame) x n
//   K = sum over the sides of weight^2 (m Jv^2 + i Jw^2) of body and frame, weight 1 and ratio
// Up to four bodies take part, those of the two joints.

namespace box2d
{

namespace
{

bool Has(const b2Joint& joint, const b2Body* body)
{
    return body == joint.GetBodyA() || body == joint.GetBodyB();
}

/// True if the island of all that the gear moves includes what this joint moves. The gear is then
/// between `body` and a body of the other joint.
bool Reaches(b2Joint& joint, const b2Body& body, b2Joint& otherJoint)
{
    b2Body& other = *(&body == joint.GetBodyA() ? joint.GetBodyB() : joint.GetBodyA());
    return Data(body).IsDynamic() || !Data(other).IsDynamic() || Has(otherJoint, &other);
}

/// The body that the definition names for the joint first, or for the other joint. If neither is
/// of this joint, its second body, which the joint is about.
void SortBodies(b2Joint& joint, b2Body* wish, b2Body* otherWish, b2Body* (&bodies)[2])
{
    bodies[0] = Has(joint, wish) ? wish : Has(joint, otherWish) ? otherWish : joint.GetBodyB();
    bodies[1] = bodies[0] == joint.GetBodyA() ? joint.GetBodyB() : joint.GetBodyA();
}

bool HasBody(const b2GearJointDef& d, const b2Body* body)
{
    return Has(*d.joint1, body) || Has(*d.joint2, body);
}

bool IsOfWorld(const b2Joint& joint, const b2World* world)
{
    return joint.GetBodyA()->GetWorld() == world;
}

} // namespace

GearBodies BodiesOf(const b2GearJointDef& def)
{
    b2Body* first[2];
    b2Body* second[2];
    SortBodies(*def.joint1, def.bodyA, def.bodyB, first);
    SortBodies(*def.joint2, def.bodyB, def.bodyA, second);
    GearBodies unmoved;
    for (b2Body* a : first)
    {
        for (b2Body* b : second)
        {
            if (a == b)
            {
                continue;
            }
            if ((Data(*a).IsDynamic() || Data(*b).IsDynamic()) &&
                Reaches(*def.joint1, *a, *def.joint2) && Reaches(*def.joint2, *b, *def.joint1))
            {
                return {a, b};
            }
            unmoved = unmoved.a == nullptr ? GearBodies{a, b} : unmoved;
        }
    }
    return unmoved;
}

bool CanBeGeared(const b2Joint* joint)
{
    return joint && (joint->GetType() == e_revoluteJoint || joint->GetType() == e_prismaticJoint);
}

bool JointAccess::Kind<b2GearJoint>::IsSound(const b2GearJointDef& d)
{
    return B2_REQUIRE(CanBeGeared(d.joint1) && CanBeGeared(d.joint2),
                      "A gear joint needs two joints, each revolute or prismatic.") &&
           B2_REQUIRE(HasBody(d, d.bodyA) && HasBody(d, d.bodyB),
                      "A gear joint's bodyA and bodyB must be bodies of its two joints.") &&
           B2_REQUIRE(d.joint1 != d.joint2 && BodiesOf(d).a != nullptr,
                      "A gear joint's two joints must move two different bodies.") &&
           B2_REQUIRE(IsOfWorld(*d.joint1, d.bodyA->GetWorld()) &&
                          IsOfWorld(*d.joint2, d.bodyA->GetWorld()),
                      "A gear joint's two joints must be of the world of its bodies.") &&
           IsGearRatio(d.ratio);
}

} // namespace box2d

b2GearJoint::Side b2GearJoint::MakeSide(b2Joint* joint)
{
    Side side;
    side.joint = joint;
    side.frame = joint->GetBodyA();
    side.body = joint->GetBodyB();
    if (joint->GetType() == e_revoluteJoint)
    {
        const auto* hinge = static_cast<const b2RevoluteJoint*>(joint);
        side.referenceAngle = hinge->GetReferenceAngle();
    }
    else
    {
        const auto* slider = static_cast<const b2PrismaticJoint*>(joint);
        side.slides = true;
        side.localAnchorFrame = slider->GetLocalAnchorA();
        side.localAnchorBody = slider->GetLocalAnchorB();
        side.localAxis = slider->GetLocalAxisA();
    }
    return side;
}

namespace
{

using box2d::BodyData;
using box2d::Data;

b2JointDef WithGearBodies(const b2GearJointDef* def)
{
    b2JointDef base = *def;
    const box2d::GearBodies bodies = box2d::BodiesOf(*def);
    base.bodyA = bodies.a;
    base.bodyB = bodies.b;
    return base;
}

} // namespace

b2GearJoint::b2GearJoint(const b2GearJointDef* def) : b2GearJoint(def, WithGearBodies(def)) {}

b2GearJoint::b2GearJoint(const b2GearJointDef* def, const b2JointDef& base)
    : b2Joint(&base), m_joint1(def->joint1), m_joint2(def->joint2), m_side1(MakeSide(def->joint1)),
      m_side2(MakeSide(def->joint2)), m_ratio(def->ratio)
{
    m_constant = Coordinate(m_side1, nullptr) + double(m_ratio) * Coordinate(m_side2, nullptr);
}

/// Returns the joint's coordinate [rad or m]: at the start of the step, or with a context after the
/// displacements in it.
double b2GearJoint::Coordinate(const Side& side, const box2d::SolverContext* context)
{
    const box2d::JointPair pair(*side.frame, *side.body, context ? context->bodies : nullptr);
    if (!side.slides)
    {
        return pair.dataB.pose.angle + double(pair.b.angle) - pair.dataA.pose.angle -
               double(pair.a.angle) - double(side.referenceAngle);
    }
    return double(
        pair.Along(side.localAxis, side.localAnchorFrame, side.localAnchorBody).translation);
}

/// Computes the derivative of the coordinate by the velocities, at the same pose.
void b2GearJoint::Measure(Side& side, const box2d::SolverContext* context)
{
    side.axis.SetZero();
    side.armFrame = 1.0f;
    side.armBody = 1.0f;
    if (side.slides)
    {
        const box2d::JointPair pair(*side.frame, *side.body, context->bodies);
        const b2Vec2 armBody = pair.ArmB(side.localAnchorBody);
        side.axis = pair.AxisOfA(side.localAxis);
        side.armFrame = b2Cross(pair.Offset() + armBody, side.axis);
        side.armBody = b2Cross(armBody, side.axis);
    }
}

namespace
{

float32 SideMatrix(const b2Body& frameBody, const b2Body& movingBody, const b2Vec2& axis,
                   float32 armFrame, float32 armBody)
{
    const BodyData& frame = Data(frameBody);
    const BodyData& body = Data(movingBody);
    const float32 linear = axis.LengthSquared() * (frame.SolverInvMass() + body.SolverInvMass());
    return linear + frame.SolverInvInertia() * armFrame * armFrame +
           body.SolverInvInertia() * armBody * armBody;
}

} // namespace

float32 b2GearJoint::EffectiveMass() const
{
    const float32 k =
        SideMatrix(*m_side1.frame, *m_side1.body, m_side1.axis, m_side1.armFrame, m_side1.armBody) +
        m_ratio * m_ratio *
            SideMatrix(*m_side2.frame, *m_side2.body, m_side2.axis, m_side2.armFrame,
                       m_side2.armBody);
    return box2d::InverseOrZero(k + 2.0f * m_ratio * SharedMatrix());
}

/// Returns the mixed terms of a body that is part of both joints: the square of a sum.
float32 b2GearJoint::SharedMatrix() const
{
    float32 sum = 0.0f;
    for (const bool isBody1 : {false, true})
    {
        for (const bool isBody2 : {false, true})
        {
            const b2Body* body = isBody1 ? m_side1.body : m_side1.frame;
            if (body == (isBody2 ? m_side2.body : m_side2.frame))
            {
                const float32 arm1 = isBody1 ? m_side1.armBody : m_side1.armFrame;
                const float32 arm2 = isBody2 ? m_side2.armBody : m_side2.armFrame;
                const float32 both =
                    Data(*body).SolverInvMass() * b2Dot(m_side1.axis, m_side2.axis) +
                    Data(*body).SolverInvInertia() * arm1 * arm2;
                sum += isBody1 == isBody2 ? both : -both;
            }
        }
    }
    return sum;
}

namespace
{

/// Returns the values of a side that are constant during a step.
box2d::GearLanes<float32>::Side SideOf(const BodyData& frame, const BodyData& body, bool slides,
                                       const b2Vec2& localAnchorFrame,
                                       const b2Vec2& localAnchorBody)
{
    box2d::GearLanes<float32>::Side side = {};
    if (slides)
    {
        side.armA = box2d::InLanes(b2Mul(frame.rotation, localAnchorFrame - frame.localCenter));
        side.armB = box2d::InLanes(b2Mul(body.rotation, localAnchorBody - body.localCenter));
        side.offset = box2d::InLanes(box2d::CenterOffset(frame, body));
        side.slides = 1.0f;
    }
    return side;
}

} // namespace

void b2GearJoint::FillLane(const box2d::SolverContext& context, box2d::JointLane& lane)
{
    box2d::Scale(m_impulse, box2d::WarmStartFactor(context));
    box2d::GearLanes<float32> gear = {};
    double coordinate[2] = {};
    for (Side* side : {&m_side1, &m_side2})
    {
        const int index = side == &m_side1 ? 0 : 1;
        Measure(*side, &context);
        coordinate[index] = Coordinate(*side, &context);
        box2d::GearLanes<float32>::Side& to = gear.sides[index];
        to = SideOf(Data(*side->frame), Data(*side->body), side->slides, side->localAnchorFrame,
                    side->localAnchorBody);
        to.axis = box2d::InLanes(side->axis);
        to.armFrame = side->armFrame;
        to.armBody = side->armBody;
        to.start = side->slides ? float32(coordinate[index]) : 0.0f;
    }
    const BodyData& frame2 = Data(*m_side2.frame);
    const BodyData& body2 = Data(*m_side2.body);
    gear.impulse = m_impulse;
    gear.second = {frame2.SolverInvMass(), frame2.SolverInvInertia(), body2.SolverInvMass(),
                   body2.SolverInvInertia()};
    gear.ratio = m_ratio;
    gear.mass = EffectiveMass();
    gear.error = float32(coordinate[0] + double(m_ratio) * coordinate[1] - m_constant);
    lane.Write(gear);
}

void b2GearJoint::KeepImpulses(const box2d::JointLane& lane)
{
    m_impulse = lane[0];
}

void b2GearJoint::FillRows(const box2d::SolverContext& context, box2d::JointRows& rows)
{
    // The columns have the order of the joints' bodies: frame 1, body 1, frame 2, body 2.
    for (Side* side : {&m_side1, &m_side2})
    {
        const float32 weight = side == &m_side1 ? 1.0f : m_ratio;
        Measure(*side, &context);
        rows.Of(Data(*side->frame)).AddTo(0, -weight * side->axis, -weight * side->armFrame);
        rows.Of(Data(*side->body)).AddTo(0, weight * side->axis, weight * side->armBody);
    }
    rows.error[0] = float32(Coordinate(m_side1, &context) +
                            double(m_ratio) * Coordinate(m_side2, &context) - m_constant);
    rows.rows = 1;
}

void b2GearJoint::GetRowImpulses(float32 (&impulse)[3]) const
{
    impulse[0] = m_impulse;
}

void b2GearJoint::SetRowImpulses(const float32 (&within)[3], const float32 (&)[3])
{
    m_impulse = within[0];
}

b2Vec2 b2GearJoint::GetAnchorA() const
{
    return m_joint1->GetAnchorB();
}

b2Vec2 b2GearJoint::GetAnchorB() const
{
    return m_joint2->GetAnchorB();
}

b2Vec2 b2GearJoint::GetReactionForce(float32 inv_dt) const
{
    return (inv_dt * m_ratio * m_impulse) * m_side2.axis;
}

float32 b2GearJoint::GetReactionTorque(float32 inv_dt) const
{
    return inv_dt * m_ratio * m_impulse * m_side2.armBody;
}

void b2GearJoint::SetRatio(float32 ratio)
{
    if (box2d::IsGearRatio(ratio))
    {
        m_ratio = ratio;
        NoteChange();
    }
}

void b2GearJoint::Dump()
{
    box2d::DumpBodies("b2GearJointDef", *m_bodyA, *m_bodyB, m_collideConnected);
    b2Log("  jd.joint1 = joints[%d];\n", box2d::JointAccess::Number(*m_joint1));
    b2Log("  jd.joint2 = joints[%d];\n", box2d::JointAccess::Number(*m_joint2));
    box2d::DumpNumber("ratio", m_ratio);
    box2d::DumpEnd(m_number);
}
