// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Prismatic joints: sliders.

/// A slider: body B moves along an axis fixed in body A and does not turn against it, with an
/// optional limit and motor.
struct b2PrismaticJointDef : public b2JointDef
{
    b2PrismaticJointDef() { type = e_prismaticJoint; }
    /// From a world point [m] and a unit world axis at the bodies' present transforms; the
    /// translation is zero there.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    b2Vec2 localAxisA = b2Vec2(1.0f, 0.0f);   ///< unit vector in body A's frame, not 0
    float32 referenceAngle = 0.0f;            ///< body B's angle minus body A's [rad]
    bool enableLimit = false;                 ///< whether the limits hold
    float32 lowerTranslation = 0.0f;          ///< of the limit [m]
    float32 upperTranslation = 0.0f;          ///< of the limit [m], >= lowerTranslation
    bool enableMotor = false;                 ///< whether the motor runs
    float32 maxMotorForce = 0.0f;             ///< the most the motor pushes with [N], >= 0
    float32 motorSpeed = 0.0f;                ///< that the motor wants [m/s], finite
};

/// Lets body B slide along an axis of body A, and not turn.
class b2PrismaticJoint : public b2Joint
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
    /// Body B's angle minus body A's where the joint is at rest [rad].
    float32 GetReferenceAngle() const { return m_referenceAngle; }
    float32 GetJointTranslation() const; ///< of B's anchor along the axis, as A sees it [m]
    float32 GetJointSpeed() const;       ///< of B as A sees it [m/s]

    bool IsLimitEnabled() const { return m_enableLimit; }        ///< whether the limits hold
    void EnableLimit(bool flag);                                 ///< whether the limits hold
    float32 GetLowerLimit() const { return m_lowerTranslation; } ///< where the limit begins [m]
    float32 GetUpperLimit() const { return m_upperTranslation; } ///< where the limit ends [m]
    void SetLimits(float32 lower, float32 upper); ///< the range left free [m], lower <= upper

    bool IsMotorEnabled() const { return m_enableMotor; }  ///< whether the motor runs
    void EnableMotor(bool flag);                           ///< whether the motor runs
    void SetMotorSpeed(float32 speed);                     ///< that the motor wants [m/s], finite
    float32 GetMotorSpeed() const { return m_motorSpeed; } ///< that the motor wants [m/s], finite
    void SetMaxMotorForce(float32 force); ///< the most the motor pushes with [N], >= 0
    void SetMotorForce(float32 force) { SetMaxMotorForce(force); } ///< as SetMaxMotorForce
    /// The most the motor pushes with [N].
    float32 GetMaxMotorForce() const { return m_maxMotorForce; }
    /// What the motor did in a step of 1/inv_dt seconds [N]; inv_dt >= 0.
    float32 GetMotorForce(float32 inv_dt) const;
    float32 GetMotorForce() const; ///< for the length of the last step, as above
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2PrismaticJoint(const b2PrismaticJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    b2Vec2 m_localAxisA;
    float32 m_referenceAngle;
    bool m_enableLimit;
    float32 m_lowerTranslation;
    float32 m_upperTranslation;
    bool m_enableMotor;
    float32 m_maxMotorForce;
    float32 m_motorSpeed;

    // Impulses of the last step: across the axis [N s] and against turning [N m s]; along the axis
    // [N s].
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f);
    float32 m_motorImpulse = 0.0f;
    float32 m_limitImpulse = 0.0f; // positive at the lower limit
    b2Vec2 m_axis;                 ///< in world axes, of the last step
};
