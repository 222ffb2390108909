// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>

namespace boxreel
{

b2Joint* AddRod(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& pointA,
                const b2Vec2& pointB, float32 hertz, float32 damping)
{
    b2DistanceJointDef rod;
    rod.Initialize(bodyA, bodyB, pointA, pointB);
    rod.frequencyHz = hertz;
    rod.dampingRatio = damping;
    return world.CreateJoint(&rod);
}

b2Joint* AddMotorHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                       float32 speed, float32 torque)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(bodyA, bodyB, point);
    hinge.enableMotor = true;
    hinge.motorSpeed = speed;
    hinge.maxMotorTorque = torque;
    return world.CreateJoint(&hinge);
}

b2Joint* AddLimitedHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                         float32 lower, float32 upper, float32 friction)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(bodyA, bodyB, point);
    hinge.enableLimit = true;
    hinge.lowerAngle = lower;
    hinge.upperAngle = upper;
    hinge.enableMotor = friction > 0.0f;
    hinge.maxMotorTorque = friction;
    return world.CreateJoint(&hinge);
}

b2Joint* AddSlide(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                  const b2Vec2& axis)
{
    b2Vec2 direction = axis;
    direction.Normalize();
    b2PrismaticJointDef slide;
    slide.Initialize(bodyA, bodyB, point, direction);
    return world.CreateJoint(&slide);
}

b2Joint* AddMotorSlide(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                       const b2Vec2& axis, float32 lower, float32 upper, float32 speed,
                       float32 force)
{
    auto* slide = static_cast<b2PrismaticJoint*>(AddSlide(world, bodyA, bodyB, point, axis));
    slide->SetLimits(lower, upper);
    slide->EnableLimit(true);
    slide->SetMotorSpeed(speed);
    slide->SetMaxMotorForce(force);
    slide->EnableMotor(true);
    return slide;
}

b2Joint* AddWeld(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point, float32 hertz,
                 float32 damping)
{
    b2WeldJointDef weld;
    weld.Initialize(bodyA, bodyB, point);
    weld.frequencyHz = hertz;
    weld.dampingRatio = damping;
    return world.CreateJoint(&weld);
}

b2Joint* AddRope(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& localA,
                 const b2Vec2& localB, float32 length)
{
    b2RopeJointDef rope;
    rope.bodyA = bodyA;
    rope.bodyB = bodyB;
    rope.localAnchorA = localA;
    rope.localAnchorB = localB;
    rope.maxLength = length;
    return world.CreateJoint(&rope);
}

void SetGroup(b2Body& body, int16 group)
{
    b2Filter filter;
    filter.groupIndex = group;
    for (b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext())
    {
        fixture->SetFilterData(filter);
    }
}

} // namespace boxreel
