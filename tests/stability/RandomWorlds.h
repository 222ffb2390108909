// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <cstdint>
#include <string>
#include <vector>

/// Random worlds, each made from a number that gives the same world on every machine. They have
/// bodies of all shapes with masses from 1 to 1000, fast and slow, and all kinds of joints, in a
/// closed container. A plan is plain data, so parts can be removed. It starts without overlaps and
/// with every joint closed, so all stored energy is accounted for.
namespace stability
{

struct PlannedShape
{
    enum class Kind
    {
        Circle,
        Polygon
    };
    Kind kind = Kind::Circle;
    float32 radius = 0.0f;      ///< of a circle [m]
    std::vector<b2Vec2> points; ///< in the body's frame [m]; of a circle its centre
};

struct PlannedBody
{
    std::vector<PlannedShape> shapes;
    float32 reach = 0.0f; ///< of the shapes around the origin [m]
    float32 mass = 1.0f;  ///< [kg]
    b2Vec2 position;      ///< [m]
    float32 angle = 0.0f; ///< [rad]
    b2Vec2 velocity;      ///< [m/s]
    float32 spin = 0.0f;  ///< [rad/s]
    float32 friction = 0.0f;
    float32 restitution = 0.0f;
    float32 linearDamping = 0.0f;  ///< [1/s]
    float32 angularDamping = 0.0f; ///< [1/s]
    bool bullet = false;
};

/// A joint of any kind. Each kind reads the members that it needs.
struct PlannedJoint
{
    b2JointType type = e_unknownJoint;
    int bodyA = -1; ///< -1: the container
    int bodyB = 0;
    b2Vec2 anchorA; ///< in the world [m]; of a pulley the body's, the ropes end above
    b2Vec2 anchorB;
    b2Vec2 axis; ///< unit vector, in the world
    bool limits = false;
    float32 lower = 0.0f, upper = 0.0f; ///< [m] or [rad]
    bool motor = false;
    float32 speed = 0.0f;        ///< of the motor [m/s] or [rad/s]
    float32 force = 0.0f;        ///< at most [N]
    float32 torque = 0.0f;       ///< at most [N m]
    float32 hz = 0.0f;           ///< of a spring; 0: rigid
    float32 damping = 0.0f;      ///< ratio
    float32 ratio = 1.0f;        ///< of a gear or a pulley
    int geared[2] = {-1, -1};    ///< joints, both before this one
    std::vector<b2Vec2> targets; ///< of a mouse, one after the other [m]
    bool collide = false;
};

struct WorldPlan
{
    enum class Walls
    {
        Thick, ///< boxes, 1 m
        Edges,
        Chain
    };
    int number = 0;
    int crowd = 1;
    int subSteps = 1;
    int velocityIterations = 8;
    int positionIterations = 3;
    float32 steps[2] = {};   ///< [s], in turn
    float32 duration = 0.0f; ///< [s]
    b2Vec2 gravity;          ///< [m/s^2]
    bool sleeps = false;
    Walls walls = Walls::Thick;
    b2Vec2 half; ///< of the room within the walls, around the origin [m]
    float32 wallFriction = 0.0f;
    float32 wallRestitution = 0.0f;
    std::vector<PlannedBody> bodies;
    std::vector<PlannedJoint> joints;

    /// Takes a body out with its joints.
    void RemoveBody(int index);
    /// Takes a joint out with the gears on it.
    void RemoveJoint(int index);
};

/// `crowd`: factor of the number of bodies and joints, and of the area.
WorldPlan PlanWorld(int number, int crowd = 1);

/// For people: a line for the world, each body and each joint.
std::string Describe(const WorldPlan& plan);

/// The world of a plan, with what the plan does to it from step to step.
class RandomWorld
{
public:
    explicit RandomWorld(const WorldPlan& plan);

    /// Moves the targets of mice whose time has come; call before Step.
    void MoveTargets();
    void Step();
    bool IsOver() const { return m_time >= m_plan.duration; }

    const WorldPlan& Plan() const { return m_plan; }
    float32 Time() const { return m_time; }
    float32 StepLength() const { return m_plan.steps[m_count % 2]; } ///< of the next step
    const std::vector<b2Body*>& Bodies() const { return m_bodies; }
    const std::vector<b2Joint*>& Joints() const { return m_joints; }
    b2World& World() { return m_world; }

private:
    void BuildWalls();
    void BuildBody(const PlannedBody& body);
    void BuildJoint(const PlannedJoint& joint);

    WorldPlan m_plan;
    b2World m_world;
    b2Body* m_container = nullptr;
    std::vector<b2Body*> m_bodies;
    std::vector<b2Joint*> m_joints; // as in the plan
    float32 m_time = 0.0f;
    int m_count = 0;
    int m_targets = 0; // moved so far
};

} // namespace stability
