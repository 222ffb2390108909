// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Rope joints.

/// Keeps two points from being farther apart than a length. Put beside a chain of bodies, it keeps
/// the chain from stretching.
struct b2RopeJointDef : public b2JointDef
{
    b2RopeJointDef() { type = e_ropeJoint; }

    b2Vec2 localAnchorA = b2Vec2(-1.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(1.0f, 0.0f);  ///< in body B's frame [m]
    float32 maxLength = 0.0f;                  ///< of the rope [m], longer than the slop
};

/// Keeps two anchors from getting farther apart than a length.
class b2RopeJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // also that of the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; } ///< in body A's frame [m]
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; } ///< in body B's frame [m]
    void SetMaxLength(float32 length);                   ///< of the rope [m], longer than the slop
    float32 GetMaxLength() const { return m_maxLength; } ///< of the rope [m]
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
    float32 m_impulse = 0.0f; ///< along the rope, of the last step [N s]; never positive
    // Of the last step.
    b2Vec2 m_axis;           ///< unit vector from anchor A to anchor B
    float32 m_length = 0.0f; ///< at its start
};
