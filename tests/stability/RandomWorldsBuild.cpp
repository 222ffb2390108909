// SPDX-License-Identifier: MIT
#include "RandomWorlds.h"

#include <cmath>
#include <cstdio>

namespace stability
{

namespace
{

constexpr float32 kWallThickness = 1.0f; // [m]
constexpr float32 kTargetTime = 1.0f;    // [s] between one target of a mouse and the next

const char* NameOf(b2JointType type)
{
    constexpr const char* kNames[] = {"unknown", "revolute", "prismatic", "distance",
                                      "pulley",  "mouse",    "gear",      "wheel",
                                      "weld",    "friction", "rope",      "motor"};
    return kNames[type];
}

template <class... Values>
std::string Print(const char* format, Values... values)
{
    char line[512];
    std::snprintf(line, sizeof line, format, values...);
    return line;
}

double Number(float32 value)
{
    return double(value);
}

std::string DescribeBody(const PlannedBody& body, std::size_t index)
{
    std::string shapes;
    for (const PlannedShape& shape : body.shapes)
    {
        shapes += shape.kind == PlannedShape::Kind::Circle
                      ? Print(" circle %.2f", Number(shape.radius))
                      : Print(" polygon of %zu", shape.points.size());
    }
    return Print(
        "body %zu:%s, reach %.2f m, %g kg%s, at (%.3f, %.3f) angle %.2f, speed (%.2f, %.2f) "
        "spin %.2f, friction %.2f, restitution %.1f, damping %.1f %.1f\n",
        index, shapes.c_str(), Number(body.reach), Number(body.mass), body.bullet ? " bullet" : "",
        Number(body.position.x), Number(body.position.y), Number(body.angle),
        Number(body.velocity.x), Number(body.velocity.y), Number(body.spin), Number(body.friction),
        Number(body.restitution), Number(body.linearDamping), Number(body.angularDamping));
}

std::string DescribeJoint(const PlannedJoint& joint, std::size_t index)
{
    std::string text =
        Print("joint %zu: %s of bodies %d and %d, at (%.3f, %.3f) and (%.3f, %.3f)", index,
              NameOf(joint.type), joint.bodyA, joint.bodyB, Number(joint.anchorA.x),
              Number(joint.anchorA.y), Number(joint.anchorB.x), Number(joint.anchorB.y));
    if (joint.limits)
    {
        text += Print(", limits %.2f to %.2f", Number(joint.lower), Number(joint.upper));
    }
    if (joint.motor)
    {
        text += Print(", motor %.2f", Number(joint.speed));
    }
    text +=
        Print(", at most %.3g N %.3g Nm, %.2f Hz damping %.1f, ratio %.2f", Number(joint.force),
              Number(joint.torque), Number(joint.hz), Number(joint.damping), Number(joint.ratio));
    if (joint.geared[0] >= 0)
    {
        text += Print(", of joints %d and %d", joint.geared[0], joint.geared[1]);
    }
    return text + (joint.collide ? ", bodies collide\n" : "\n");
}

b2FixtureDef Surface(const b2Shape& shape, float32 friction, float32 restitution)
{
    b2FixtureDef def;
    def.shape = &shape;
    def.friction = friction;
    def.restitution = restitution;
    return def;
}

} // namespace

std::string Describe(const WorldPlan& plan)
{
    constexpr const char* kWalls[] = {"thick walls", "walls of edges", "a chain as wall"};
    std::string text = Print(
        "world %d: %d sub-steps, iterations %d/%d, steps of %.4f and %.4f s, gravity (%.2f, %.2f), "
        "%s "
        "around %.2f x %.2f m of friction %.2f and restitution %.1f%s, %zu bodies, %zu joints\n",
        plan.number, plan.subSteps, plan.velocityIterations, plan.positionIterations,
        Number(plan.steps[0]), Number(plan.steps[1]), Number(plan.gravity.x),
        Number(plan.gravity.y), kWalls[int(plan.walls)], Number(2.0f * plan.half.x),
        Number(2.0f * plan.half.y), Number(plan.wallFriction), Number(plan.wallRestitution),
        plan.sleeps ? ", may sleep" : "", plan.bodies.size(), plan.joints.size());
    for (std::size_t i = 0; i < plan.bodies.size(); ++i)
    {
        text += DescribeBody(plan.bodies[i], i);
    }
    for (std::size_t i = 0; i < plan.joints.size(); ++i)
    {
        text += DescribeJoint(plan.joints[i], i);
    }
    return text;
}

RandomWorld::RandomWorld(const WorldPlan& plan) : m_plan(plan), m_world(plan.gravity)
{
    m_world.SetSubStepCount(plan.subSteps);
    m_world.SetAllowSleeping(plan.sleeps);
    BuildWalls();
    for (const PlannedBody& body : plan.bodies)
    {
        BuildBody(body);
    }
    for (const PlannedJoint& joint : plan.joints)
    {
        BuildJoint(joint);
    }
}

void RandomWorld::BuildWalls()
{
    b2BodyDef def;
    m_container = m_world.CreateBody(&def);
    const b2Vec2 h = m_plan.half;
    const b2Vec2 corners[4] = {b2Vec2(-h.x, -h.y), b2Vec2(h.x, -h.y), h, b2Vec2(-h.x, h.y)};
    const auto add = [this](const b2Shape& shape) {
        const b2FixtureDef wall = Surface(shape, m_plan.wallFriction, m_plan.wallRestitution);
        m_container->CreateFixture(&wall);
    };
    if (m_plan.walls == WorldPlan::Walls::Chain)
    {
        b2ChainShape chain;
        chain.CreateLoop(corners, 4);
        return add(chain);
    }
    for (int i = 0; i < 4; ++i)
    {
        const b2Vec2 middle = 0.5f * (corners[i] + corners[(i + 1) % 4]);
        const bool upright = i % 2 == 1;
        if (m_plan.walls == WorldPlan::Walls::Edges)
        {
            b2EdgeShape edge;
            edge.Set(corners[i], corners[(i + 1) % 4]);
            add(edge);
            continue;
        }
        const float32 t = 0.5f * kWallThickness;
        const b2Vec2 size = upright ? b2Vec2(t, h.y + 2.0f * t) : b2Vec2(h.x + 2.0f * t, t);
        const b2Vec2 outward =
            upright ? b2Vec2(middle.x / h.x, 0.0f) : b2Vec2(0.0f, middle.y / h.y);
        b2PolygonShape box;
        box.SetAsBox(size.x, size.y, middle + t * outward, 0.0f);
        add(box);
    }
}

void RandomWorld::BuildBody(const PlannedBody& body)
{
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = body.position;
    def.angle = body.angle;
    def.linearVelocity = body.velocity;
    def.angularVelocity = body.spin;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.bullet = body.bullet;
    b2Body* made = m_world.CreateBody(&def);
    for (const PlannedShape& planned : body.shapes)
    {
        b2CircleShape circle;
        b2PolygonShape polygon;
        const bool round = planned.kind == PlannedShape::Kind::Circle;
        if (round)
        {
            circle.m_p = planned.points[0];
            circle.m_radius = planned.radius;
        }
        else
        {
            polygon.Set(planned.points.data(), int32(planned.points.size()));
        }
        const b2Shape& shape = round ? static_cast<const b2Shape&>(circle) : polygon;
        b2FixtureDef fixture = Surface(shape, body.friction, body.restitution);
        fixture.density = 1.0f;
        made->CreateFixture(&fixture);
    }
    const float32 density = body.mass / made->GetMass();
    for (b2Fixture* fixture = made->GetFixtureList(); fixture; fixture = fixture->GetNext())
    {
        fixture->SetDensity(density);
    }
    made->ResetMassData();
    made->SetLinearVelocity(body.velocity); // of the centre, wherever it is
    m_bodies.push_back(made);
}

void RandomWorld::MoveTargets()
{
    const int due = int(std::floor(m_time / kTargetTime));
    for (; m_targets < due; ++m_targets)
    {
        for (std::size_t i = 0; i < m_joints.size(); ++i)
        {
            const std::vector<b2Vec2>& targets = m_plan.joints[i].targets;
            if (std::size_t(m_targets) < targets.size())
            {
                static_cast<b2MouseJoint*>(m_joints[i])->SetTarget(targets[std::size_t(m_targets)]);
            }
        }
    }
}

void RandomWorld::Step()
{
    const float32 step = StepLength();
    m_world.Step(step, m_plan.velocityIterations, m_plan.positionIterations);
    m_time += step;
    ++m_count;
}

} // namespace stability
