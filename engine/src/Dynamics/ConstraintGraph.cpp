// SPDX-License-Identifier: MIT
#include "ConstraintGraph.h"

#include "Access.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

#include <bit>

namespace box2d
{

namespace
{

// A body that the solver never moves can be shared by any number of constraints of a colour.
bool Yields(const BodyData& body)
{
    return body.mobility == Mobility::Dynamic;
}

constexpr uint32 kAllColors = (1u << ConstraintGraph::kOverflow) - 1;

} // namespace

// Between two moving bodies the first colour that is free, against an immovable one the last: what
// rests on the ground is solved last, so that the ground has the final word.
int32 ConstraintGraph::Claim(BodyData& a, BodyData& b)
{
    const uint32 taken = (Yields(a) ? a.colorMask : 0u) | (Yields(b) ? b.colorMask : 0u);
    const uint32 open = ~taken & kAllColors;
    if (open == 0)
    {
        return kOverflow;
    }
    const int32 color =
        Yields(a) && Yields(b) ? std::countr_zero(open) : 31 - std::countl_zero(open);
    for (BodyData* body : {&a, &b})
    {
        if (Yields(*body))
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
        if (Yields(*body))
        {
            body->colorMask &= ~(1u << color);
        }
    }
}

void ConstraintGraph::Add(b2Contact& contact)
{
    ContactData& c = Data(contact);
    b2Assert(c.color == -1);
    c.color = Claim(Data(*c.bodyA), Data(*c.bodyB));
    Array<b2Contact*>& list = m_colors[c.color].contacts;
    c.colorIndex = int32(list.size());
    list.push_back(&contact);
}

void ConstraintGraph::Remove(b2Contact& contact)
{
    ContactData& c = Data(contact);
    b2Assert(c.color != -1);
    Release(Data(*c.bodyA), Data(*c.bodyB), c.color);
    Array<b2Contact*>& list = m_colors[c.color].contacts;
    list[std::size_t(c.colorIndex)] = list.back();
    Data(*list.back()).colorIndex = c.colorIndex;
    list.pop_back();
    c.color = -1;
    c.colorIndex = -1;
}

void ConstraintGraph::Add(b2Joint& joint)
{
    int32& color = JointAccess::Color(joint);
    b2Assert(color == -1);
    // A gear moves up to four bodies.
    color = joint.GetType() == e_gearJoint
                ? kOverflow
                : Claim(Data(*joint.GetBodyA()), Data(*joint.GetBodyB()));
    Array<b2Joint*>& list = m_colors[color].joints;
    JointAccess::ColorIndex(joint) = int32(list.size());
    list.push_back(&joint);
}

void ConstraintGraph::Remove(b2Joint& joint)
{
    int32& color = JointAccess::Color(joint);
    int32& index = JointAccess::ColorIndex(joint);
    b2Assert(color != -1);
    Release(Data(*joint.GetBodyA()), Data(*joint.GetBodyB()), color);
    Array<b2Joint*>& list = m_colors[color].joints;
    list[std::size_t(index)] = list.back();
    JointAccess::ColorIndex(*list.back()) = index;
    list.pop_back();
    color = -1;
    index = -1;
}

} // namespace box2d
