// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>

/// @file
/// Gear joints.

/// Couples two joints, each a revolute or a prismatic one: coordinate 1 + ratio * coordinate 2
/// stays constant. Destroy the gear before its joints. Otherwise it is destroyed with the first of
/// them.
///
/// bodyA and bodyB are two different bodies of the joints; others are refused. The gear's body A is
/// the one that belongs to joint1, its body B the one that belongs to joint2. If neither belongs to
/// that joint, the gear uses body B of the joint. A static body is accepted only if the gear then
/// still connects all bodies that it moves, such as a fixed sun wheel. Otherwise the joint's other
/// body is used.
struct b2GearJointDef : public b2JointDef
{
    b2GearJointDef() { type = e_gearJoint; }

    b2Joint* joint1 = nullptr; ///< revolute or prismatic
    b2Joint* joint2 = nullptr; ///< revolute or prismatic
    float32 ratio = 1.0f; ///< finite, may be negative; with one joint of each type its unit is a
                          ///< length or an inverse length
};

/// Couples two joints: the motion of one is the motion of the other times a ratio.
class b2GearJoint : public b2Joint
{
public:
    b2Vec2 GetAnchorA() const override;
    b2Vec2 GetAnchorB() const override;
    using b2Joint::GetReactionForce;
    using b2Joint::GetReactionTorque; // adds the overload for the last step
    b2Vec2 GetReactionForce(float32 inv_dt) const override;
    float32 GetReactionTorque(float32 inv_dt) const override;

    b2Joint* GetJoint1() { return m_joint1; } ///< revolute or prismatic
    b2Joint* GetJoint2() { return m_joint2; } ///< revolute or prismatic
    void SetRatio(float32 ratio); ///< sets the ratio: finite, may be negative; unit as in the
                                  ///< definition
    float32 GetRatio() const { return m_ratio; } ///< returns the ratio
    void Dump() override;

protected:
    friend struct box2d::JointAccess;
    explicit b2GearJoint(const b2GearJointDef* def);
    b2GearJoint(const b2GearJointDef* def, const b2JointDef& base);
    void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) override;
    void KeepImpulses(const box2d::JointLane& lane) override;
    void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) override;
    void GetRowImpulses(float32 (&impulse)[3]) const override;
    void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) override;

    /// One of the two joints: a coordinate of its body B relative to its body A.
    struct Side
    {
        b2Joint* joint = nullptr;
        b2Body* frame = nullptr; ///< the joint's body A
        b2Body* body = nullptr;  ///< the joint's body B
        bool slides = false;     ///< prismatic
        b2Vec2 localAnchorFrame;
        b2Vec2 localAnchorBody;
        b2Vec2 localAxis; ///< in the frame's axes
        float32 referenceAngle = 0.0f;

        // Values of one step: the derivative of the coordinate by the velocities.
        b2Vec2 axis; ///< zero for a hinge
        float32 armFrame = 0.0f;
        float32 armBody = 0.0f;
    };

    static Side MakeSide(b2Joint* joint);
    static double Coordinate(const Side& side, const box2d::SolverContext* context);
    static void Measure(Side& side, const box2d::SolverContext* context);
    float32 EffectiveMass() const;
    float32 SharedMatrix() const;

    b2Joint* m_joint1;
    b2Joint* m_joint2;
    Side m_side1;
    Side m_side2;
    double m_constant; ///< coordinate 1 + ratio * coordinate 2
    float32 m_ratio;
    float32 m_impulse = 0.0f; ///< impulse of the last step
};
