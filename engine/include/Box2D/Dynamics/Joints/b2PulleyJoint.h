// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Pulleys.

/// Two bodies on a rope over two fixed points: length A + ratio * length B stays constant, so one
/// goes up as the other goes down; the ratio makes a block and tackle. An equation, so it pushes
/// too, as a rod does; it becomes singular where a length is zero.
inline constexpr float32 b2_minPulleyLength =
    2.0f; ///< for users who want to keep clear of that [m]

/// What a pulley joint is made from.
struct b2PulleyJointDef : public b2JointDef
{
    b2PulleyJointDef()
    {
        type = e_pulleyJoint;
        collideConnected = true;
    }
    /// From world points [m] at the bodies' present transforms; the lengths are theirs.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& groundAnchorA,
                    const b2Vec2& groundAnchorB, const b2Vec2& anchorA, const b2Vec2& anchorB,
                    float32 ratio);

    b2Vec2 groundAnchorA = b2Vec2(-1.0f, 1.0f); ///< where the rope to A runs down [m]
    b2Vec2 groundAnchorB = b2Vec2(1.0f, 1.0f);  ///< where the rope to B runs down [m]
    b2Vec2 localAnchorA = b2Vec2(-1.0f, 0.0f);  ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(1.0f, 0.0f);   ///< in body B's frame [m]
    float32 lengthA = 0.0f;                     ///< of the rope on A's side [m], >= 0
    float32 lengthB = 0.0f;                     ///< of the rope on B's side [m], >= 0
    float32 ratio = 1.0f;                       ///< what B's length counts against A's, > 0
};

/// A rope over two fixed points: what one body goes down, the other goes up, times a ratio.
class b2PulleyJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // also that of the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    /// Where the rope to A runs down [m].
    b2Vec2 GetGroundAnchorA() const { return m_groundAnchorA; }
    /// Where the rope to B runs down [m].
    b2Vec2 GetGroundAnchorB() const { return m_groundAnchorB; }
    const b2Vec2& GetLocalAnchorA() const { return m_localAnchorA; } ///< in body A's frame [m]
    const b2Vec2& GetLocalAnchorB() const { return m_localAnchorB; } ///< in body B's frame [m]
    float32 GetDefinedLengthA() const { return m_lengthA; }          ///< that of the definition [m]
    float32 GetDefinedLengthB() const { return m_lengthB; }          ///< that of the definition [m]
    float32 GetLengthA() const { return GetCurrentLengthA(); }       ///< of the rope at present [m]
    float32 GetLengthB() const { return GetCurrentLengthB(); }       ///< of the rope at present [m]
    float32 GetRatio() const { return m_ratio; } ///< what B's length counts against A's
    float32 GetCurrentLengthA() const;           ///< of the rope on A's side at present [m]
    float32 GetCurrentLengthB() const;           ///< of the rope on B's side at present [m]
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
    float32 m_impulse = 0.0f; ///< of the last step, in A's rope [N s]
    b2Vec2 m_axisA; ///< unit vector from the ground anchor to the body's, of the last step
    b2Vec2 m_axisB;
};
