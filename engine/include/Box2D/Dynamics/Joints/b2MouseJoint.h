// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Mouse joints.

/// Definition of a mouse joint: pulls a point of body B towards a world point like a spring, with a
/// limited force. For dragging bodies with the mouse. Body A is unused, but every joint needs one.
struct b2MouseJointDef : public b2JointDef
{
    b2MouseJointDef() { type = e_mouseJoint; }

    b2Vec2 target =
        b2Vec2(0.0f, 0.0f); ///< world point [m]; initially also the point of body B that is pulled
    /// Maximum force [N], >= 0; usually a multiple of the body's weight.
    float32 maxForce = 0.0f;
    float32 frequencyHz = 5.0f;  ///< frequency of the spring [Hz], > 0
    float32 dampingRatio = 0.7f; ///< damping ratio of the spring, >= 0; 1 is critical
};

/// Pulls a point of body B to a target in the world with a soft constraint.
class b2MouseJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // adds the overload for the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    void SetTarget(const b2Vec2& target);                ///< target in world coordinates [m]
    const b2Vec2& GetTarget() const { return m_target; } ///< target in world coordinates [m]
    void SetMaxForce(float32 force);                     ///< maximum force [N], >= 0
    /// Returns the maximum force [N], >= 0.
    float32 GetMaxForce() const { return m_maxForce; }
    void SetFrequency(float32 hz);                         ///< frequency of the spring [Hz], > 0
    float32 GetFrequency() const { return m_frequencyHz; } ///< frequency of the spring [Hz]
    void SetDampingRatio(float32 ratio); ///< damping ratio of the spring, >= 0; 1 is critical
    /// Returns the damping ratio of the spring, >= 0; 1 is critical.
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
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f); ///< impulse of the last step [N s]
};
