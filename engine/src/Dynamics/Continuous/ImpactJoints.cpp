// SPDX-License-Identifier: MIT
#include "ImpactJoints.h"

#include "../Contacts/Boxes.h"
#include "../Energy/EnergyGuard.h"
#include "../Joints/JointEnergy.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../State/World.h"
#include "../SubSteps/SubStepMemory.h"
#include "ImpactMemory.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

bool Leans(const BodyData& body)
{
    for (const b2ContactEdge* edge = body.contactList; edge != nullptr; edge = edge->next)
    {
        const ContactData& c = Data(*edge->contact);
        if ((c.flags & kContactObstacle) != 0 && c.IsTouching() && c.IsEnabled() && !c.IsSensor())
        {
            return true;
        }
    }
    return false;
}

} // namespace

/// Resets the paths: poses are final. Bodies that woke or fell asleep changed the order of the
/// joints; systems are built from the sorted list.
SolverContext ImpactJoints::ClearPaths() const
{
    m_world.graph.SortJoints();
    m_world.solver->bodies.assign(m_world.awakeBodies.size() + 1, SolverBody());
    SolverContext context;
    context.bodies = m_world.solver->bodies.data();
    return context;
}

void ImpactJoints::NoteStarts()
{
    if (m_noted || m_world.settings.subStepCount == 1 || m_world.graph.Joints().empty())
    {
        return;
    }
    m_noted = true;
    m_world.impacts->fates.clear();
    for (const b2Body* awake : m_world.awakeBodies)
    {
        m_world.impacts->fates.push_back(ImpactFate{&Data(*awake), false});
    }
    m_world.subSteps->joints.NoteOpen(m_world.graph, m_world.awakeVersion, ClearPaths());
}

void ImpactJoints::NoteStopped(const BodyData& body)
{
    if (m_noted && IsMoved(body))
    {
        Array<ImpactFate>& fates = m_world.impacts->fates;
        fates.resize(std::max(fates.size(), m_world.awakeBodies.size()), ImpactFate{});
        fates[std::size_t(body.awakeIndex)] = ImpactFate{&body, true};
        m_any = true;
    }
}

bool ImpactJoints::Close()
{
    if (!m_any)
    {
        return false;
    }
    const Array<ImpactFate>& fates = m_world.impacts->fates;
    const auto fate = [&](const BodyData& body) {
        const auto index = std::size_t(body.awakeIndex);
        const bool isKnown = index < fates.size() && fates[index].body == &body;
        return isKnown && fates[index].isStopped ? AfterImpact::Stopped
               : Leans(body)                     ? AfterImpact::Leans
                                                 : AfterImpact::Free;
    };
    const SolverContext context = ClearPaths();
    JointSystem& joints = m_world.subSteps->joints;
    joints.CloseAfterImpacts(m_world.graph, context, fate, [&](int32 part) {
        const float32 share = ShareLeft(part, context);
        if (share < 0.0f)
        {
            return; // it stays open, and closes slowly
        }
        joints.ForBodies(part, [&](const BodyData& known) {
            Take(*m_world.awakeBodies[std::size_t(known.awakeIndex)],
                 context.bodies[known.SolverIndex()], share);
        });
    });
    return true;
}

/// Returns the energy that springs of a component store through its displacement [J].
double ImpactJoints::WoundUp(int32 part, const SolverContext& context) const
{
    double stored = 0.0;
    m_world.subSteps->joints.ForJoints(part, [&](const b2Joint& joint) {
        if (HasSpring(joint))
        {
            stored += StoredBetween(SpringOf(joint, nullptr), SpringOf(joint, context.bodies));
        }
    });
    return stored;
}

/// Returns the factor of a component's velocities that pays for lifting it. Negative if springs
/// would store more than it has.
float32 ImpactJoints::ShareLeft(int32 part, const SolverContext& context) const
{
    const double stored = WoundUp(part, context);
    double kinetic = 0.0;
    double lift = stored;
    m_world.subSteps->joints.ForBodies(part, [&](const BodyData& body) {
        const b2Vec2 a = body.gravityScale * m_world.settings.gravity + body.invMass * body.force;
        SolverBody s;
        s.v = body.linearVelocity;
        s.w = body.angularVelocity;
        kinetic += KineticEnergy(s, double(body.mass), double(body.inertia));
        lift -= double(body.mass) * double(b2Dot(a, context.bodies[body.SolverIndex()].d));
    });
    if (!(lift > 0.0))
    {
        return 1.0f;
    }
    if (kinetic > lift)
    {
        return float32(std::sqrt((kinetic - lift) / kinetic));
    }
    return stored > 0.0 ? -1.0f : 0.0f;
}

void ImpactJoints::Take(b2Body& body, const SolverBody& drawn, float32 share)
{
    if (!IsFinite(drawn))
    {
        return;
    }
    BodyData& data = Data(body);
    EnergyGuard& guard = *m_world.energyGuard;
    const EnergyGuard::Path before{data.pose, data.linearVelocity, data.angularVelocity};
    data.pose.x += double(drawn.d.x);
    data.pose.y += double(drawn.d.y);
    data.pose.angle += double(drawn.angle);
    data.linearVelocity *= share;
    data.angularVelocity *= share;
    SynchronizePose(data);
    UpdateProxies(m_world.proxies, data, true);
    if (guard.HasAccounts())
    {
        guard.NoteImpact(data, before);
    }
}

} // namespace box2d
