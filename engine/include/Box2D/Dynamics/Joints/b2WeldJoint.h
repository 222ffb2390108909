// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Weld joints.

/// Definition of a weld joint: fixes two bodies to each other. The angle can have a spring. A chain
/// of welds bends, because the solver is iterative.
struct b2WeldJointDef : public b2JointDef
{
    b2WeldJointDef() { type = e_weldJoint; }
    /// Sets bodies and anchors from a world point [m] at the bodies' current transforms.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchor);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    float32 referenceAngle = 0.0f;            ///< body B's angle minus body A's [rad]
    float32 frequencyHz = 0.0f;  ///< frequency of the angular spring [Hz], >= 0; 0: rigid
    float32 dampingRatio = 0.0f; ///< damping ratio of the spring, >= 0; 1 is critical
};

/// Fixes two bodies to each other; the angle can have a spring.
class b2WeldJoint : public b2Joint
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
    void SetFrequency(float32 hz); ///< frequency of the angular spring [Hz], >= 0; 0: rigid
    float32 GetFrequency() const
    {
        return m_frequencyHz;
    }                                    ///< frequency of the angular spring [Hz]; 0: rigid
    void SetDampingRatio(float32 ratio); ///< damping ratio of the spring, >= 0; 1 is critical
    /// Returns the damping ratio of the spring, >= 0; 1 is critical.
    float32 GetDampingRatio() const { return m_dampingRatio; }
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2WeldJoint(const b2WeldJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_referenceAngle;
    float32 m_frequencyHz;
    float32 m_dampingRatio;

    b2Vec2 m_impulse = b2Vec2(0.0f, 0.0f); ///< of the last step, of the point [N s]
    float32 m_angularImpulse = 0.0f;       ///< angular impulse of the last step [N m s]
};
