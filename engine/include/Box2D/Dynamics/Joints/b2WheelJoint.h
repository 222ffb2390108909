// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Wheel joints.

/// Definition of a wheel joint (suspension): body B's anchor stays on a line fixed in body A, with
/// a spring along it. Body B rotates freely, with an optional motor.
struct b2WheelJointDef : public b2JointDef
{
    b2WheelJointDef() { type = e_wheelJoint; }
    /// Sets bodies, anchors and axis from a world point [m] and a world axis at the bodies' current
    /// transforms. The axis is finite and not 0; it is normalized.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    b2Vec2 localAxisA = b2Vec2(1.0f, 0.0f);   ///< unit vector in body A's frame, not 0
    bool enableMotor = false;                 ///< true if the motor is enabled
    float32 maxMotorTorque = 0.0f;            ///< maximum motor torque [N m], >= 0
    float32 motorSpeed = 0.0f;                ///< target speed of the motor [rad/s], finite
    float32 frequencyHz = 2.0f;  ///< frequency of the suspension [Hz], >= 0; 0: no spring
    float32 dampingRatio = 0.7f; ///< damping ratio of the spring, >= 0; 1 is critical
};

/// A wheel with suspension: body B rotates freely and is sprung along an axis of body A.
class b2WheelJoint : public b2Joint
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
    const b2Vec2& GetLocalAxisA() const { return m_localAxisA; } ///< unit vector in body A's frame
    float32 GetJointTranslation() const;                         ///< position of B's anchor along
                                                                 ///< the axis [m]
    float32 GetJointSpeed() const;                               ///< angular velocity of the wheel
                                                                 ///< relative to A [rad/s]

    bool IsMotorEnabled() const { return m_enableMotor; } ///< true if the motor is enabled
    void EnableMotor(bool flag);                          ///< enables or disables the motor
    void SetMotorSpeed(float32 speed); ///< target speed of the motor [rad/s], finite
    float32 GetMotorSpeed() const
    {
        return m_motorSpeed;
    }                                       ///< target speed of the motor [rad/s], finite
    void SetMaxMotorTorque(float32 torque); ///< maximum motor torque [N m], >= 0
    /// Returns the maximum motor torque [N m].
    float32 GetMaxMotorTorque() const { return m_maxMotorTorque; }
    /// Returns the motor torque [N m] in a step of 1/inv_dt seconds; inv_dt >= 0.
    float32 GetMotorTorque(float32 inv_dt) const;
    float32 GetMotorTorque() const;        ///< as above, for the last step
    void SetSpringFrequencyHz(float32 hz); ///< frequency of the suspension [Hz], >= 0; 0: no spring
    /// Returns the frequency of the suspension [Hz]; 0: no spring.
    float32 GetSpringFrequencyHz() const { return m_frequencyHz; }
    void SetSpringDampingRatio(float32 ratio); ///< damping ratio of the spring, >= 0; 1 is critical
    /// Returns the damping ratio of the spring, >= 0; 1 is critical.
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

    // Impulses of the last step: perpendicular to the axis, along it [N s]; motor [N m s].
    float32 m_impulse = 0.0f;
    float32 m_springImpulse = 0.0f;
    float32 m_motorImpulse = 0.0f;
    b2Vec2 m_axis; ///< in world axes, in the last step
};
