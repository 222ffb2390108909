// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Pulley joints.

/// Minimum rope length of programs that keep clear of the singularity [m]. The engine does not use
/// it.
inline constexpr float32 b2_minPulleyLength = 2.0f;

/// Definition of a pulley joint: two bodies on a rope over two fixed points. The sum length A +
/// ratio * length B stays constant; the ratio models a block and tackle. The constraint is an
/// equation, so it pushes as well as pulls. It is singular where a length is zero.
struct b2PulleyJointDef : public b2JointDef
{
    b2PulleyJointDef()
    {
        type = e_pulleyJoint;
        collideConnected = true;
    }
    /// Sets bodies, anchors and lengths from world points [m] at the bodies' current transforms.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& groundAnchorA,
                    const b2Vec2& groundAnchorB, const b2Vec2& anchorA, const b2Vec2& anchorB,
                    float32 ratio);

    b2Vec2 groundAnchorA = b2Vec2(-1.0f, 1.0f); ///< fixed point of the rope to A [m]
    b2Vec2 groundAnchorB = b2Vec2(1.0f, 1.0f);  ///< fixed point of the rope to B [m]
    b2Vec2 localAnchorA = b2Vec2(-1.0f, 0.0f);  ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(1.0f, 0.0f);   ///< in body B's frame [m]
    float32 lengthA = 0.0f;                     ///< of the rope on A's side [m], >= 0
    float32 lengthB = 0.0f;                     ///< of the rope on B's side [m], >= 0
    float32 ratio = 1.0f;                       ///< factor of length B in the constraint, > 0
};

/// A rope over two fixed points: one body moves down as the other moves up, times a ratio.
class b2PulleyJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // adds the overload for the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    /// Returns the fixed point of the rope to A [m].
    b2Vec2 GetGroundAnchorA() const { return m_groundAnchorA; }
    /// Returns the fixed point of the rope to B [m].
    b2Vec2 GetGroundAnchorB() const { return m_groundAnchorB; }
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; } ///< in body A's frame [m]
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; } ///< in body B's frame [m]
    float32 GetDefinedLengthA() const
    {
        return m_lengthA;
    } ///< length in the definition
      ///< [m]
    float32 GetDefinedLengthB() const
    {
        return m_lengthB;
    }                                                          ///< length in the definition
                                                               ///< [m]
    float32 GetLengthA() const { return GetCurrentLengthA(); } ///< as GetCurrentLengthA [m]
    float32 GetLengthB() const { return GetCurrentLengthB(); } ///< as GetCurrentLengthB [m]
    float32 GetRatio() const { return m_ratio; } ///< factor of length B in the constraint
    float32 GetCurrentLengthA() const;           ///< current length of the rope on A's side [m]
    float32 GetCurrentLengthB() const;           ///< current length of the rope on B's side [m]
    void ShiftOrigin(const b2Vec2& newOrigin) override;
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2PulleyJoint(const b2PulleyJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;
    float32 Stretch(const b2Vec2& ropeA, const b2Vec2& ropeB) const;

    b2Vec2 m_groundAnchorA;
    b2Vec2 m_groundAnchorB;
    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_lengthA;
    float32 m_lengthB;
    float32 m_ratio;
    float32 m_impulse = 0.0f; ///< impulse of the last step, in A's rope [N s]
    b2Vec2 m_axisA; ///< unit vector from the ground anchor to the body's, in the last step
    b2Vec2 m_axisB;
};
