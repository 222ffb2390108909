// SPDX-License-Identifier: MIT
#include "IslandMotion.h"

#include "../Joints/JointKinds.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Body.h>

#include <algorithm>
#include <cmath>

namespace box2d
{

namespace
{

/// True if something immovable holds the body.
bool IsHeld(const b2Body& body)
{
    for (const b2ContactEdge* edge = body.GetContactList(); edge; edge = edge->next)
    {
        if (edge->contact->IsTouching() && edge->other->GetType() != b2_dynamicBody)
        {
            return true;
        }
    }
    for (const b2JointEdge* edge = body.GetJointList(); edge; edge = edge->next)
    {
        if (edge->other->GetType() != b2_dynamicBody || HoldsToWorld(*edge->joint))
        {
            return true;
        }
    }
    return false;
}

/// Returns the velocity factor that leaves the energy `left`.
float32 ShareOf(double energy, double left)
{
    return energy > 0.0 ? float32(std::sqrt(std::max(left, 0.0) / energy)) : 0.0f;
}

} // namespace

template <class Function>
void IslandMotion::ForEach(Function&& function) const
{
    for (const b2Body* body = &m_first; body; body = Data(*body).islandNext)
    {
        if (Data(*body).awakeIndex != -1)
        {
            function(*body, Data(*body), m_bodies[Data(*body).SolverIndex()]);
        }
    }
}

b2Vec2 IslandMotion::PlaceOf(const BodyData& data) const
{
    return CenterOffset(Data(m_first), data) + m_bodies[data.SolverIndex()].d;
}

IslandMotion::IslandMotion(const b2Body& first, SolverBody* bodies)
    : m_first(first), m_bodies(bodies), m_centre(0.0f, 0.0f), m_velocity(0.0f, 0.0f)
{
    bool held = false;
    ForEach([&](const b2Body& body, const BodyData& data, const SolverBody& s) {
        held = held || IsHeld(body);
        m_mass += double(data.mass);
        m_all += KineticEnergy(s, double(data.mass), double(data.inertia));
    });
    if (!held && m_mass > 0.0)
    {
        FindRigidMotion();
    }
}

void IslandMotion::FindRigidMotion()
{
    ForEach([&](const b2Body&, const BodyData& data, const SolverBody& s) {
        const auto share = float32(double(data.mass) / m_mass);
        m_centre += share * PlaceOf(data);
        m_velocity += share * s.v;
    });
    double inertia = 0.0;
    double momentum = 0.0;
    ForEach([&](const b2Body&, const BodyData& data, const SolverBody& s) {
        const b2Vec2 arm = PlaceOf(data) - m_centre;
        inertia += double(data.inertia) + double(data.mass) * double(arm.LengthSquared());
        momentum += double(data.inertia) * double(s.w) +
                    double(data.mass) * double(b2Cross(arm, s.v - m_velocity));
    });
    SolverBody whole;
    whole.v = m_velocity;
    whole.w = m_spin = inertia > 0.0 ? float32(momentum / inertia) : 0.0f;
    m_rigid = std::min(KineticEnergy(whole, m_mass, inertia), m_all);
}

void IslandMotion::Lose(double energy)
{
    const double within = m_all - m_rigid;
    const float32 inner = ShareOf(within, within - energy);
    const float32 outer = energy > within ? ShareOf(m_rigid, m_all - energy) : 1.0f;
    ForEach([&](const b2Body&, const BodyData& data, SolverBody& s) {
        const b2Vec2 v = m_velocity + b2Cross(m_spin, PlaceOf(data) - m_centre);
        s.v = outer * v + inner * (s.v - v);
        s.w = outer * m_spin + inner * (s.w - m_spin);
    });
}

} // namespace box2d
