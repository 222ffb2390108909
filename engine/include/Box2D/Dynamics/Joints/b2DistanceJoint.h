// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Distance joints.

/// Definition of a distance joint: keeps two points at a distance, rigidly, like a spring, or
/// between a minimum and a maximum.
struct b2DistanceJointDef : public b2JointDef
{
    b2DistanceJointDef() { type = e_distanceJoint; }
    /// Sets bodies, anchors and length from world points [m] at the bodies' current transforms.
    void Initialize(b2Body* bodyA, b2Body* bodyB, const b2Vec2& anchorA, const b2Vec2& anchorB);

    b2Vec2 localAnchorA = b2Vec2(0.0f, 0.0f); ///< in body A's frame [m]
    b2Vec2 localAnchorB = b2Vec2(0.0f, 0.0f); ///< in body B's frame [m]
    float32 length = 1.0f; ///< rest length between the anchors [m], finite, >= 0; not clamped
    /// Frequency of the spring [Hz], >= 0, less than half the step rate; 0: rigid.
    float32 frequencyHz = 0.0f;
    float32 dampingRatio = 0.0f; ///< of the spring, >= 0; 0: none, 1: critical
    /// Limits of the distance [m]. 0 and b2_maxFloat together: none, so a rod or a spring.
    /// Others are clamped as in 2.4: minLength to b2_linearSlop or more, maxLength to minLength or
    /// more. Between them the anchors are free, or the spring holds them. When both are the same
    /// they are rigid.
    float32 minLength = 0.0f;
    float32 maxLength = b2_maxFloat; ///< see minLength; b2_maxFloat or infinity: no maximum
};

/// Keeps two anchors at a distance: rigid, as a spring, or between limits.
class b2DistanceJoint : public b2Joint
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
    /// Sets the rest length between the anchors [m], finite, >= 0, and returns it. Unlike the
    /// limits it is not clamped to b2_linearSlop.
    float32 SetLength(float32 length);
    float32 GetLength() const { return m_length; } ///< rest length between the anchors [m]
    /// Sets the frequency of the spring [Hz], >= 0, less than half the step rate; 0: rigid.
    void SetFrequency(float32 hz);
    float32 GetFrequency() const
    {
        return m_frequencyHz;
    }                                    ///< frequency of the spring [Hz]; 0: rigid
    void SetDampingRatio(float32 ratio); ///< damping ratio of the spring, >= 0; 1 is critical
    /// Returns the damping ratio of the spring, >= 0; 1 is critical.
    float32 GetDampingRatio() const { return m_dampingRatio; }
    /// Limits the distance [m] from below. Clamps the finite length to b2_linearSlop and the
    /// maximum, and returns the result. By the name of 2.4, as the next four. A rod without limits
    /// is free between them once either is set.
    float32 SetMinLength(float32 minLength);
    float32 GetMinLength() const { return m_minLength; } ///< 0: none was set [m]
    /// Limits the distance [m] from above. Clamps the length to the minimum or more, and returns
    /// the result. b2_maxFloat or infinity: no maximum.
    float32 SetMaxLength(float32 maxLength);
    float32 GetMaxLength() const
    {
        return m_maxLength;
    }                                 ///< returns the upper limit [m]; b2_maxFloat: no limit
    float32 GetCurrentLength() const; ///< distance of the anchors at the bodies' current transforms
                                      ///< [m]
    /// True if a spring acts: it has a frequency, and the limits allow motion.
    bool IsSpring() const { return m_springHz > 0.0f; }
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2DistanceJoint(const b2DistanceJointDef* def);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    void SetLimits(float32 minLength, float32 maxLength);
    /// Computes the derived members, once per change instead of once per step.
    void ChooseForm();

    b2Vec2 m_localAnchorA;
    b2Vec2 m_localAnchorB;
    float32 m_length;
    float32 m_frequencyHz;
    float32 m_dampingRatio;
    float32 m_minLength;
    float32 m_maxLength;
    bool m_isLimited;              ///< true if the distance may differ from the rest length
    float32 m_restLength;          ///< rest length of the rod or spring [m]
    float32 m_springHz;            ///< 0: no spring
    float32 m_impulse = 0.0f;      ///< impulse of the rod or spring in the last step [N s]
    float32 m_lowerImpulse = 0.0f; ///< impulse of the lower limit in the last step [N s], >= 0
    float32 m_upperImpulse = 0.0f; ///< see m_lowerImpulse
    b2Vec2 m_axis;                 ///< unit vector from anchor A to anchor B in the last step
};
