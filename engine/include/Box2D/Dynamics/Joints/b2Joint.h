// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// What all joints have in common.

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

/// The kinds of joints.
enum b2JointType
{
    e_unknownJoint,   ///< of a definition that is none's
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

/// Where a joint is between its limits.
enum b2LimitState
{
    e_inactiveLimit, ///< between them, or there are none
    e_atLowerLimit,  ///< at the lower one
    e_atUpperLimit,  ///< at the upper one
    e_equalLimits,   ///< both are one: it cannot move
};

/// The stiffness [N/m] and damping [N s/m] of the spring that moves both bodies, or the dynamic one
/// of them, with a frequency [Hz] and a damping ratio, by the names of 2.4. The bodies are not
/// null.
void b2LinearStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                       float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB);
/// The same of a spring that turns them [N m/rad], [N m s/rad].
void b2AngularStiffness(float32& stiffness, float32& damping, float32 frequencyHertz,
                        float32 dampingRatio, const b2Body* bodyA, const b2Body* bodyB);

/// Connects bodies and joints: a node of each body's list of joints.
struct b2JointEdge
{
    b2Body* other = nullptr;     ///< the other body
    b2Joint* joint = nullptr;    ///< the joint of this node
    b2JointEdge* prev = nullptr; ///< of the body's list; nullptr: this is its first
    b2JointEdge* next = nullptr; ///< of the body's list; nullptr: this is its last
};

/// The base of every joint's definition. Anchors and lengths [m] are within 1e15 of zero, limits
/// that are on in order, frequencies, damping ratios and largest forces not negative, and all
/// numbers finite but the largest forces, which may be infinite: b2World::CreateJoint refuses
/// others. The bodies that an Initialize is given are not null.
struct b2JointDef
{
    b2JointType type = e_unknownJoint; ///< set by the derived definition
    void* userData = nullptr;          ///< anything of the program's
    b2Body* bodyA = nullptr;           ///< must be set
    b2Body* bodyB = nullptr;           ///< must be set, and differ from bodyA
    bool collideConnected = false;     ///< whether the two bodies still collide with each other
};

/// Constrains two bodies to each other. Created by b2World::CreateJoint, destroyed by
/// b2World::DestroyJoint or with one of its bodies. A number that a setter is given and that
/// b2JointDef's range leaves out asserts and changes nothing; a change wakes the bodies, but for a
/// gear's ratio and a mouse joint's spring and force.
class b2Joint
{
public:
    b2JointType GetType() const { return m_type; }     ///< which class it is
    b2Body* GetBodyA() { return m_bodyA; }             ///< the first body
    const b2Body* GetBodyA() const { return m_bodyA; } ///< the first body
    b2Body* GetBodyB() { return m_bodyB; }             ///< the second body
    const b2Body* GetBodyB() const { return m_bodyB; } ///< the second body
    virtual b2Vec2 GetAnchorA() const = 0;             ///< where it holds body A, in the world [m]
    virtual b2Vec2 GetAnchorB() const = 0;             ///< where it holds body B, in the world [m]

    /// On body B at its anchor [N]; `inv_dt` is one over the time step [1/s], >= 0.
    virtual b2Vec2 GetReactionForce(float32 inv_dt) const = 0;
    /// On body B [N m], anticlockwise; `inv_dt` as above.
    virtual float32 GetReactionTorque(float32 inv_dt) const = 0;
    /// For the length of the last step [N]; 0 before the first.
    b2Vec2 GetReactionForce() const;
    float32 GetReactionTorque() const; ///< of the last step, on body B [N m]; 0 before the first

    b2Joint* GetNext() { return m_next; } ///< of the world's list; nullptr: this is the last
    /// Of the world's list; nullptr: this is the last.
    const b2Joint* GetNext() const { return m_next; }
    void* GetUserData() const { return m_userData; }    ///< what was set
    void SetUserData(void* data) { m_userData = data; } ///< anything of the program's
    /// Both bodies take part in the simulation?
    bool IsActive() const;
    /// Whether the two bodies still collide with each other.
    bool GetCollideConnected() const { return m_collideConnected; }

    /// Writes the joint as code to the log.
    virtual void Dump();
    /// Moves points that the joint keeps in world coordinates [m]: b2World::ShiftOrigin calls it.
    virtual void ShiftOrigin(const b2Vec2& newOrigin) { (void)newOrigin; }

protected:
    friend struct box2d::JointAccess;
    explicit b2Joint(const b2JointDef* def);
    virtual ~b2Joint() = default;

    // The solver's side. FillLane writes what the solver reads of the joint during a step, the
    // impulses of the last one included; KeepImpulses takes them back.
    virtual void FillLane(const box2d::SolverContext& context, box2d::JointLane& lane) = 0;
    virtual void KeepImpulses(const box2d::JointLane& lane) = 0;
    // In small steps all joints are solved together instead. Their rows follow from the present
    // poses and, for springs, from the velocities before a kick; the impulses are those of a step,
    // by row, of what gives way within its force and beyond it.
    virtual void FillRows(const box2d::SolverContext& context, box2d::JointRows& rows) = 0;
    virtual void GetRowImpulses(float32 (&impulse)[3]) const = 0;
    virtual void SetRowImpulses(const float32 (&within)[3], const float32 (&beyond)[3]) = 0;

    /// One over the length of the last step, 0 before the first.
    float32 LastInverseStep() const;
    void WakeBodies();
    /// After a change of what is held rigidly.
    void NoteChange();

    b2JointType m_type;
    b2Joint* m_prev = nullptr;
    b2Joint* m_next = nullptr;
    b2JointEdge m_edgeA;
    b2JointEdge m_edgeB;
    b2Body* m_bodyA;
    b2Body* m_bodyB;
    int32 m_number = 0;            ///< in order of creation
    int32 m_solverIndex = -1;      ///< place among the joints that are solved, -1 when not
    std::uint32_t m_changedAt = 0; ///< the world's step when what it holds was changed by hand
    bool m_linked = false;         ///< joins its bodies' islands
    bool m_collideConnected;
    void* m_userData;
};
