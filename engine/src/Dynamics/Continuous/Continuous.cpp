// SPDX-License-Identifier: MIT
#include "Continuous.h"

#include "../Contacts/Boxes.h"
#include "../Contacts/Contacts.h"
#include "../Contacts/Narrowphase.h"
#include "../Contacts/Sweeps.h"
#include "../Energy/EnergyGuard.h"
#include "../Islands/Sleep.h"
#include "../Joints/JointKinds.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "../SubSteps/SubStepMemory.h"
#include "Containment.h"
#include "Impact.h"
#include "ImpactJoints.h"
#include "ImpactMemory.h"

#include "../../Collision/ImpactTarget.h"
#include "../../Collision/SearchCounts.h"

#include <Box2D/Collision/b2TimeOfImpact.h>
#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <algorithm>
#include <mutex>

/// Continuous collision: impacts that the discrete step missed are found in the order of their
/// times (Catto, "Continuous Collision", GDC 2013). The two bodies are moved back to the impact,
/// solved with the contacts they touch, and advanced for the rest of the step. An event changes
/// only the paths of its own bodies, so only their contacts are tested again.
namespace box2d
{

namespace
{

/// Contacts per part of a parallel loop. It affects the time only. It may be larger than that of
/// the update of contacts, because most contacts are skipped here without a search.
constexpr int32 kContactGrain = 64;

bool IsLater(const ImpactEvent& a, const ImpactEvent& b)
{
    return a.time != b.time ? a.time > b.time : a.order > b.order;
}

/// True for bodies that stop continuous collision: static and kinematic ones, or any if a bullet is
/// involved.
bool IsObstacle(const BodyData& body)
{
    return !body.IsDynamic() || (body.flags & kBodyBullet) != 0;
}

/// Returns the displacement since then of a body's point, at `arm` from its current centre [m].
b2Vec2 MoveOf(const BodyData& body, const Pose& since, const b2Vec2& arm)
{
    const b2Vec2 path(float32(body.pose.x - since.x), float32(body.pose.y - since.y));
    return path + b2Cross(float32(body.pose.angle - since.angle), arm);
}

/// [m], negative for an overlap.
float32 Deepest(const b2WorldManifold& manifold, int32 points)
{
    return *std::min_element(manifold.separations, manifold.separations + points);
}

class ContinuousCollision
{
public:
    ContinuousCollision(World& world, float32 timeStep, int32 velocityIterations)
        : m_world(world), m_memory(*world.impacts), m_timeStep(timeStep),
          m_impact(world, timeStep, velocityIterations), m_joints(world), m_containment(world),
          m_events(m_memory.events), m_bodies(m_impact.Bodies()), m_before(m_memory.before),
          m_contacts(m_impact.Contacts())
    {
        m_events.clear();
    }

    void Run();
    /// Adds the counts of the searches to the public numbers.
    void PublishCounts() const
    {
        if (m_counts.toiCalls > 0)
        {
            m_counts.Publish();
        }
    }

private:
    void LookAt(b2Body& body);
    void FindImpactTimes();
    float32 TimeOfImpact(const ContactData& c, SearchCounts& counts) const;
    void AddEvent(b2Contact& contact, float32 time);
    bool IsCandidate(const ContactData& c) const;
    bool IsValid(const ImpactEvent& event) const;
    bool Resolve(const ImpactEvent& event);
    void AddNeighbours(b2Body& body, float32 time);
    void AddJointed(float32 time);
    bool Bounces(const ContactData& c) const;
    bool Falls(const JointedBounce& jointed) const;
    void MoveBack(b2Body& body, bool falls, float32 time);
    bool Sinks(const ContactData& c) const;
    static bool GoesDeeper(const ContactData& c, const b2Sweep& sweepA, const b2Sweep& sweepB);
    static bool IsNear(const BodyData& body, const BodyData& other, bool known, float32 time);
    void Advance(BodyData& body, float32 time);
    bool HasNewPath(std::size_t index) const;
    bool HasOtherPose(std::size_t index) const;
    ImpactBackup Save(b2Body& body) const;
    void Restore(const ImpactBackup& backup, float32 time);

    World& m_world;
    ImpactMemory& m_memory;
    float32 m_timeStep;
    Impact m_impact; // the current event
    ImpactJoints m_joints;
    Containment m_containment;
    Array<ImpactEvent>& m_events; // a heap, earliest first
    int32 m_order = 0;
    Array<b2Body*>& m_bodies;      // of the current event
    Array<ImpactBackup>& m_before; // backup of these bodies
    Array<b2Contact*>& m_contacts; // of the current event
    SearchCounts m_counts;
    std::mutex m_countsMutex; // held while threads add their counts
};

void ContinuousCollision::Run()
{
    const Array<b2Contact*>& contacts = m_world.awakeContacts;
    FindImpactTimes();
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        AddEvent(*contacts[i], m_memory.times[i]);
    }
    m_world.stepComplete = true;
    if (!m_events.empty())
    {
        m_containment.NoteStarts();
        m_joints.NoteStarts();
    }
    bool any = false;
    while (!m_events.empty())
    {
        std::pop_heap(m_events.begin(), m_events.end(), IsLater);
        const ImpactEvent event = m_events.back();
        m_events.pop_back();
        if (!IsValid(event) || !Resolve(event))
        {
            continue;
        }
        any = true;
        if (m_world.settings.subStepping)
        {
            m_world.stepComplete = false;
            m_world.energyGuard->ChargeImpacts();
            return;
        }
    }
    // Both may move other shapes of a body through walls that it had no contact with. Closing
    // joints may move bodies through a wall, and containment may open joints. Once each, because
    // one may undo the other without end.
    const bool held = m_containment.Hold(m_joints);
    if (m_joints.Close() || held)
    {
        FindNewContacts(m_world);
        (void)m_containment.Hold(m_joints);
    }
    if (m_world.proxies.HasMoved())
    {
        FindNewContacts(m_world); // where that has put bodies, as after all that moves them
    }
    if (any)
    {
        m_world.energyGuard->ChargeImpacts();
    }
}

void ContinuousCollision::FindImpactTimes()
{
    const Array<b2Contact*>& contacts = m_world.awakeContacts;
    m_memory.times.resize(contacts.size());
    ParallelFor(m_world.threads.get(), int32(contacts.size()), kContactGrain,
                [&](int32 begin, int32 end) {
                    SearchCounts counts;
                    for (auto i = std::size_t(begin); i < std::size_t(end); ++i)
                    {
                        // Contacts are not read either if none of the bodies is an obstacle.
                        if (m_world.awakeObstacles[i] == 0 && !m_world.hasBullets)
                        {
                            m_memory.times[i] = 1.0f;
                            continue;
                        }
                        ContactData& c = Data(*contacts[i]);
                        if (m_world.stepComplete && c.toiCount != 0)
                        {
                            c.toiCount = 0;
                        }
                        m_memory.times[i] = IsCandidate(c) ? TimeOfImpact(c, counts) : 1.0f;
                    }
                    if (counts.toiCalls > 0)
                    {
                        const std::lock_guard<std::mutex> lock(m_countsMutex);
                        m_counts.Add(counts);
                    }
                });
}

void ContinuousCollision::LookAt(b2Body& body)
{
    for (b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        const ContactData& c = Data(*edge->contact);
        if (IsCandidate(c))
        {
            AddEvent(*edge->contact, TimeOfImpact(c, m_counts));
        }
    }
}

bool ContinuousCollision::IsCandidate(const ContactData& c) const
{
    // Bodies are not read if the contact alone decides.
    if (((c.flags & kContactObstacle) == 0 && !m_world.hasBullets) || c.IsSensor() ||
        !c.IsEnabled() || c.toiCount >= b2_maxSubSteps)
    {
        return false;
    }
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    if (!IsObstacle(a) && !IsObstacle(b))
    {
        return false;
    }
    // Contacts that touched at the start of the step were solved there; only a fast body can pass
    // through.
    return !c.IsTouching() || IsFast(a) || IsFast(b) || Sinks(c);
}

/// True if a body that touched the ground has sunk to the separation of an impact within the step.
/// The iterations of one step do not support a hard impact from above; with sub-steps they do. Not
/// for two dynamic bodies: a bullet that stopped at each body it pushes would lose too much time.
bool ContinuousCollision::Sinks(const ContactData& c) const
{
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    if (m_world.settings.subStepCount > 1 || (a.IsDynamic() && b.IsDynamic()) ||
        PathLength(a) + PathLength(b) < kImpactTolerance)
    {
        return false;
    }
    const float32 start = b2Max(a.sweepStart, b.sweepStart);
    const Pose fromA = PoseAt(a, start);
    const Pose fromB = PoseAt(b, start);
    b2WorldManifold end;
    end.Initialize(&c.manifold, a.transform, c.radiusA, b.transform, c.radiusB);
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
        const b2Vec2 apart = MoveOf(b, fromB, end.points[i] - b.worldCenter) -
                             MoveOf(a, fromA, end.points[i] - a.worldCenter);
        if (end.separations[i] < -kImpactOverlap && b2Dot(apart, end.normal) < -kImpactTolerance)
        {
            return true;
        }
    }
    return false;
}

/// Returns the time of impact of a candidate as a fraction of the step; 1 without an impact.
float32 ContinuousCollision::TimeOfImpact(const ContactData& c, SearchCounts& counts) const
{
    const BodyData& a = Data(*c.bodyA);
    const BodyData& b = Data(*c.bodyB);
    const float32 start = b2Max(a.sweepStart, b.sweepStart);
    const Pose fromA = PoseAt(a, start);
    const Pose fromB = PoseAt(b, start);
    if (!CirclesMeet(a, fromA, b, fromB))
    {
        return 1.0f;
    }
    const b2Shape& shapeA = *c.FixtureA()->GetShape();
    const b2Shape& shapeB = *c.FixtureB()->GetShape();
    if (IsRoundAbout(a, shapeA) && IsRoundAbout(b, shapeB))
    {
        ++counts.toiCalls; // in closed form, without iterations
        const float32 t = CircleImpact(a, fromA, b, fromB, shapeA.m_radius + shapeB.m_radius);
        return b2Min(start + (1.0f - start) * t, 1.0f);
    }
    if (a.maxExtent > b.maxExtent ? StaysInFront(a, fromA, shapeA, c.ChildA(), b, fromB)
                                  : StaysInFront(b, fromB, shapeB, c.ChildB(), a, fromA))
    {
        return 1.0f;
    }
    b2TOIInput input;
    input.sweepA = SweepFrom(a, fromA, fromA);
    input.sweepB = SweepFrom(b, fromB, fromA);
    if (!b2TestOverlap(SweptBox(shapeA, c.ChildA(), input.sweepA, a.maxExtent),
                       SweptBox(shapeB, c.ChildB(), input.sweepB, b.maxExtent)))
    {
        return 1.0f;
    }
    input.proxyA.Set(&shapeA, c.ChildA());
    input.proxyB.Set(&shapeB, c.ChildB());
    input.tMax = 1.0f;
    const b2TOIOutput output = FindImpact(input, m_world.profiling, counts);
    // Shapes with thin skins rest nearer to each other than two that meet.
    const bool rests = output.state == b2TOIOutput::e_touching && output.t == 0.0f &&
                       c.IsTouching() && c.skins < 1.0f;
    if (output.state == b2TOIOutput::e_overlapped || rests)
    {
        return GoesDeeper(c, input.sweepA, input.sweepB) ? start : 1.0f;
    }
    return output.state == b2TOIOutput::e_touching ? b2Min(start + (1.0f - start) * output.t, 1.0f)
                                                   : 1.0f;
}

/// True if overlapping bodies go so much deeper on their paths that they could come out on the
/// other side. One case is a light body pressed by a heavy one, if iterations did not converge.
/// Another is a rotating body of which one end comes out while the other goes in. Bodies that
/// separate, or sink slowly, are left to the next step.
bool ContinuousCollision::GoesDeeper(const ContactData& c, const b2Sweep& sweepA,
                                     const b2Sweep& sweepB)
{
    if (!c.IsTouching())
    {
        return false;
    }
    b2Transform fromA, fromB, toA, toB;
    sweepA.GetTransform(&fromA, 0.0f);
    sweepB.GetTransform(&fromB, 0.0f);
    sweepA.GetTransform(&toA, 1.0f);
    sweepB.GetTransform(&toB, 1.0f);
    b2WorldManifold start;
    start.Initialize(&c.manifold, fromA, c.radiusA, fromB, c.radiusB);
    const float32 thinnest =
        b2Min(Data(*c.bodyA).IsDynamic() ? Data(*c.bodyA).minExtent : b2_maxFloat,
              Data(*c.bodyB).IsDynamic() ? Data(*c.bodyB).minExtent : b2_maxFloat);
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
        const b2Vec2 point = start.points[i];
        const b2Vec2 apart = b2Mul(toB, b2MulT(fromB, point)) - b2Mul(toA, b2MulT(fromA, point));
        if (b2Dot(apart, start.normal) < -kFastShare * thinnest)
        {
            return true;
        }
    }
    b2Manifold there;
    Collide(&there, *c.FixtureA()->GetShape(), c.ChildA(), *c.FixtureB()->GetShape(),
            b2MulT(toA, toB));
    if (there.pointCount == 0)
    {
        return false;
    }
    b2WorldManifold end;
    end.Initialize(&there, toA, c.radiusA, toB, c.radiusB);
    return b2Dot(start.normal, end.normal) < 0.0f ||
           Deepest(end, there.pointCount) <
               Deepest(start, c.manifold.pointCount) - kFastShare * thinnest;
}

void ContinuousCollision::AddEvent(b2Contact& contact, float32 time)
{
    if (time < 1.0f)
    {
        const ContactData& c = Data(contact);
        m_events.push_back(ImpactEvent{time, m_order++, &contact, Data(*c.bodyA).sweepVersion,
                                       Data(*c.bodyB).sweepVersion});
        std::push_heap(m_events.begin(), m_events.end(), IsLater);
    }
}

bool ContinuousCollision::IsValid(const ImpactEvent& event) const
{
    const ContactData& c = Data(*event.contact);
    return Data(*c.bodyA).sweepVersion == event.versionA &&
           Data(*c.bodyB).sweepVersion == event.versionB && c.toiCount < b2_maxSubSteps &&
           c.IsEnabled();
}

ImpactBackup ContinuousCollision::Save(b2Body& body) const
{
    const BodyData& data = Data(body);
    return ImpactBackup{&body,           data.pose,           data.previous,
                        data.sweepStart, data.linearVelocity, data.angularVelocity,
                        data.rotation,   data.transform,      data.worldCenter};
}

/// A kinematic body continues unchanged, so results about it stay valid, unless a listener changed
/// its velocity.
bool ContinuousCollision::HasNewPath(std::size_t index) const
{
    return Data(*m_bodies[index]).IsDynamic() || HasOtherPose(index);
}

/// True if the body's pose at the end of the step is not the one before the impact.
bool ContinuousCollision::HasOtherPose(std::size_t index) const
{
    const Pose& pose = Data(*m_bodies[index]).pose;
    const Pose& before = m_before[index].pose;
    return pose.x != before.x || pose.y != before.y || pose.angle != before.angle;
}

/// Takes back that Advance stopped the body at that time, if its path had not begun later. A
/// listener may have changed its velocity since.
void ContinuousCollision::Restore(const ImpactBackup& backup, float32 time)
{
    BodyData& data = Data(*backup.body);
    if (backup.sweepStart <= time)
    {
        data.linearVelocity += (1.0f - time) * m_timeStep * m_impact.AccelerationOf(data);
    }
    data.pose = backup.pose;
    data.previous = backup.previous;
    data.sweepStart = backup.sweepStart;
    data.rotation = backup.rotation;
    data.transform = backup.transform;
    data.worldCenter = backup.worldCenter;
}

/// Stops the body at its pose at that time.
void ContinuousCollision::Advance(BodyData& body, float32 time)
{
    if (!CanAdvance(body, time))
    {
        return;
    }
    body.pose = PoseAt(body, time);
    body.previous = body.pose;
    body.sweepStart = time;
    body.linearVelocity -= (1.0f - time) * m_timeStep * m_impact.AccelerationOf(body);
    SynchronizePose(body);
}

/// False if the shapes do not touch, or the contact was disabled.
bool ContinuousCollision::Resolve(const ImpactEvent& event)
{
    ContactData& c = Data(*event.contact);
    b2Body& bodyA = *c.bodyA;
    b2Body& bodyB = *c.bodyB;
    m_impact.Falling().clear();
    const ImpactBackup backupA = Save(bodyA);
    const ImpactBackup backupB = Save(bodyB);
    Advance(Data(bodyA), event.time);
    Advance(Data(bodyB), event.time);
    ++c.toiCount;
    UpdateContact(m_world, *event.contact);
    if (!c.IsEnabled() || !c.IsTouching())
    {
        c.flags &= ~std::uint32_t(kContactEnabled); // for the rest of the step
        LookAgain(m_world, c);
        Restore(backupA, event.time);
        Restore(backupB, event.time);
        return false;
    }
    Wake(m_world, bodyA);
    Wake(m_world, bodyB);

    m_bodies.assign({&bodyA, &bodyB});
    m_before.assign({backupA, backupB});
    m_contacts.assign(1, event.contact);
    AddNeighbours(bodyA, event.time);
    AddNeighbours(bodyB, event.time);
    AddJointed(event.time);
    m_impact.SolvePositions(bodyA, bodyB);
    m_impact.SolveVelocities(event.time);
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
    {
        BodyData& data = Data(*m_bodies[i]);
        if (HasNewPath(i))
        {
            ++data.sweepVersion;
            if (i < m_memory.firstJoined || HasOtherPose(i))
            {
                m_joints.NoteStopped(data);
            }
            m_containment.NoteTurn(data);
            UpdateProxies(m_world.proxies, data, true);
        }
    }
    FindNewContacts(m_world);
    for (std::size_t i = 0; i < m_bodies.size(); ++i)
    {
        if (HasNewPath(i))
        {
            LookAt(*m_bodies[i]);
        }
    }
    return true;
}

/// True if a body could touch another that is not known to be part of the event.
bool ContinuousCollision::IsNear(const BodyData& body, const BodyData& other, bool known,
                                 float32 time)
{
    const Pose pose = known || !CanAdvance(other, time) ? other.pose : PoseAt(other, time);
    const b2Vec2 offset(float32(pose.x - body.pose.x), float32(pose.y - body.pose.y));
    return IsWithin(offset, Reach(body, other));
}

// Adds the bodies touched at the time of the impact, except ordinary dynamic bodies. These are not
// swept, and would receive the impulse twice.
void ContinuousCollision::AddNeighbours(b2Body& body, float32 time)
{
    if (!Data(body).IsDynamic())
    {
        return;
    }
    for (b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        b2Contact* contact = edge->contact;
        ContactData& c = Data(*contact);
        b2Body& other = *edge->other;
        if (m_contacts.size() >= std::size_t(b2_maxTOIContacts) || c.IsSensor() ||
            !(IsObstacle(Data(body)) || IsObstacle(Data(other))) ||
            std::find(m_contacts.begin(), m_contacts.end(), contact) != m_contacts.end())
        {
            continue;
        }
        const bool known = std::find(m_bodies.begin(), m_bodies.end(), &other) != m_bodies.end();
        if (!c.IsTouching() && !IsNear(Data(body), Data(other), known, time))
        {
            c.flags |= kContactEnabled; // as for every tested contact
            continue;
        }
        const ImpactBackup backup = Save(other);
        if (!known)
        {
            Advance(Data(other), time);
        }
        UpdateContact(m_world, *contact);
        if (!c.IsEnabled() || !c.IsTouching())
        {
            if (!known)
            {
                Restore(backup, time);
            }
            continue;
        }
        m_contacts.push_back(contact);
        if (!known)
        {
            m_bodies.push_back(&other);
            m_before.push_back(backup);
        }
    }
}

/// True if a point of the contact approaches fast enough to bounce.
bool ContinuousCollision::Bounces(const ContactData& c) const
{
    b2WorldManifold manifold;
    manifold.Initialize(&c.manifold, Data(*c.bodyA).transform, c.radiusA, Data(*c.bodyB).transform,
                        c.radiusB);
    bool any = false;
    for (int32 i = 0; i < c.manifold.pointCount; ++i)
    {
        const b2Vec2 v = c.bodyB->GetLinearVelocityFromWorldPoint(manifold.points[i]) -
                         c.bodyA->GetLinearVelocityFromWorldPoint(manifold.points[i]);
        any = any || b2Dot(v, manifold.normal) < -m_world.settings.restitutionThreshold;
    }
    return any && c.restitution > 0.0f;
}

/// True if all that joints connect falls freely at the same acceleration.
bool ContinuousCollision::Falls(const JointedBounce& jointed) const
{
    const SubStepMemory& steps = *m_world.subSteps;
    const auto placeOf = [](const b2Body* body) { return std::size_t(Data(*body).awakeIndex); };
    const std::size_t first = placeOf(jointed.Bodies()[0]);
    const auto falls = [&](const b2Body* body) {
        const BodyData& data = Data(*body);
        const std::size_t place = placeOf(body);
        return data.IsDynamic() && place < steps.modes.size() &&
               (steps.modes[place] == BodyMode::OnJoints ||
                steps.modes[place] == BodyMode::InTree) &&
               data.linearDamping == 0.0f && data.angularDamping == 0.0f &&
               steps.kicks[place].acceleration == steps.kicks[first].acceleration;
    };
    return std::ranges::all_of(jointed.Bodies(), falls) &&
           std::ranges::none_of(jointed.Joints(),
                                [](b2Joint* joint) { return HoldsToWorld(*joint); });
}

/// With sub-steps joints pass on the impulses of an impact that bounces. Their bodies are moved
/// back to its time.
void ContinuousCollision::AddJointed(float32 time)
{
    m_memory.firstJoined = m_bodies.size();
    if (m_world.settings.subStepCount == 1 ||
        std::ranges::none_of(m_contacts, [this](b2Contact* c) { return Bounces(Data(*c)); }))
    {
        return;
    }
    JointedBounce& jointed = m_world.subSteps->jointedBounce;
    for (b2Contact* contact : m_contacts)
    {
        const ContactData& c = Data(*contact);
        if (c.restitution > 0.0f && jointed.Find(c))
        {
            const bool falls = Falls(jointed);
            for (b2Body* body : jointed.Bodies())
            {
                MoveBack(*body, falls, time);
            }
        }
    }
}

void ContinuousCollision::MoveBack(b2Body& body, bool falls, float32 time)
{
    BodyData& data = Data(body);
    if (std::find(m_bodies.begin(), m_bodies.end(), &body) == m_bodies.end())
    {
        m_before.push_back(Save(body));
        m_bodies.push_back(&body);
        Advance(data, time);
    }
    Array<const BodyData*>& falling = m_impact.Falling();
    if (falls && std::find(falling.begin(), falling.end(), &data) == falling.end())
    {
        falling.push_back(&data);
        if (data.sweepStart == time)
        {
            data.linearVelocity -= (1.0f - time) * m_timeStep * m_impact.AccelerationOf(data);
        }
    }
}

} // namespace

void SolveContinuous(World& world, float32 timeStep, int32 velocityIterations)
{
    if (world.awakeContacts.empty())
    {
        world.stepComplete = true;
        return;
    }
    ContinuousCollision continuous(world, timeStep, velocityIterations);
    continuous.Run();
    continuous.PublishCounts();
}

} // namespace box2d
