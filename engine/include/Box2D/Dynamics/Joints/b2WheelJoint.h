// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Wheel joints.

/// A wheel on a suspension: body B's anchor stays on a line fixed in body A, sprung along it, free
/// to turn, with an optional motor.
struct b2WheelJointDef : public b2JointDef
{
    b2WheelJointDef() { type = e_wheelJoint; }
    /// From a world point [m] and a world axis, finite and not 0, at the bodies' present
    /// transforms; the joint makes the axis a unit vector.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    b2Vec2 localAxisA = b2Vec2(1.0f, 0.0f);   ///< unit vector in body A's frame, not 0
    bool enableMotor = false;                 ///< whether the motor runs
    float32 maxMotorTorque = 0.0f;            ///< the most the motor turns with [N m], >= 0
    float32 motorSpeed = 0.0f;                ///< that the motor wants [rad/s], finite
    float32 frequencyHz = 2.0f;               ///< of the suspension [Hz], >= 0; 0: none
    float32 dampingRatio = 0.7f;              ///< of the spring, >= 0; 0: none, 1: critical
};

/// A wheel with its suspension: body B turns freely and springs along an axis of body A.
class b2WheelJoint : public b2Joint
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
    const b2Vec2& GetLocalAxisA() const { return m_localAxisA; } ///< unit vector in body A's frame
    float32 GetJointTranslation() const;                         ///< along the axis [m]
    float32 GetJointSpeed() const;                               ///< of the wheel [rad/s]

    bool IsMotorEnabled() const { return m_enableMotor; }  ///< whether the motor runs
    void EnableMotor(bool flag);                           ///< whether the motor runs
    void SetMotorSpeed(float32 speed);                     ///< that the motor wants [rad/s], finite
    float32 GetMotorSpeed() const { return m_motorSpeed; } ///< that the motor wants [rad/s], finite
    void SetMaxMotorTorque(float32 torque); ///< the most the motor turns with [N m], >= 0
    /// The most the motor turns with [N m].
    float32 GetMaxMotorTorque() const { return m_maxMotorTorque; }
    /// What the motor did in a step of 1/inv_dt seconds [N m]; inv_dt >= 0.
    float32 GetMotorTorque(float32 inv_dt) const;
    float32 GetMotorTorque() const;        ///< for the length of the last step, as above
    void SetSpringFrequencyHz(float32 hz); ///< of the suspension [Hz], >= 0; 0: none
    /// Of the suspension [Hz]; 0: none.
    float32 GetSpringFrequencyHz() const { return m_frequencyHz; }
    void SetSpringDampingRatio(float32 ratio); ///< of the spring, >= 0; 0: none, 1: critical
    /// Of the spring, >= 0; 0: none, 1: critical.
    float32 GetSpringDampingRatio() const { return m_dampingRatio; }
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2WheelJoint(const b2WheelJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    b2Vec2 m_localAxisA;
    bool m_enableMotor;
    float32 m_maxMotorTorque;
    float32 m_motorSpeed;
    float32 m_frequencyHz;
    float32 m_dampingRatio;

    // Impulses of the last step: across the axis and along it [N s]; of the motor [N m s].
    float32 m_impulse = 0.0f;
    float32 m_springImpulse = 0.0f;
    float32 m_motorImpulse = 0.0f;
    b2Vec2 m_axis; ///< in world axes, of the last step
};
