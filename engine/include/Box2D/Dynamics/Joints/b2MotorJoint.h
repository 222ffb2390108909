// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Motor joints.

/// Definition of a motor joint: drives body B towards a position and angle relative to body A, with
/// limited force and torque. For moving a body against obstacles.
struct b2MotorJointDef : public b2JointDef
{
    b2MotorJointDef() { type = e_motorJoint; }
    /// Sets the bodies, and the current relative transform as the target.
    void Initialize(b2Body* bodyA, b2Body* bodyB);

    b2Vec2 linearOffset = b2Vec2(0.0f, 0.0f); ///< body B's origin in body A's frame [m]
    float32 angularOffset = 0.0f;             ///< body B's angle minus body A's [rad]
    float32 maxForce = 1.0f;                  ///< maximum force [N], >= 0
    float32 maxTorque = 1.0f;                 ///< maximum torque [N m], >= 0
    float32 correctionFactor = 0.3f;          ///< fraction of the error corrected per step, 0 to 1
};

/// Drives body B to a position and an angle relative to body A, with limited force.
class b2MotorJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // adds the overload for the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    void SetLinearOffset(const b2Vec2& linearOffset); ///< body B's origin in body A's frame [m]
    /// Returns body B's origin in body A's frame [m].
    const b2Vec2& GetLinearOffset() const { return m_linearOffset; }
    void SetAngularOffset(float32 angularOffset); ///< body B's angle minus body A's [rad]
    /// Returns body B's angle minus body A's [rad].
    float32 GetAngularOffset() const { return m_angularOffset; }
    void SetMaxForce(float32 force); ///< maximum force [N], >= 0
    /// Returns the maximum force [N], >= 0.
    float32 GetMaxForce() const { return m_maxForce; }
    void SetMaxTorque(float32 torque);                   ///< maximum torque [N m], >= 0
    float32 GetMaxTorque() const { return m_maxTorque; } ///< maximum torque [N m], >= 0
    void SetCorrectionFactor(float32 factor); ///< fraction of the error corrected per step, 0 to 1
    /// Returns the fraction of the error corrected per step, 0 to 1.
    float32 GetCorrectionFactor() const { return m_correctionFactor; }
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2MotorJoint(const b2MotorJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_linearOffset;
    float32 m_angularOffset;
    float32 m_maxForce;
    float32 m_maxTorque;
    float32 m_correctionFactor;
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f); ///< impulse of the last step [N s]
    float32 m_angularImpulse = 0.0f;       ///< angular impulse of the last step [N m s]
};
