// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Dynamics/Joints/b2Joint.h>
#include <Box2D/Dynamics/b2Fixture.h>

#include <cstddef>
#include <new>

/// Access of the engine to private members of fixtures and joints. Plain references, no logic.
namespace box2d
{

struct JointLane;
struct JointRows;

// The members of a class with a base cannot be named all at once. With pointers of 8 bytes, its
// size shows that a member has been added.
template <class Object, std::size_t size>
constexpr bool kHasSize = sizeof(void*) != 8 || sizeof(Object) == size;

struct FixtureAccess
{
    static b2Fixture* Construct(void* memory) { return new (memory) b2Fixture(); }
    static void Destruct(b2Fixture& f) { f.~b2Fixture(); }
    static float32& Density(b2Fixture& f) { return f.m_density; }
    static float32& Friction(b2Fixture& f) { return f.m_friction; }
    static float32& Restitution(b2Fixture& f) { return f.m_restitution; }
    static b2Filter& Filter(b2Fixture& f) { return f.m_filter; }
    static b2Fixture*& Next(b2Fixture& f) { return f.m_next; }
    static b2Body*& Body(b2Fixture& f) { return f.m_body; }
    static b2Shape*& Shape(b2Fixture& f) { return f.m_shape; }
    static b2FixtureProxy*& Proxies(b2Fixture& f) { return f.m_proxies; }
    static int32& ProxyCount(b2Fixture& f) { return f.m_proxyCount; }
    static bool& IsSensor(b2Fixture& f) { return f.m_isSensor; }
};

struct JointAccess
{
    struct Snapshot; ///< Snapshot/JointState.h
    template <class Joint>
    struct Kind; ///< what the engine asks of a kind of joint, see Joints/JointKind.h

    template <class Joint>
    static b2Joint* Construct(void* memory, const b2JointDef& def)
    {
        return new (memory) Joint(static_cast<const typename Kind<Joint>::Definition*>(&def));
    }
    static void Destruct(b2Joint& j) { j.~b2Joint(); }
    static void FillLane(b2Joint& j, const SolverContext& context, JointLane& lane)
    {
        j.FillLane(context, lane);
    }
    static void KeepImpulses(b2Joint& j, const JointLane& lane) { j.KeepImpulses(lane); }
    static void FillRows(b2Joint& j, const SolverContext& context, JointRows& rows)
    {
        j.FillRows(context, rows);
    }
    static void GetRowImpulses(const b2Joint& j, float32 (&impulse)[3])
    {
        j.GetRowImpulses(impulse);
    }
    static void SetRowImpulses(b2Joint& j, const float32 (&within)[3], const float32 (&beyond)[3])
    {
        j.SetRowImpulses(within, beyond);
    }
    static b2Joint*& Prev(b2Joint& j) { return j.m_prev; }
    static b2Joint*& Next(b2Joint& j) { return j.m_next; }
    static b2JointEdge& EdgeA(b2Joint& j) { return j.m_edgeA; }
    static b2JointEdge& EdgeB(b2Joint& j) { return j.m_edgeB; }
    static int32& Number(b2Joint& j) { return j.m_number; }
    static int32& SolverIndex(b2Joint& j) { return j.m_solverIndex; }
    static bool& Linked(b2Joint& j) { return j.m_linked; }
    static std::uint32_t ChangedAt(const b2Joint& j) { return j.m_changedAt; }
};

} // namespace box2d
