// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Revolute joints.

/// Definition of a revolute joint (hinge): two bodies share a point and rotate about it, with an
/// optional limit and motor.
struct b2RevoluteJointDef : public b2JointDef
{
    b2RevoluteJointDef() { type = e_revoluteJoint; }
    /// Sets bodies and anchors from a world point [m] at the bodies' current transforms. The joint
    /// angle is zero there.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    float32 referenceAngle = 0.0f; ///< body B's angle minus body A's at joint angle zero [rad]
    bool enableLimit = false;      ///< true if the limits are enabled
    float32 lowerAngle = 0.0f;     ///< lower limit [rad]
    float32 upperAngle = 0.0f;     ///< upper limit [rad], >= lowerAngle
    bool enableMotor = false;      ///< true if the motor is enabled
    float32 motorSpeed = 0.0f;     ///< target speed of the motor [rad/s], finite
    float32 maxMotorTorque = 0.0f; ///< maximum motor torque [N m], >= 0
};

/// A hinge: both bodies share a point and rotate about it.
class b2RevoluteJoint : public b2Joint
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
    /// Returns body B's angle minus body A's in the reference pose [rad].
    float32 GetReferenceAngle() const { return m_referenceAngle; }
    float32 GetJointAngle() const; ///< B's angle minus A's minus the reference angle [rad],
                                   ///< counter-clockwise
    float32 GetJointSpeed() const; ///< angular velocity of B relative to A [rad/s]

    bool IsLimitEnabled() const { return m_enableLimit; }  ///< true if the limits are enabled
    void EnableLimit(bool flag);                           ///< enables or disables the limits
    float32 GetLowerLimit() const { return m_lowerAngle; } ///< lower limit [rad]
    float32 GetUpperLimit() const { return m_upperAngle; } ///< upper limit [rad]
    void SetLimits(float32 lower,
                   float32 upper); ///< allowed range of the angle [rad], lower <= upper

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
    float32 GetMotorTorque() const; ///< as above, for the last step
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2RevoluteJoint(const b2RevoluteJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_referenceAngle;
    bool m_enableLimit;
    float32 m_lowerAngle;
    float32 m_upperAngle;
    bool m_enableMotor;
    float32 m_motorSpeed;
    float32 m_maxMotorTorque;

    // Impulses of the last step: linear [N s]; motor and limits [N m s].
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f);
    float32 m_motorImpulse = 0.0f;
    float32 m_limitImpulse = 0.0f; // impulse of the limit; positive at the lower limit
};
