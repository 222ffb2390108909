// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Revolute joints: hinges.

/// A hinge: two bodies share a point and turn about it, with an optional limit and motor.
struct b2RevoluteJointDef : public b2JointDef
{
    b2RevoluteJointDef() { type = e_revoluteJoint; }
    /// From a world point [m] at the bodies' present transforms; the joint angle is zero there.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    float32 referenceAngle =
        0.0f;                 ///< body B's angle minus body A's where the joint angle is zero [rad]
    bool enableLimit = false; ///< whether the limits hold
    float32 lowerAngle = 0.0f;     ///< of the limit [rad]
    float32 upperAngle = 0.0f;     ///< of the limit [rad], >= lowerAngle
    bool enableMotor = false;      ///< whether the motor runs
    float32 motorSpeed = 0.0f;     ///< that the motor wants [rad/s], finite
    float32 maxMotorTorque = 0.0f; ///< the most the motor turns with [N m], >= 0
};

/// A hinge: both bodies share a point and turn about it.
class b2RevoluteJoint : public b2Joint
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
    /// Body B's angle minus body A's where the joint is at rest [rad].
    float32 GetReferenceAngle() const { return m_referenceAngle; }
    float32 GetJointAngle() const; ///< B's angle less A's, from the reference [rad], positive when
                                   ///< B turns counter-clockwise
    float32 GetJointSpeed() const; ///< of B as A sees it [rad/s]

    bool IsLimitEnabled() const { return m_enableLimit; }  ///< whether the limits hold
    void EnableLimit(bool flag);                           ///< whether the limits hold
    float32 GetLowerLimit() const { return m_lowerAngle; } ///< where the limit begins [rad]
    float32 GetUpperLimit() const { return m_upperAngle; } ///< where the limit ends [rad]
    void SetLimits(float32 lower, float32 upper); ///< the range left free [rad], lower <= upper

    bool IsMotorEnabled() const { return m_enableMotor; }  ///< whether the motor runs
    void EnableMotor(bool flag);                           ///< whether the motor runs
    void SetMotorSpeed(float32 speed);                     ///< that the motor wants [rad/s], finite
    float32 GetMotorSpeed() const { return m_motorSpeed; } ///< that the motor wants [rad/s], finite
    void SetMaxMotorTorque(float32 torque); ///< the most the motor turns with [N m], >= 0
    /// The most the motor turns with [N m].
    float32 GetMaxMotorTorque() const { return m_maxMotorTorque; }
    /// What the motor did in a step of 1/inv_dt seconds [N m]; inv_dt >= 0.
    float32 GetMotorTorque(float32 inv_dt) const;
    float32 GetMotorTorque() const; ///< for the length of the last step, as above
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

    // Impulses of the last step: of the point [N s]; of the motor and the limits [N m s].
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f);
    float32 m_motorImpulse = 0.0f;
    float32 m_limitImpulse = 0.0f; // positive at the lower limit
};
