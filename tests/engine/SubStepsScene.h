// SPDX-License-Identifier: MIT
#pragma once

#include "JointScene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A world with sub-steps, its invariants, and machines to test it with.
namespace dynamics
{

/// Maximum residual of a rigid joint [m], [rad].
inline constexpr float32 kHeld = 1e-5f;

class SmallScene : public JointScene
{
public:
    explicit SmallScene(const b2Vec2& gravity = b2Vec2(0.0f, -kGravity), int32 count = 4)
        : JointScene(gravity)
    {
        world.SetSubStepCount(count);
        world.SetContinuousPhysics(false);
    }

    /// A body that collides with nothing and never sleeps.
    b2Body* Part(float32 x, float32 y, float32 hx = 0.5f, float32 hy = 0.1f)
    {
        b2Body* body = Load(x, y, hx, hy);
        b2Filter filter;
        filter.maskBits = 0;
        body->GetFixtureList()->SetFilterData(filter);
        parts.push_back(body);
        return body;
    }

    b2RevoluteJoint* Hinge(b2Body* a, b2Body* b, float32 x, float32 y)
    {
        b2RevoluteJointDef def;
        def.Initialize(a, b, b2Vec2(x, y));
        return Create<b2RevoluteJoint>(def);
    }
    b2PrismaticJoint* Slider(b2Body* a, b2Body* b, float32 x, float32 y, const b2Vec2& axis)
    {
        b2PrismaticJointDef def;
        def.Initialize(a, b, b2Vec2(x, y), axis);
        return Create<b2PrismaticJoint>(def);
    }
    b2WeldJoint* Weld(b2Body* a, b2Body* b, float32 x, float32 y)
    {
        b2WeldJointDef def;
        def.Initialize(a, b, b2Vec2(x, y));
        return Create<b2WeldJoint>(def);
    }
    b2DistanceJoint* Rod(b2Body* a, b2Body* b, const b2Vec2& atA, const b2Vec2& atB)
    {
        b2DistanceJointDef def;
        def.Initialize(a, b, atA, atB);
        return Create<b2DistanceJoint>(def);
    }

    double Energy() const
    {
        double sum = 0.0;
        for (const b2Body* b : parts)
        {
            sum += 0.5 * double(b->GetMass()) * double(b->GetLinearVelocity().LengthSquared()) +
                   0.5 * double(b->GetInertia()) * double(b->GetAngularVelocity()) *
                       double(b->GetAngularVelocity()) -
                   double(b->GetMass()) * double(b2Dot(world.GetGravity(), b->GetWorldCenter()));
        }
        return sum;
    }
    double Kinetic() const
    {
        double sum = Energy();
        for (const b2Body* b : parts)
        {
            sum += double(b->GetMass()) * double(b2Dot(world.GetGravity(), b->GetWorldCenter()));
        }
        return sum;
    }
    b2Vec2 Momentum() const
    {
        b2Vec2 sum(0.0f, 0.0f);
        for (const b2Body* b : parts)
        {
            sum += b->GetMass() * b->GetLinearVelocity();
        }
        return sum;
    }
    /// About the origin.
    float32 Spin() const
    {
        float32 sum = 0.0f;
        for (const b2Body* b : parts)
        {
            sum += b->GetMass() * b2Cross(b->GetWorldCenter(), b->GetLinearVelocity()) +
                   b->GetInertia() * b->GetAngularVelocity();
        }
        return sum;
    }

    std::vector<b2Body*> parts;
};

/// Returns the distance of a joint's anchors.
inline float32 Gap(const b2Joint* joint)
{
    return b2Distance(joint->GetAnchorA(), joint->GetAnchorB());
}

/// Returns the distance of the anchors perpendicular to an axis of body A.
inline float32 Across(const b2Joint* joint, const b2Vec2& localAxis)
{
    const b2Vec2 axis = joint->GetBodyA()->GetWorldVector(localAxis);
    return b2Abs(b2Cross(axis, joint->GetAnchorB() - joint->GetAnchorA()));
}

inline float32 Turned(const b2Joint* joint)
{
    return b2Abs(joint->GetBodyB()->GetAngle() - joint->GetBodyA()->GetAngle());
}

} // namespace dynamics
