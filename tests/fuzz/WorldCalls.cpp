// SPDX-License-Identifier: MIT
#include "WorldCalls.h"

#include "../engine/DynamicsInvariants.h"
#include "JointCalls.h"

namespace fuzz
{
namespace
{

constexpr std::size_t kMaxBodies = 30;
constexpr int32 kMaxJoints = 20;
constexpr int kMaxFixtures = 3; ///< of a body

bool IsWild(std::span<const std::uint8_t> bytes)
{
#if BOXREEL_ASSERTS
    (void)bytes;
    return false;
#else
    return !bytes.empty() && bytes[0] % 2 == 1;
#endif
}

int CountFixtures(b2Body* body)
{
    int count = 0;
    for (b2Fixture* fixture = body->GetFixtureList(); fixture; fixture = fixture->GetNext())
    {
        ++count;
    }
    return count;
}

} // namespace

WorldCalls::WorldCalls(std::span<const std::uint8_t> bytes)
    : m_choices(bytes.empty() ? bytes : bytes.subspan(1), IsWild(bytes)),
      m_world(b2Vec2(0.0f, -10.0f)), m_listeners(m_world, m_choices)
{
    b2BodyDef def;
    def.position.Set(0.0f, -1.0f);
    m_bodies.push_back(m_world.CreateBody(&def));
    b2PolygonShape ground;
    ground.SetAsBox(50.0f, 1.0f);
    m_bodies.back()->CreateFixture(&ground, 0.0f);
}

WorldCalls::~WorldCalls()
{
    m_world.SetDestructionListener(nullptr);
    m_world.SetContactListener(nullptr);
}

const char* WorldCalls::Call()
{
    using Caller = const char* (WorldCalls::*)();
    static constexpr Caller callers[] = {
        &WorldCalls::Step,
        &WorldCalls::CreateBody,
        &WorldCalls::DestroyBody,
        &WorldCalls::CreateFixture,
        &WorldCalls::DestroyFixture,
        &WorldCalls::ChangeFixture,
        &WorldCalls::CreateJointBetween,
        &WorldCalls::DestroyJoint,
        &WorldCalls::ChangeOneJoint,
        &WorldCalls::ChangeBody,
        &WorldCalls::Push,
        &WorldCalls::ChangeWorld,
        &WorldCalls::Listen,
        &WorldCalls::Ask,
        &WorldCalls::CreateBody,
        &WorldCalls::CreateJointBetween,
    };
    constexpr int count = int(sizeof callers / sizeof callers[0]);
    m_stepped = false;
    // Every third call or so is a step, for that is when things happen.
    const int which = m_choices.Number(0, count + 7);
    return (this->*callers[which < count ? which : 0])();
}

std::string WorldCalls::WhyBroken()
{
    for (const b2Body* body : m_bodies)
    {
        if (!body->GetPosition().IsValid() || !b2IsValid(body->GetAngle()) ||
            !body->GetLinearVelocity().IsValid() || !b2IsValid(body->GetAngularVelocity()))
        {
            return "A body is somewhere or moves at a speed that is not finite.";
        }
    }
    return dynamics::WhyBroken(m_world, m_stepped);
}

b2Body* WorldCalls::Body()
{
    return m_bodies[std::size_t(m_choices.Number(0, int(m_bodies.size()) - 1))];
}

b2Fixture* WorldCalls::Fixture()
{
    b2Fixture* fixture = Body()->GetFixtureList();
    for (int skip = m_choices.Number(0, 2); fixture && fixture->GetNext() && skip > 0; --skip)
    {
        fixture = fixture->GetNext();
    }
    return fixture;
}

b2Joint* WorldCalls::Joint()
{
    b2Joint* joint = m_world.GetJointList();
    for (int skip = m_choices.Number(0, 9); joint && joint->GetNext() && skip > 0; --skip)
    {
        joint = joint->GetNext();
    }
    return joint;
}

// A step that takes no time, or ends what sub-stepping began, does not wake along joints.
const char* WorldCalls::Step()
{
    const bool takesTime = !m_choices.Rarely(10);
    const float32 h = takesTime ? m_choices.Real(1.0f / 120.0f, 1.0f / 40.0f) : 0.0f;
    const int fewest = m_choices.Wild() ? -1 : 1;
    const int32 velocityIterations = m_choices.Number(fewest, 6);
    const int32 positionIterations = m_choices.Number(fewest, 3);
    m_world.Step(h, velocityIterations, positionIterations);
    // A wild step may count as none; what only holds after a real one is not asked then.
    const bool real = h > 1e-6f && h < 1.0f;
    m_stepped = real && !m_subStepped;
    m_subStepped = m_world.GetSubStepping() || (m_subStepped && !real);
    return "Step";
}

const char* WorldCalls::CreateBody()
{
    if (m_bodies.size() >= kMaxBodies)
    {
        return DestroyBody();
    }
    b2BodyDef def;
    def.type =
        m_choices.Rarely(4) ? static_cast<b2BodyType>(m_choices.Number(0, 1)) : b2_dynamicBody;
    def.position = m_choices.Place();
    def.angle = m_choices.Real(-3.0f, 3.0f);
    def.linearVelocity = m_choices.Vector(20.0f);
    def.linearDamping = m_choices.Flag() ? m_choices.Real(0.0f, 2.0f) : 0.0f;
    def.awake = !m_choices.Rarely(4);
    def.active = !m_choices.Rarely(6);
    def.allowSleep = !m_choices.Rarely(6);
    def.bullet = m_choices.Rarely(6);
    def.fixedRotation = m_choices.Rarely(10);
    b2Body* body = m_world.CreateBody(&def);
    m_bodies.push_back(body);
    AddFixture(body);
    return "CreateBody";
}

const char* WorldCalls::DestroyBody()
{
    if (m_bodies.size() > 1)
    {
        const int which = m_choices.Number(0, int(m_bodies.size()) - 1);
        m_world.DestroyBody(m_bodies[std::size_t(which)]);
        m_bodies.erase(m_bodies.begin() + which);
    }
    return "DestroyBody";
}

void WorldCalls::AddFixture(b2Body* body)
{
    b2CircleShape circle;
    circle.m_radius = m_choices.Real(0.1f, 0.6f);
    circle.m_p.Set(m_choices.Real(-0.3f, 0.3f), 0.0f);
    b2PolygonShape polygon;
    const float32 hx = m_choices.Real(0.05f, 0.6f);
    polygon.SetAsBox(hx, m_choices.Real(0.05f, 0.6f));
    if (m_choices.Rarely(4))
    {
        b2Vec2 points[5];
        for (b2Vec2& point : points)
        {
            point = m_choices.Vector(0.8f);
        }
        // Asked first, for asserts would end the program where the hull cannot be made.
        if (m_choices.Wild() || b2PolygonShape::WhyNotConvex(points, 5) == nullptr)
        {
            polygon.Set(points, 5);
        }
    }
    b2EdgeShape edge;
    edge.Set(b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.2f));
    const b2Vec2 corners[4] = {{-2.0f, 0.5f}, {-1.0f, 0.0f}, {1.0f, 0.0f}, {2.0f, 0.5f}};
    b2ChainShape chain;
    chain.CreateChain(corners, 4);
    const b2Shape* shapes[] = {&circle, &polygon, &edge, &chain};
    b2FixtureDef def;
    def.shape = shapes[m_choices.Rarely(3) ? m_choices.Number(2, 3) : m_choices.Number(0, 1)];
    def.density = m_choices.Real(0.0f, 2.0f);
    def.friction = m_choices.Real(0.0f, 1.0f);
    def.restitution = m_choices.Real(0.0f, 1.0f);
    def.isSensor = m_choices.Rarely(6);
    def.filter.groupIndex = int16(m_choices.Number(-1, 1));
    body->CreateFixture(&def);
}

const char* WorldCalls::CreateFixture()
{
    b2Body* body = Body();
    if (CountFixtures(body) < kMaxFixtures)
    {
        AddFixture(body);
    }
    return "CreateFixture";
}

const char* WorldCalls::DestroyFixture()
{
    if (b2Fixture* fixture = Fixture())
    {
        fixture->GetBody()->DestroyFixture(fixture);
    }
    return "DestroyFixture";
}

const char* WorldCalls::ChangeFixture()
{
    b2Fixture* fixture = Fixture();
    if (!fixture)
    {
        return "nothing";
    }
    b2Filter filter;
    switch (m_choices.Number(0, 4))
    {
    case 0:
        fixture->SetSensor(m_choices.Flag());
        return "SetSensor";
    case 1:
        filter.groupIndex = int16(m_choices.Number(-1, 1));
        filter.maskBits = uint16(m_choices.Number(0, 3));
        fixture->SetFilterData(filter);
        return "SetFilterData";
    case 2:
        fixture->Refilter();
        return "Refilter";
    case 3:
        fixture->SetDensity(m_choices.Real(0.0f, 3.0f));
        return "SetDensity";
    default:
        fixture->SetFriction(m_choices.Real(0.0f, 1.0f));
        fixture->SetRestitution(m_choices.Real(0.0f, 1.0f));
        return "SetFriction, SetRestitution";
    }
}

const char* WorldCalls::CreateJointBetween()
{
    b2Body* a = Body();
    b2Body* b = Body();
    const bool apart = a != b && b2Distance(a->GetPosition(), b->GetPosition()) > 0.02f;
    if ((!apart && !m_choices.Wild()) || m_world.GetJointCount() >= kMaxJoints)
    {
        return "nothing";
    }
    return CreateJoint(m_world, a, b, m_choices);
}

const char* WorldCalls::DestroyJoint()
{
    if (b2Joint* joint = Joint())
    {
        m_world.DestroyJoint(joint);
    }
    return "DestroyJoint";
}

const char* WorldCalls::ChangeOneJoint()
{
    b2Joint* joint = Joint();
    return joint ? ChangeJoint(joint, m_choices) : "nothing";
}

const char* WorldCalls::ChangeBody()
{
    b2Body* body = Body();
    b2MassData mass;
    switch (m_choices.Number(0, 8))
    {
    case 0:
        body->SetType(static_cast<b2BodyType>(m_choices.Number(0, 2)));
        return "SetType";
    case 1:
        body->SetActive(!m_choices.Rarely(3));
        return "SetActive";
    case 2:
        body->SetAwake(m_choices.Flag());
        return "SetAwake";
    case 3:
        body->SetTransform(m_choices.Place(), m_choices.Real(-3.0f, 3.0f));
        return "SetTransform";
    case 4:
        body->SetFixedRotation(m_choices.Flag());
        return "SetFixedRotation";
    case 5:
        body->SetSleepingAllowed(!m_choices.Rarely(3));
        return "SetSleepingAllowed";
    case 6:
        body->SetBullet(m_choices.Flag());
        body->SetGravityScale(m_choices.Real(-1.0f, 2.0f));
        return "SetBullet, SetGravityScale";
    case 7:
        mass.mass = m_choices.Real(0.0f, 5.0f);
        mass.center = b2Vec2(m_choices.Real(-0.2f, 0.2f), 0.0f);
        mass.I = mass.mass * (b2Dot(mass.center, mass.center) + m_choices.Real(0.01f, 1.0f));
        body->SetMassData(&mass);
        return "SetMassData";
    default:
        body->ResetMassData();
        return "ResetMassData";
    }
}

const char* WorldCalls::Push()
{
    b2Body* body = Body();
    const bool wake = m_choices.Flag();
    switch (m_choices.Number(0, 5))
    {
    case 0:
        body->ApplyForce(m_choices.Vector(50.0f), m_choices.Place(), wake);
        return "ApplyForce";
    case 1:
        body->ApplyLinearImpulse(m_choices.Vector(5.0f), m_choices.Place(), wake);
        return "ApplyLinearImpulse";
    case 2:
        body->SetLinearVelocity(m_choices.Vector(90.0f));
        return "SetLinearVelocity";
    case 3:
        body->ApplyTorque(m_choices.Real(-50.0f, 50.0f), wake);
        return "ApplyTorque";
    case 4:
        body->ApplyAngularImpulse(m_choices.Real(-5.0f, 5.0f), wake);
        return "ApplyAngularImpulse";
    default:
        body->SetAngularVelocity(m_choices.Real(-50.0f, 50.0f));
        return "SetAngularVelocity";
    }
}

const char* WorldCalls::ChangeWorld()
{
    switch (m_choices.Number(0, 10))
    {
    case 0:
        m_world.SetAllowSleeping(!m_choices.Rarely(3));
        return "SetAllowSleeping";
    case 1:
        m_world.SetSubStepping(m_choices.Rarely(3));
        return "SetSubStepping";
    case 2:
        m_world.SetWarmStarting(!m_choices.Rarely(3));
        return "SetWarmStarting";
    case 3:
        m_world.SetContinuousPhysics(!m_choices.Rarely(3));
        return "SetContinuousPhysics";
    case 4:
        m_world.SetAutoClearForces(!m_choices.Rarely(3));
        return "SetAutoClearForces";
    case 5:
        m_world.ClearForces();
        return "ClearForces";
    case 6:
        m_world.SetGravity(m_choices.Vector(20.0f));
        return "SetGravity";
    case 7:
        m_world.SetThreadCount(m_choices.Number(1, 3));
        return "SetThreadCount";
    case 8:
        m_world.SetSubStepCount(m_choices.Number(1, 6));
        return "SetSubStepCount";
    case 9:
        m_world.SetRestitutionThreshold(float32(m_choices.Number(0, 3)));
        return "SetRestitutionThreshold";
    default:
        m_world.ShiftOrigin(m_choices.Vector(1.0f));
        return "ShiftOrigin";
    }
}

const char* WorldCalls::Listen()
{
    switch (m_choices.Number(0, 2))
    {
    case 0:
        m_world.SetContactListener(m_choices.Flag() ? &m_listeners : nullptr);
        return "SetContactListener";
    case 1:
        m_world.SetContactFilter(m_choices.Flag() ? &m_listeners : nullptr);
        return "SetContactFilter";
    default:
        m_world.SetDestructionListener(m_choices.Flag() ? &m_listeners : nullptr);
        return "SetDestructionListener";
    }
}

const char* WorldCalls::Ask()
{
    b2AABB box;
    b2RayCastInput ray;
    b2RayCastOutput hit;
    switch (m_choices.Number(0, 2))
    {
    case 0:
        box.lowerBound = m_choices.Place();
        box.upperBound = box.lowerBound + b2Vec2(2.0f, 2.0f);
        m_world.QueryAABB(&m_listeners, box);
        return "QueryAABB";
    case 1:
        ray.p1 = m_choices.Place();
        m_world.RayCast(&m_listeners, ray.p1, m_choices.Place());
        return "RayCast";
    default:
        if (b2Fixture* fixture = Fixture())
        {
            ray.p1 = m_choices.Place();
            ray.p2 = m_choices.Place();
            ray.maxFraction = 1.0f;
            fixture->RayCast(&hit, ray, 0);
            fixture->TestPoint(m_choices.Place());
        }
        return "b2Fixture::RayCast";
    }
}

} // namespace fuzz
