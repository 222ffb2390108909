// SPDX-License-Identifier: MIT
#include "RandomWorlds.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace stability
{

namespace
{

/// SplitMix64 (Steele, Lea, Flood, 2014), and nothing of the standard library's distributions,
/// which give other numbers elsewhere.
class Dice
{
public:
    explicit Dice(std::uint64_t seed) : m_state(seed) {}

    int Integer(int low, int high) { return low + int(Bits() % std::uint64_t(high - low + 1)); }
    float32 Real(float32 low, float32 high)
    {
        return low + (high - low) * float32(Bits() >> 40) / 16777216.0f;
    }
    bool Chance(float32 share) { return Real(0.0f, 1.0f) < share; }
    b2Vec2 Direction()
    {
        for (;;)
        {
            b2Vec2 v;
            v.x = Real(-1.0f, 1.0f); // one after the other: arguments have no order
            v.y = Real(-1.0f, 1.0f);
            if (v.LengthSquared() < 1.0f && v.Normalize() > 0.1f)
            {
                return v;
            }
        }
    }
    template <class T, std::size_t N>
    T OneOf(const T (&values)[N])
    {
        return values[Integer(0, int(N) - 1)];
    }

private:
    std::uint64_t Bits()
    {
        m_state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    std::uint64_t m_state;
};

constexpr int kSubSteps[] = {1, 2, 4, 8, 16};
constexpr float32 kMasses[] = {1.0f,  2.0f,   5.0f,   10.0f,  20.0f,
                               50.0f, 100.0f, 200.0f, 500.0f, 1000.0f};
constexpr int kMaxTries = 500; ///< to find two bodies for a joint
/// Initial distance of bodies: two skins and more.
constexpr float32 kClearance = 0.05f; // [m]

PlannedShape MakePolygon(const std::vector<b2Vec2>& points)
{
    PlannedShape shape;
    shape.kind = PlannedShape::Kind::Polygon;
    shape.points = points;
    return shape;
}

PlannedShape MakeBox(float32 hx, float32 hy, const b2Vec2& center = b2Vec2(0.0f, 0.0f))
{
    return MakePolygon({center + b2Vec2(-hx, -hy), center + b2Vec2(hx, -hy),
                        center + b2Vec2(hx, hy), center + b2Vec2(-hx, hy)});
}

PlannedShape MakeCircle(float32 radius, const b2Vec2& center = b2Vec2(0.0f, 0.0f))
{
    PlannedShape shape;
    shape.radius = radius;
    shape.points = {center};
    return shape;
}

class Planner
{
public:
    Planner(int number, int crowd) : m_dice(std::uint64_t(number) * 7919u + 20140401u)
    {
        m_plan.number = number;
        m_plan.crowd = crowd;
        m_plan.subSteps = kSubSteps[number % 5];
    }

    WorldPlan Plan()
    {
        PlanSetting();
        m_plan.half = b2Sqrt(float32(m_plan.crowd)) * m_plan.half;
        const int bodies = m_plan.crowd * m_dice.Integer(5, 60);
        for (int i = 0; i < bodies; ++i)
        {
            AddBody();
        }
        const int joints =
            int(m_dice.OneOf({0.0f, 0.3f, 0.6f, 0.9f}) * float32(m_plan.bodies.size()));
        m_group.resize(m_plan.bodies.size() + 1);
        std::iota(m_group.begin(), m_group.end(), 0);
        for (int i = 0; i < kMaxTries * m_plan.crowd && int(m_plan.joints.size()) < joints; ++i)
        {
            AddJoint();
        }
        return std::move(m_plan);
    }

private:
    void PlanSetting();
    PlannedShape RandomPolygon(float32 size);
    void GiveShapes(PlannedBody& body);
    void AddBody();
    void AddJoint();
    int Neighbour(int body);
    void Join(PlannedJoint& joint);
    void GiveMotor(PlannedJoint& joint);
    void GiveSpring(PlannedJoint& joint);
    void AddGear(const PlannedJoint& like);
    void AddMouse(PlannedJoint& joint);
    bool Fits(const PlannedBody& body) const;
    bool Connect(int bodyA, int bodyB);

    Dice m_dice;
    WorldPlan m_plan;
    std::vector<int> m_group; // of bodies that hang together; the container comes first
    float32 m_fastest = 0.0f; // [m/s]
};

void Planner::PlanSetting()
{
    constexpr std::pair<int, int> kIterations[] = {{8, 3}, {8, 3}, {4, 2}, {20, 10}};
    std::tie(m_plan.velocityIterations, m_plan.positionIterations) = m_dice.OneOf(kIterations);
    constexpr std::pair<float32, float32> kRates[] = {
        {60.0f, 60.0f}, {60.0f, 60.0f}, {60.0f, 60.0f},   {60.0f, 60.0f},
        {60.0f, 60.0f}, {30.0f, 30.0f}, {120.0f, 120.0f}, {30.0f, 120.0f}};
    const auto rates = m_dice.OneOf(kRates);
    m_plan.steps[0] = 1.0f / rates.first;
    m_plan.steps[1] = 1.0f / rates.second;
    m_plan.duration = 4.0f;
    const float32 g = m_dice.OneOf({0.0f, 2.0f, 10.0f, 10.0f, 10.0f, 20.0f});
    m_plan.gravity = g * (m_dice.Chance(0.7f) ? b2Vec2(0.0f, -1.0f) : m_dice.Direction());
    m_plan.sleeps = m_dice.Chance(0.5f);
    m_plan.walls =
        m_dice.OneOf({WorldPlan::Walls::Thick, WorldPlan::Walls::Edges, WorldPlan::Walls::Chain});
    m_plan.half.x = m_dice.Real(6.0f, 18.0f);
    m_plan.half.y = m_dice.Real(6.0f, 18.0f);
    m_plan.wallFriction = m_dice.Real(0.0f, 1.0f);
    m_plan.wallRestitution = m_dice.OneOf({0.0f, 0.0f, 0.5f, 1.0f});
    m_fastest = m_dice.OneOf({0.0f, 5.0f, 20.0f, 100.0f, 100.0f});
}

PlannedShape Planner::RandomPolygon(float32 size)
{
    std::vector<b2Vec2> points;
    do
    {
        points.resize(std::size_t(m_dice.Integer(3, b2_maxPolygonVertices)));
        for (b2Vec2& p : points)
        {
            p.x = m_dice.Real(-size, size);
            p.y = m_dice.Real(-size, size);
        }
    } while (b2PolygonShape::WhyNotConvex(points.data(), int32(points.size())) != nullptr);
    b2PolygonShape hull; // what the engine makes of them, for some are inside
    hull.Set(points.data(), int32(points.size()));
    points.assign(hull.m_vertices, hull.m_vertices + hull.m_count);
    return MakePolygon(points);
}

void Planner::GiveShapes(PlannedBody& body)
{
    const float32 size = m_dice.Real(0.15f, 0.8f);
    switch (m_dice.Integer(0, 5))
    {
    case 0:
        body.shapes = {MakeCircle(size)};
        break;
    case 1:
        body.shapes = {MakeBox(size, m_dice.Real(0.5f, 1.0f) * size)};
        break;
    case 2: // a thin rod
        body.shapes = {MakeBox(m_dice.Real(0.5f, 1.2f), m_dice.Real(0.02f, 0.05f))};
        break;
    case 3: // a dumbbell
        body.shapes = {MakeBox(size, 0.1f * size), MakeCircle(0.4f * size, b2Vec2(-size, 0.0f)),
                       MakeCircle(0.3f * size, b2Vec2(size, 0.0f))};
        break;
    case 4: // an L
        body.shapes = {MakeBox(size, 0.2f * size),
                       MakeBox(0.2f * size, 0.6f * size, b2Vec2(size, 0.4f * size))};
        break;
    default:
        body.shapes = {RandomPolygon(size)};
        break;
    }
    for (const PlannedShape& shape : body.shapes)
    {
        for (const b2Vec2& p : shape.points)
        {
            body.reach = b2Max(body.reach, p.Length() + shape.radius);
        }
    }
}

bool Planner::Fits(const PlannedBody& body) const
{
    return std::all_of(m_plan.bodies.begin(), m_plan.bodies.end(), [&](const PlannedBody& other) {
        return b2Distance(body.position, other.position) > body.reach + other.reach + kClearance;
    });
}

void Planner::AddBody()
{
    PlannedBody body;
    GiveShapes(body);
    body.mass = m_dice.OneOf(kMasses) * 0.1f;
    body.angle = m_dice.Real(-b2_pi, b2_pi);
    body.velocity = m_fastest * m_dice.Real(0.0f, 1.0f) * m_dice.Direction();
    body.spin = m_dice.Real(-0.3f, 0.3f) * m_fastest;
    body.friction = m_dice.Real(0.0f, 1.0f);
    body.restitution = m_dice.OneOf({0.0f, 0.0f, 0.0f, 0.3f, 0.8f, 1.0f});
    body.linearDamping = m_dice.Chance(0.1f) ? 0.5f : 0.0f;
    body.angularDamping = m_dice.Chance(0.1f) ? 0.5f : 0.0f;
    body.bullet = m_dice.Chance(0.15f);
    for (int attempt = 0; attempt < 50; ++attempt)
    {
        const b2Vec2 room = m_plan.half - (body.reach + kClearance) * b2Vec2(1.0f, 1.0f);
        body.position.x = m_dice.Real(-room.x, room.x);
        body.position.y = m_dice.Real(-room.y, room.y);
        if (Fits(body))
        {
            m_plan.bodies.push_back(body);
            return;
        }
    }
}

/// The nearest of a few, so that joints are seldom long.
int Planner::Neighbour(int body)
{
    const b2Vec2 place = m_plan.bodies[std::size_t(body)].position;
    int best = -1;
    float32 nearest = b2_maxFloat;
    for (int i = 0; i < int(m_plan.bodies.size()); ++i)
    {
        const float32 distance = b2Distance(place, m_plan.bodies[std::size_t(i)].position);
        if (i != body && m_dice.Chance(0.5f) && distance < nearest)
        {
            best = i;
            nearest = distance;
        }
    }
    return best;
}

/// Unless they hang together already: joints that hold the same twice contradict each other.
bool Planner::Connect(int bodyA, int bodyB)
{
    const int a = m_group[std::size_t(bodyA + 1)];
    const int b = m_group[std::size_t(bodyB + 1)];
    if (a == b)
    {
        return false;
    }
    std::replace(m_group.begin(), m_group.end(), b, a);
    return true;
}

void Planner::AddJoint()
{
    constexpr b2JointType kTypes[] = {
        e_revoluteJoint, e_revoluteJoint, e_prismaticJoint, e_distanceJoint, e_distanceJoint,
        e_pulleyJoint,   e_mouseJoint,    e_gearJoint,      e_wheelJoint,    e_weldJoint,
        e_frictionJoint, e_ropeJoint,     e_motorJoint};
    PlannedJoint joint;
    joint.type = m_dice.OneOf(kTypes);
    joint.bodyB = m_dice.Integer(0, int(m_plan.bodies.size()) - 1);
    const bool held = joint.type == e_mouseJoint || m_dice.Chance(0.3f);
    joint.bodyA = held ? -1 : Neighbour(joint.bodyB);
    joint.collide = m_dice.Chance(0.3f);
    if (joint.type == e_gearJoint)
    {
        AddGear(joint);
        return;
    }
    if (!Connect(joint.bodyA, joint.bodyB))
    {
        return;
    }
    if (joint.type == e_mouseJoint)
    {
        AddMouse(joint);
    }
    else
    {
        Join(joint);
        m_plan.joints.push_back(joint);
    }
}

/// Anchors, limits, motors and springs; each kind reads those that it has.
void Planner::Join(PlannedJoint& joint)
{
    const PlannedBody& b = m_plan.bodies[std::size_t(joint.bodyB)];
    const b2Vec2 placeA = joint.bodyA >= 0
                              ? m_plan.bodies[std::size_t(joint.bodyA)].position
                              : b.position + m_dice.Real(0.0f, 2.0f) * m_dice.Direction();
    joint.anchorB = b.position + m_dice.OneOf({0.0f, 0.5f}) * b.reach * m_dice.Direction();
    joint.anchorA = placeA + m_dice.OneOf({0.0f, 0.3f}) * m_dice.Direction();
    const bool point =
        joint.type != e_distanceJoint && joint.type != e_ropeJoint && joint.type != e_pulleyJoint;
    if (point)
    {
        joint.anchorA = joint.anchorB =
            m_dice.Chance(0.5f) ? joint.anchorB : 0.5f * (placeA + b.position);
    }
    else if (b2Distance(joint.anchorA, joint.anchorB) < 0.3f)
    {
        joint.anchorA = joint.anchorB + 0.5f * m_dice.Direction();
    }
    joint.axis = m_dice.Direction();
    joint.limits = m_dice.Chance(0.5f);
    joint.lower = m_dice.Real(-1.5f, 0.0f);
    joint.upper = m_dice.Real(0.0f, 1.5f);
    joint.ratio = m_dice.Real(0.5f, 2.0f);
    GiveMotor(joint);
    GiveSpring(joint);
}

/// Adds a motor strong enough to reach a speed of 1 in 0.002 to 0.1 s.
void Planner::GiveMotor(PlannedJoint& joint)
{
    const PlannedBody& b = m_plan.bodies[std::size_t(joint.bodyB)];
    const float32 strength = m_dice.OneOf({10.0f, 50.0f, 500.0f});
    joint.motor = m_dice.Chance(0.4f);
    joint.speed = m_dice.Real(-10.0f, 10.0f);
    joint.force = strength * b.mass;
    joint.torque = 0.3f * strength * b.mass * b.reach * b.reach;
}

void Planner::GiveSpring(PlannedJoint& joint)
{
    const bool always = joint.type == e_wheelJoint || joint.type == e_mouseJoint;
    joint.hz = always || m_dice.Chance(0.5f) ? m_dice.Real(0.5f, 8.0f) : 0.0f;
    joint.damping = m_dice.OneOf({0.0f, 0.1f, 0.7f, 1.0f});
}

/// Two joints, each with its own body B, and the gear between them.
void Planner::AddGear(const PlannedJoint& like)
{
    PlannedJoint gear = like;
    gear.ratio = m_dice.Real(0.5f, 2.0f) * m_dice.OneOf({-1.0f, 1.0f});
    const int bodies[2] = {like.bodyB, Neighbour(like.bodyB)};
    if (bodies[1] < 0 || !Connect(-1, bodies[0]) || !Connect(-1, bodies[1]))
    {
        return;
    }
    for (int i = 0; i < 2; ++i)
    {
        PlannedJoint joint = like;
        joint.bodyA = -1;
        joint.bodyB = bodies[i];
        joint.type = m_dice.OneOf({e_revoluteJoint, e_prismaticJoint});
        Join(joint);
        gear.geared[i] = int(m_plan.joints.size());
        m_plan.joints.push_back(joint);
    }
    m_plan.joints.push_back(gear);
}

void Planner::AddMouse(PlannedJoint& joint)
{
    Join(joint);
    joint.anchorB = m_plan.bodies[std::size_t(joint.bodyB)].position +
                    0.5f * m_plan.bodies[std::size_t(joint.bodyB)].reach * m_dice.Direction();
    for (int i = 0; i < 3; ++i)
    {
        b2Vec2 target;
        target.x = m_dice.Real(-0.8f, 0.8f) * m_plan.half.x;
        target.y = m_dice.Real(-0.8f, 0.8f) * m_plan.half.y;
        joint.targets.push_back(target);
    }
    m_plan.joints.push_back(joint);
}

} // namespace

WorldPlan PlanWorld(int number, int crowd)
{
    return Planner(number, crowd).Plan();
}

void WorldPlan::RemoveBody(int index)
{
    for (int i = int(joints.size()) - 1; i >= 0; --i)
    {
        // One removal may take several.
        if (i < int(joints.size()) &&
            (joints[std::size_t(i)].bodyA == index || joints[std::size_t(i)].bodyB == index))
        {
            RemoveJoint(i);
        }
    }
    for (PlannedJoint& joint : joints)
    {
        joint.bodyA -= joint.bodyA > index;
        joint.bodyB -= joint.bodyB > index;
    }
    bodies.erase(bodies.begin() + index);
}

void WorldPlan::RemoveJoint(int index)
{
    joints.erase(joints.begin() + index);
    for (int i = int(joints.size()) - 1; i >= index; --i)
    {
        int(&geared)[2] = joints[std::size_t(i)].geared;
        if (geared[0] == index || geared[1] == index)
        {
            RemoveJoint(i);
            continue;
        }
        geared[0] -= geared[0] > index;
        geared[1] -= geared[1] > index;
    }
}

} // namespace stability
