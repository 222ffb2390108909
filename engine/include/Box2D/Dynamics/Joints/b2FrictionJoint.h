// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Friction joints.

/// Definition of a friction joint: top-down friction. Slows the relative motion and rotation of two
/// bodies with a limited force and torque.
struct b2FrictionJointDef : public b2JointDef
{
    b2FrictionJointDef() { type = e_frictionJoint; }
    /// Sets bodies and anchors from a world point [m] at the bodies' current transforms.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    float32 maxForce = 0.0f;                  ///< maximum force [N], >= 0
    float32 maxTorque = 0.0f;                 ///< maximum torque [N m], >= 0
};

/// Slows body B relative to body A, as top-down friction between the two.
class b2FrictionJoint : public b2Joint
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
    void SetMaxForce(float32 force);                                 ///< maximum force [N], >= 0
    /// Returns the maximum force [N], >= 0.
    float32 GetMaxForce() const { return m_maxForce; }
    void SetMaxTorque(float32 torque);                   ///< maximum torque [N m], >= 0
    float32 GetMaxTorque() const { return m_maxTorque; } ///< maximum torque [N m], >= 0
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2FrictionJoint(const b2FrictionJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_maxForce;
    float32 m_maxTorque;
    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f); ///< impulse of the last step [N s]
    float32 m_angularImpulse = 0.0f;       ///< angular impulse of the last step [N m s]
};
