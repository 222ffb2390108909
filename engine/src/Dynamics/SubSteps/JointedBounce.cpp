// SPDX-License-Identifier: MIT
#include "JointedBounce.h"

#include "../Joints/JointKinds.h"
#include "../Solver/Bouncer.h"
#include "../State/Access.h"
#include "ContactItem.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>

namespace box2d
{

namespace
{

/// A bound of the cost, because each bounce factors the system of all its joints. Chains of 60
/// links with it take as long as without (docs/notes/sub-steps-impacts.md has the cost of
/// ragdolls).
constexpr std::size_t kMaxJoints = 64;
/// A bound of the cost, as in ContactSystem.
constexpr int32 kMaxUpdates = 16;
/// Speeds of 10 m/s are rounded by as much [m/s].
constexpr double kTolerance = 1e-6;

template <class Element>
bool Contains(const Array<Element>& array, const Element& element)
{
    return std::ranges::find(array, element) != array.end();
}

/// Rigid rows hold. A limit that is reached pushes back. All else has no time to act.
void Hold(JointRows& rows, BoundedSystem::Item& item, const SolverContext& context)
{
    item = BoundedSystem::Item();
    rows.disc = false;
    const float32 reached = b2_linearSlop * context.inverseStep;
    for (int32 i = 0; i < rows.rows; ++i)
    {
        JointRows::Law& law = rows.laws[i];
        law.softness = 0.0f;
        const bool rigid = i < rows.Rigid();
        item.minimum.at[i] = rigid || law.fastest <= reached ? -BoundedSystem::kUnbounded : 0.0;
        item.maximum.at[i] = rigid || law.slowest >= -reached ? BoundedSystem::kUnbounded : 0.0;
        item.active = uint8(item.active | int(rigid) << i);
    }
}

} // namespace

void JointedBounce::Follow(b2Body& body)
{
    if (Contains(m_bodies, &body))
    {
        return;
    }
    m_bodies.push_back(&body);
    for (b2JointEdge* edge = body.GetJointList(); edge && IsMoved(Data(body)); edge = edge->next)
    {
        b2Joint& joint = *edge->joint;
        if (JointAccess::SolverIndex(joint) != -1 && !Contains(m_joints, &joint))
        {
            m_joints.push_back(&joint);
        }
    }
}

bool JointedBounce::Find(const ContactData& contact)
{
    m_bodies.clear();
    m_joints.clear();
    for (b2Body* body : {contact.bodyA, contact.bodyB})
    {
        if (IsMoved(Data(*body)))
        {
            Follow(*body);
        }
    }
    for (std::size_t i = 0; i < m_joints.size() && m_joints.size() <= kMaxJoints; ++i)
    {
        ForParts(*m_joints[i], [this](b2Joint& part) {
            Follow(*part.GetBodyA());
            Follow(*part.GetBodyB());
        });
    }
    const auto sleeps = [](const b2Body* body) { // if a listener has put it to sleep in this step
        return Data(*body).IsDynamic() && !IsMoved(Data(*body));
    };
    if (m_joints.empty() || m_joints.size() > kMaxJoints || std::ranges::any_of(m_bodies, sleeps))
    {
        return false;
    }
    std::ranges::sort(m_joints, {}, [](b2Joint* joint) { return JointAccess::Number(*joint); });
    Build(contact);
    return m_system.IsExact();
}

void JointedBounce::Build(const ContactData& contact)
{
    m_sides.clear();
    RowSides& sides = m_sides.emplace_back();
    sides.Add(Data(*contact.bodyA));
    sides.Add(Data(*contact.bodyB));
    for (b2Joint* joint : m_joints)
    {
        m_sides.push_back(SidesOf(*joint));
    }
    if (m_sides != m_built)
    {
        m_built = m_sides;
        m_system.Build(m_sides, kMaxUpdates, m_elimination);
    }
}

void JointedBounce::Fill(ContactBlock& block, const OverlapBlock& overlap, int32 lane,
                         const SolverContext& context)
{
    ContactItem(block, lane).FillRows(m_system.Rows(0), overlap, context);
    m_system.At(0) = BoundedSystem::Item();
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        JointRows& rows = m_system.Rows(i + 1);
        rows.Clear();
        JointAccess::FillRows(*m_joints[i], context, rows);
        Hold(rows, m_system.At(i + 1), context);
    }
    m_system.Begin(context);
}

/// Stops what opens joints: velocities of the end of the step do not match poses within it.
void JointedBounce::HoldJoints(const SolverContext& context)
{
    bool any = false;
    for (std::size_t i = 1; i < m_system.Count(); ++i)
    {
        const float32 error = BoundedSystem::ErrorOf(context, m_system.Rows(i), m_system.At(i));
        any = any || double(error) > kTolerance;
    }
    if (any)
    {
        m_system.Minimize(context, kTolerance);
    }
}

bool JointedBounce::Bounce(ContactBlock& block, const OverlapBlock& overlap, BlockTotals& totals,
                           int32 lane, float32 restitution, const SolverContext& context)
{
    Fill(block, overlap, lane, context);
    m_system.Mark(context);
    HoldJoints(context);
    BoundedSystem::Item& item = m_system.At(0);
    const Vector3 speed = SpeedOf(context, m_system.Rows(0));
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        if (speed.at[i] < 0.0)
        {
            item.speeds.at[i] = -double(restitution) * speed.at[i];
            item.maximum.at[i] = BoundedSystem::kUnbounded;
            item.active = uint8(item.active | 1 << i);
        }
    }
    m_system.Minimize(context, kTolerance);
    Rub(block, lane, context);
    const bool driven = restitution > 1.0f || block.tangentSpeed[lane] != 0.0f;
    if (m_system.HasBurst(context) || (!driven && m_system.HasGained(context)))
    {
        m_system.GoBack(context);
        return false;
    }
    const double load = item.impulse.at[0] + item.impulse.at[1];
    for (int32 i = 0; i < block.pointCount; ++i)
    {
        const double share = load > 0.0 ? item.impulse.at[i] / load : 0.0;
        totals.normal[i][lane] += float32(item.impulse.at[i]);
        totals.tangent[i][lane] += float32(share * item.impulse.at[2]);
    }
    return true;
}

/// Applies the friction of the normal impulses, which stay.
void JointedBounce::Rub(const ContactBlock& block, int32 lane, const SolverContext& context)
{
    BoundedSystem::Item& item = m_system.At(0);
    const double load = item.impulse.at[0] + item.impulse.at[1];
    const double limit = double(block.friction[lane]) * load;
    if (limit > 0.0)
    {
        item.minimum = item.maximum = item.impulse;
        item.speeds.at[2] = double(block.tangentSpeed[lane]);
        item.minimum.at[2] = -limit;
        item.maximum.at[2] = limit;
        item.active = 4;
        m_system.Minimize(context, kTolerance);
    }
}

} // namespace box2d
