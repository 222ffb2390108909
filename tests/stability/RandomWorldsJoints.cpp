// SPDX-License-Identifier: MIT
#include "RandomWorlds.h"

#include <memory>

namespace stability
{

namespace
{

constexpr float32 kRopeAbove = 3.0f; // [m] from a pulley to its load

// Shared pointers, because they delete the original type; joint definitions have no virtual
// destructor.
std::shared_ptr<b2JointDef> Define(const PlannedJoint& plan, b2Body* a, b2Body* b, const b2Vec2& up)
{
    const auto point = [&](auto def) {
        def->Initialize(a, b, plan.anchorB);
        return def;
    };
    switch (plan.type)
    {
    case e_revoluteJoint: {
        auto def = point(std::make_shared<b2RevoluteJointDef>());
        def->enableLimit = plan.limits;
        def->lowerAngle = plan.lower;
        def->upperAngle = plan.upper;
        def->enableMotor = plan.motor;
        def->motorSpeed = plan.speed;
        def->maxMotorTorque = plan.torque;
        return def;
    }
    case e_prismaticJoint: {
        auto def = std::make_shared<b2PrismaticJointDef>();
        def->Initialize(a, b, plan.anchorB, plan.axis);
        def->enableLimit = plan.limits;
        def->lowerTranslation = plan.lower;
        def->upperTranslation = plan.upper;
        def->enableMotor = plan.motor;
        def->motorSpeed = plan.speed;
        def->maxMotorForce = plan.force;
        return def;
    }
    case e_distanceJoint: {
        auto def = std::make_shared<b2DistanceJointDef>();
        def->Initialize(a, b, plan.anchorA, plan.anchorB);
        def->frequencyHz = plan.hz;
        def->dampingRatio = plan.damping;
        return def;
    }
    case e_ropeJoint: {
        auto def = std::make_shared<b2RopeJointDef>();
        def->localAnchorA = a->GetLocalPoint(plan.anchorA);
        def->localAnchorB = b->GetLocalPoint(plan.anchorB);
        def->maxLength = plan.ratio * b2Distance(plan.anchorA, plan.anchorB);
        def->maxLength = b2Max(def->maxLength, 1.01f * b2Distance(plan.anchorA, plan.anchorB));
        return def;
    }
    case e_pulleyJoint: {
        auto def = std::make_shared<b2PulleyJointDef>();
        def->Initialize(a, b, plan.anchorA + kRopeAbove * up, plan.anchorB + kRopeAbove * up,
                        plan.anchorA, plan.anchorB, plan.ratio);
        return def;
    }
    case e_wheelJoint: {
        auto def = std::make_shared<b2WheelJointDef>();
        def->Initialize(a, b, plan.anchorB, plan.axis);
        def->enableMotor = plan.motor;
        def->motorSpeed = plan.speed;
        def->maxMotorTorque = plan.torque;
        def->frequencyHz = plan.hz;
        def->dampingRatio = plan.damping;
        return def;
    }
    case e_weldJoint: {
        auto def = point(std::make_shared<b2WeldJointDef>());
        def->frequencyHz = plan.hz;
        def->dampingRatio = plan.damping;
        return def;
    }
    case e_frictionJoint: {
        auto def = point(std::make_shared<b2FrictionJointDef>());
        def->maxForce = plan.force;
        def->maxTorque = plan.torque;
        return def;
    }
    case e_motorJoint: {
        auto def = std::make_shared<b2MotorJointDef>();
        def->Initialize(a, b);
        def->maxForce = plan.force;
        def->maxTorque = plan.torque;
        return def;
    }
    case e_mouseJoint: {
        auto def = std::make_shared<b2MouseJointDef>();
        def->target = plan.anchorB;
        def->maxForce = plan.force;
        def->frequencyHz = plan.hz;
        def->dampingRatio = plan.damping;
        return def;
    }
    default:
        return std::make_shared<b2GearJointDef>();
    }
}

} // namespace

void RandomWorld::BuildJoint(const PlannedJoint& joint)
{
    b2Body* a = joint.bodyA < 0 ? m_container : m_bodies[std::size_t(joint.bodyA)];
    b2Body* b = m_bodies[std::size_t(joint.bodyB)];
    const float32 g = m_plan.gravity.Length();
    const b2Vec2 up = g > 0.0f ? (-1.0f / g) * m_plan.gravity : b2Vec2(0.0f, 1.0f);
    const std::shared_ptr<b2JointDef> def = Define(joint, a, b, up);
    if (joint.type == e_gearJoint)
    {
        auto& gear = static_cast<b2GearJointDef&>(*def);
        gear.joint1 = m_joints[std::size_t(joint.geared[0])];
        gear.joint2 = m_joints[std::size_t(joint.geared[1])];
        gear.ratio = joint.ratio;
        b = gear.joint2->GetBodyB();
        a = gear.joint1->GetBodyB();
    }
    def->bodyA = a;
    def->bodyB = b;
    def->collideConnected =
        joint.collide || joint.bodyA < 0; // bodies joined to the walls stay within
    m_joints.push_back(m_world.CreateJoint(def.get()));
}

} // namespace stability
