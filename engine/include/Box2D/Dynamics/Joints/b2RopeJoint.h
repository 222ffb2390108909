// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Rope joints.

/// Definition of a rope joint: limits the distance of two points. Added to a chain of bodies, it
/// prevents the chain from stretching.
struct b2RopeJointDef : public b2JointDef
{
    b2RopeJointDef() { type = e_ropeJoint; }

    b2Vec2 localAnchorA = b2Vec2(-1.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(1.0f, 0.0f);  ///< in body B's frame [m]
    float32 maxLength = 0.0f;                  ///< maximum length [m], longer than the slop
};

/// Limits the distance of two anchors to a maximum.
class b2RopeJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // adds the overload for the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; } ///< in body A's frame [m]
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; } ///< in body B's frame [m]
    void SetMaxLength(float32 length); ///< maximum length [m], longer than the slop
    float32 GetMaxLength() const { return m_maxLength; } ///< maximum length [m]
    b2LimitState GetLimitState() const;                  ///< e_atUpperLimit while the rope is taut
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2RopeJoint(const b2RopeJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_maxLength;
    float32 m_impulse = 0.0f; ///< along the rope, in the last step [N s]; <= 0
    // Values of the last step.
    b2Vec2 m_axis;           ///< unit vector from anchor A to anchor B
    float32 m_length = 0.0f; ///< distance of the anchors at the start of the step [m]
};
