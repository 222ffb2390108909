// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Prismatic joints: sliders.

/// Definition of a prismatic joint: body B slides along an axis fixed in body A without relative
/// rotation, with an optional limit and motor.
struct b2PrismaticJointDef : public b2JointDef
{
    b2PrismaticJointDef() { type = e_prismaticJoint; }
    /// Sets bodies, anchors and axis from a world point [m] and a unit world axis at the bodies'
    /// current transforms. The translation is zero there.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor, const b2Vec2& axis);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    b2Vec2 localAxisA = b2Vec2(1.0f, 0.0f);   ///< unit vector in body A's frame, not 0
    float32 referenceAngle = 0.0f;            ///< body B's angle minus body A's [rad]
    bool enableLimit = false;                 ///< true if the limits are enabled
    float32 lowerTranslation = 0.0f;          ///< lower limit [m]
    float32 upperTranslation = 0.0f;          ///< upper limit [m], >= lowerTranslation
    bool enableMotor = false;                 ///< true if the motor is enabled
    float32 maxMotorForce = 0.0f;             ///< maximum motor force [N], >= 0
    float32 motorSpeed = 0.0f;                ///< target speed of the motor [m/s], finite
};

/// Lets body B slide along an axis of body A without relative rotation.
class b2PrismaticJoint : public b2Joint
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
    /// Returns body B's angle minus body A's in the reference pose [rad].
    float32 GetReferenceAngle() const { return m_referenceAngle; }
    float32 GetJointTranslation() const; ///< position of B's anchor along the axis, relative to A's
                                         ///< anchor [m]
    float32 GetJointSpeed() const;       ///< speed of B relative to A along the axis [m/s]

    bool IsLimitEnabled() const { return m_enableLimit; }        ///< true if the limits are enabled
    void EnableLimit(bool flag);                                 ///< enables or disables the limits
    float32 GetLowerLimit() const { return m_lowerTranslation; } ///< lower limit [m]
    float32 GetUpperLimit() const { return m_upperTranslation; } ///< upper limit [m]
    void SetLimits(float32 lower,
                   float32 upper); ///< allowed range of the translation [m], lower <= upper

    bool IsMotorEnabled() const { return m_enableMotor; } ///< true if the motor is enabled
    void EnableMotor(bool flag);                          ///< enables or disables the motor
    void SetMotorSpeed(float32 speed); ///< target speed of the motor [m/s], finite
    float32 GetMotorSpeed() const
    {
        return m_motorSpeed;
    }                                     ///< target speed of the motor [m/s], finite
    void SetMaxMotorForce(float32 force); ///< maximum motor force [N], >= 0
    void SetMotorForce(float32 force) { SetMaxMotorForce(force); } ///< as SetMaxMotorForce
    /// Returns the maximum motor force [N].
    float32 GetMaxMotorForce() const { return m_maxMotorForce; }
    /// Returns the motor force [N] in a step of 1/inv_dt seconds; inv_dt >= 0.
    float32 GetMotorForce(float32 inv_dt) const;
    float32 GetMotorForce() const; ///< as above, for the last step
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

    // Impulses of the last step: perpendicular to the axis [N s], angular [N m s]; motor and limit
    // [N s].
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f);
    float32 m_motorImpulse = 0.0f;
    float32 m_limitImpulse = 0.0f; // impulse of the limit; positive at the lower limit
    b2Vec2 m_axis;                 ///< in world axes, in the last step
};
