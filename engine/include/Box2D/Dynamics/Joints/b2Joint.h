// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// The base class of all joints.

class b2Body;
class b2Joint;

namespace box2d
{
struct JointLane;
struct JointAccess;
struct JointFrame;
struct JointRows;
struct SolverContext;
} // namespace box2d

/// The types of joints.
enum b2JointType
{
    e_unknownJoint,   ///< the type is not set
    e_revoluteJoint,  ///< b2RevoluteJoint
    e_prismaticJoint, ///< b2PrismaticJoint
    e_distanceJoint,  ///< b2DistanceJoint
    e_pulleyJoint,    ///< b2PulleyJoint
    e_mouseJoint,     ///< b2MouseJoint
    e_gearJoint,      ///< b2GearJoint
    e_wheelJoint,     ///< b2WheelJoint
    e_weldJoint,      ///< b2WeldJoint
    e_frictionJoint,  ///< b2FrictionJoint
    e_ropeJoint,      ///< b2RopeJoint
    e_motorJoint,     ///< b2MotorJoint
};

/// State of a joint relative to its limits.
enum b2LimitState
{
    e_inactiveLimit, ///< between the limits, or without limits
    e_atLowerLimit,  ///< at the lower limit
    e_atUpperLimit,  ///< at the upper limit
    e_equalLimits,   ///< both limits are equal: no motion is possible
};

/// Computes stiffness [N/m] and damping [N s/m] of a linear spring from a frequency [Hz] and a
/// damping ratio. The spring moves both bodies, or the dynamic one of them; neither is null. The
/// name is that of 2.4.
void b2LinearStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                       float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB);
/// Computes stiffness [N m/rad] and damping [N m s/rad] of an angular spring, as above.
void b2AngularStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                        float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB);

/// Connects bodies and joints: a node of each body's list of joints.
struct b2JointEdge
{
    b2Body* other = nullptr;     ///< the other body
    b2Joint* joint = nullptr;    ///< the joint of this node
    b2JointEdge* prev = nullptr; ///< previous in the body's list; nullptr at the start
    b2JointEdge* next = nullptr; ///< next in the body's list; nullptr at the end
};

/// The base of all joint definitions. b2World::CreateJoint refuses values outside these ranges.
/// Anchors and lengths [m] are within 1e15 of zero. Enabled limits are sorted. Frequencies, damping
/// ratios and maximum forces are >= 0. All numbers are finite except maximum forces, which may be
/// infinite. The bodies given to an Initialize are not null.
struct b2JointDef
{
    b2JointType type = e_unknownJoint; ///< set by the derived definition
    void* userData = nullptr;          ///< user data; the engine does not read it
    b2Body* bodyA = nullptr;           ///< required
    b2Body* bodyB = nullptr;           ///< required, differs from bodyA
    bool collideConnected = false;     ///< true if the two bodies collide with each other
};

/// Constrains two bodies to each other. Created by b2World::CreateJoint, destroyed by
/// b2World::DestroyJoint or with one of its bodies. A setter asserts and changes nothing for a
/// value outside the range in b2JointDef. A change wakes the bodies, except a gear's ratio and a
/// mouse joint's spring and force.
class b2Joint
{
public:
    b2JointType GetType() const { return m_type; }     ///< the concrete type
    b2Body* GetBodyA() { return m_bodyA; }             ///< returns the first body
    const b2Body* GetBodyA() const { return m_bodyA; } ///< returns the first body
    b2Body* GetBodyB() { return m_bodyB; }             ///< returns the second body
    const b2Body* GetBodyB() const { return m_bodyB; } ///< returns the second body
    virtual b2Vec2 GetAnchorA() const = 0;             ///< anchor on body A, in world coordinates
                                                       ///< [m]
    virtual b2Vec2 GetAnchorB() const = 0;             ///< anchor on body B, in world coordinates
                                                       ///< [m]

    /// Returns the force on body B at its anchor [N]; `inv_dt` is one over the time step [1/s], >=
    /// 0.
    virtual b2Vec2 GetReactionForce(float32 inv_dt) const = 0;
    /// Returns the torque on body B [N m], counter-clockwise; `inv_dt` as above.
    virtual float32 GetReactionTorque(float32 inv_dt) const = 0;
    /// Returns the force on body B in the last step [N]; 0 before the first step.
    b2Vec2 GetReactionForce() const;
    float32 GetReactionTorque() const; ///< on body B in the last step [N m]; 0 before the first
                                       ///< step

    b2Joint* GetNext() { return m_next; } ///< next in the world's list; nullptr at the end
    /// Returns the next in the world's list; nullptr at the end.
    const b2Joint* GetNext() const { return m_next; }
    void* GetUserData() const { return m_userData; }    ///< returns the user data
    void SetUserData(void* data) { m_userData = data; } ///< user data; the engine does not read it
    /// True if both bodies are active.
    bool IsActive() const;
    /// True if the two bodies collide with each other.
    bool GetCollideConnected() const { return m_collideConnected; }

    /// Writes the joint as code to the log.
    virtual void Dump();
    /// Shifts points that the joint stores in world coordinates [m]. Called by
    /// b2World::ShiftOrigin.
    virtual void ShiftOrigin(const b2Vec2& newOrigin) { (void)newOrigin; }

protected:
    friend struct box2d::JointAccess;
    explicit b2Joint(const b2JointDef* def);
    virtual ~b2Joint() = default;

    // For the solver. FillLane writes the data that the solver reads during a step, including the
    // impulses of the last one. KeepImpulses stores the new impulses.
    virtual void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) = 0;
    virtual void KeepImpulses(const box2d::JointLane& lane) = 0;
    // With sub-steps, all joints are solved as one system. FillRows computes their rows from the
    // current poses and, for springs, from the velocities before a sub-step. The impulses are those
    // of a step, per row, for rows within and at their force limit.
    virtual void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) = 0;
    virtual void GetRowImpulses(float32 (&impulse)[3]) const = 0;
    virtual void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) = 0;

    /// Returns one over the length of the last step, 0 before the first.
    float32 LastInverseStep() const;
    void WakeBodies();
    /// Records a user change of the rigid constraint.
    void NoteChange();

    b2JointType m_type;
    b2Joint* m_prev = nullptr;
    b2Joint* m_next = nullptr;
    b2JointEdge m_edgeA;
    b2JointEdge m_edgeB;
    b2Body* m_bodyA;
    b2Body* m_bodyB;
    int32 m_number = 0;            ///< creation order
    int32 m_solverIndex = -1;      ///< index among the solved joints, -1 when not solved
    std::uint32_t m_changedAt = 0; ///< World::stepNumber of the last user change of the constraint
    bool m_linked = false;         ///< connects the islands of its bodies
    bool m_collideConnected;
    void* m_userData;
};
