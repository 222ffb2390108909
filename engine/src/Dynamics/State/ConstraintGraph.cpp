// SPDX-License-Identifier: MIT
#include "ConstraintGraph.h"

#include "Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <bit>

namespace box2d
{

namespace
{

/// Initial capacity of a colour, to avoid repeated growth. It affects allocations only: a list of
/// 16 takes two cache lines.
constexpr std::size_t kFirstRoom = 16;

constexpr uint32 kAllColors = (1u << ConstraintGraph::kOverflow) - 1;

} // namespace

// Between two moving bodies the first free colour, against a static one the last. Contacts with the
// ground are solved last, so that their error is smallest. Bodies that the solver does not move may
// be shared by any constraints of a colour.
int32 ConstraintGraph::Claim(BodyData& a, BodyData& b)
{
    const uint32 taken = (a.IsDynamic() ? a.colorMask : 0u) | (b.IsDynamic() ? b.colorMask : 0u);
    const uint32 open = ~taken & kAllColors;
    if (open == 0)
    {
        return kOverflow;
    }
    const int32 color =
        a.IsDynamic() && b.IsDynamic() ? std::countr_zero(open) : 31 - std::countl_zero(open);
    for (BodyData* body : {&a, &b})
    {
        if (body->IsDynamic())
        {
            body->colorMask |= 1u << color;
        }
    }
    return color;
}

void ConstraintGraph::Release(BodyData& a, BodyData& b, int32 color)
{
    if (color == kOverflow)
    {
        return;
    }
    for (BodyData* body : {&a, &b})
    {
        if (body->IsDynamic())
        {
            body->colorMask &= ~(1u << color);
        }
    }
}

void ConstraintGraph::Add(b2Contact& contact)
{
    ContactData& c = Data(contact);
    b2Assert(c.color == -1);
    c.color = std::int8_t(Claim(Data(*c.bodyA), Data(*c.bodyB)));
    m_contactsChanged[c.color] = true;
    m_usedColors |= 1u << c.color;
    Array<b2Contact*>& list = m_contacts[c.color];
    c.colorIndex = int32(list.size());
    if (list.capacity() == 0)
    {
        list.reserve(kFirstRoom);
    }
    list.push_back(&contact);
}

void ConstraintGraph::Remove(b2Contact& contact)
{
    ContactData& c = Data(contact);
    b2Assert(c.color != -1);
    Release(Data(*c.bodyA), Data(*c.bodyB), c.color);
    m_contactsChanged[c.color] = true;
    Array<b2Contact*>& list = m_contacts[c.color];
    list[std::size_t(c.colorIndex)] = list.back();
    Data(*list.back()).colorIndex = c.colorIndex;
    list.pop_back();
    if (list.empty())
    {
        m_usedColors &= ~(1u << c.color);
    }
    c.color = -1;
    c.colorIndex = -1;
}

ConstraintGraph::Change ConstraintGraph::ChangeOf(int32 color) const
{
    return m_contactsChanged[color]                                ? Change::Contacts
           : m_formsChanged[color].load(std::memory_order_relaxed) ? Change::Forms
                                                                   : Change::None;
}

void ConstraintGraph::Settle(int32 color)
{
    m_contactsChanged[color] = false;
    m_formsChanged[color].store(false, std::memory_order_relaxed);
}

void ConstraintGraph::NoteAllForms()
{
    for (std::atomic<bool>& changed : m_formsChanged)
    {
        changed.store(true, std::memory_order_relaxed);
    }
}

void ConstraintGraph::Add(b2Joint& joint)
{
    int32& index = JointAccess::SolverIndex(joint);
    b2Assert(index == -1);
    m_sorted = m_sorted && (m_joints.empty() ||
                            JointAccess::Number(*m_joints.back()) < JointAccess::Number(joint));
    index = int32(m_joints.size());
    m_joints.push_back(&joint);
    ++m_jointVersion;
}

void ConstraintGraph::Remove(b2Joint& joint)
{
    int32& index = JointAccess::SolverIndex(joint);
    b2Assert(index != -1);
    m_sorted = m_sorted && m_joints.back() == &joint;
    m_joints[std::size_t(index)] = m_joints.back();
    JointAccess::SolverIndex(*m_joints.back()) = index;
    m_joints.pop_back();
    index = -1;
    ++m_jointVersion;
}

void ConstraintGraph::SortJoints()
{
    if (m_sorted)
    {
        return;
    }
    std::sort(m_joints.begin(), m_joints.end(), [](b2Joint* a, b2Joint* b) {
        return JointAccess::Number(*a) < JointAccess::Number(*b);
    });
    for (std::size_t i = 0; i < m_joints.size(); ++i)
    {
        JointAccess::SolverIndex(*m_joints[i]) = int32(i);
    }
    m_sorted = true;
}

} // namespace box2d
