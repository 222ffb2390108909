// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Mouse joints.

/// Pulls a point of body B towards a world point like a spring, with at most a force. Made for
/// dragging bodies with the mouse; body A is only there because every joint has one.
struct b2MouseJointDef : public b2JointDef
{
    b2MouseJointDef() { type = e_mouseJoint; }

    b2Vec2 target =
        b2Vec2(0.0f, 0.0f); ///< world point [m]; at first also that of body B that is pulled
    /// The most it pulls or pushes with [N], >= 0; usually some multiple of the body's weight.
    float32 maxForce = 0.0f;
    float32 frequencyHz = 5.0f;  ///< of the spring [Hz], > 0
    float32 dampingRatio = 0.7f; ///< of the spring, >= 0; 0: none, 1: critical
};

/// Pulls a point of body B to a target in the world, softly.
class b2MouseJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // also that of the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    void SetTarget(const b2Vec2& target);                ///< where it pulls to, in the world [m]
    const b2Vec2& GetTarget() const { return m_target; } ///< where it pulls to [m]
    void SetMaxForce(float32 force); ///< the most it pulls or pushes with [N], >= 0
    /// The most it pulls or pushes with [N], >= 0.
    float32 GetMaxForce() const { return m_maxForce; }
    void SetFrequency(float32 hz);                         ///< of the spring [Hz], > 0
    float32 GetFrequency() const { return m_frequencyHz; } ///< of the spring [Hz]
    void SetDampingRatio(float32 ratio); ///< of the spring, >= 0; 0: none, 1: critical
    /// Of the spring, >= 0; 0: none, 1: critical.
    float32 GetDampingRatio() const { return m_dampingRatio; }
    void ShiftOrigin(const b2Vec2& newOrigin) override;
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2MouseJoint(const b2MouseJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorB;
    b2Vec2 m_target;
    float32 m_maxForce;
    float32 m_frequencyHz;
    float32 m_dampingRatio;
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f); ///< of the last step [N s]
};
