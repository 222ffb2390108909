// SPDX-License-Identifier: MIT
#pragma once

#include "BroadPhaseState.h"
#include "References.h"

#include "../State/World.h"
#include "../World/Bodies.h"
#include "../World/Fixtures.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>

/// Bodies with their fixtures and shapes.
namespace box2d
{

template <class Archive>
void Visit(Archive& archive, b2CircleShape& shape)
{
    static_assert(kHasSize<b2CircleShape, 24>, "Say here what becomes of the new member.");
    archive(shape.m_radius, shape.m_p);
}

template <class Archive>
void Visit(Archive& archive, b2EdgeShape& shape)
{
    static_assert(kHasSize<b2EdgeShape, 56>, "Say here what becomes of the new member.");
    archive(shape.m_radius, shape.m_vertex1, shape.m_vertex2, shape.m_vertex0, shape.m_vertex3,
            shape.m_hasVertex0, shape.m_hasVertex3, shape.m_oneSided);
}

template <class Archive>
void Visit(Archive& archive, b2PolygonShape& shape)
{
    static_assert(kHasSize<b2PolygonShape, 288>, "Say here what becomes of the new member.");
    archive(shape.m_radius, shape.m_centroid);
    archive.Within(shape.m_count, 0, b2_polygonCapacity);
    for (int32 i = 0; i < shape.m_count; ++i)
    {
        archive(shape.m_vertices[i], shape.m_normals[i]);
    }
}

template <class Archive>
void Visit(Archive& archive, b2ChainShape& shape)
{
    static_assert(kHasSize<b2ChainShape, 48>, "Say here what becomes of the new member.");
    archive(shape.m_radius, shape.m_prevVertex, shape.m_nextVertex, shape.m_hasPrevVertex,
            shape.m_hasNextVertex, shape.m_oneSided);
    archive.Count(shape.m_count, sizeof(b2Vec2));
    if constexpr (Archive::kReads)
    {
        if (shape.m_count > 0)
        {
            void* memory = b2Alloc(shape.m_count * int32(sizeof(b2Vec2)));
            shape.m_vertices = new (memory) b2Vec2[std::size_t(shape.m_count)];
        }
    }
    for (int32 i = 0; i < shape.m_count; ++i)
    {
        archive(shape.m_vertices[i]);
    }
}

/// All members except the shape; each child has a tree node while the body is active.
template <class Archive>
void VisitFixture(Archive& archive, World& world, b2Fixture& fixture)
{
    static_assert(kHasSize<b2Fixture, 72>, "Say here what becomes of the new member.");
    archive(FixtureAccess::Density(fixture), FixtureAccess::Friction(fixture),
            FixtureAccess::Restitution(fixture), FixtureAccess::Filter(fixture),
            FixtureAccess::IsSensor(fixture));
    void* userData = fixture.GetUserData();
    VisitUserData(archive, userData);
    fixture.SetUserData(userData);
    int32& count = FixtureAccess::ProxyCount(fixture);
    archive(count);
    archive.Require(count == 0 || count == fixture.GetShape()->GetChildCount());
    count = archive.IsSound() ? count : 0;
    for (int32 child = 0; child < count; ++child)
    {
        auto& [box, owner, childIndex, proxyId] = FixtureAccess::Proxies(fixture)[child];
        archive(box, proxyId);
        if constexpr (Archive::kReads)
        {
            owner = &fixture;
            childIndex = child;
            archive.Require(
                SnapshotAccess::Connect(world.proxies, FixtureAccess::Proxies(fixture)[child]));
        }
    }
}

template <class Shape, class Archive>
void VisitFixtureOf(Archive& archive, World& world, b2Body& body, b2Fixture* fixture)
{
    if constexpr (Archive::kReads)
    {
        Shape shape;
        archive(shape);
        VisitFixture(archive, world, AddFixture(world, body, shape));
    }
    else
    {
        archive(static_cast<Shape&>(*fixture->GetShape()));
        VisitFixture(archive, world, *fixture);
    }
}

/// The fixture is null for reading.
template <class Archive>
void VisitFixture(Archive& archive, World& world, b2Body& body, b2Fixture* fixture)
{
    b2Shape::Type type = fixture ? fixture->GetType() : b2Shape::e_circle;
    archive.Within(type, b2Shape::e_circle, b2Shape::e_chain);
    switch (type)
    {
    case b2Shape::e_circle:
        return VisitFixtureOf<b2CircleShape>(archive, world, body, fixture);
    case b2Shape::e_edge:
        return VisitFixtureOf<b2EdgeShape>(archive, world, body, fixture);
    case b2Shape::e_polygon:
        return VisitFixtureOf<b2PolygonShape>(archive, world, body, fixture);
    default:
        return VisitFixtureOf<b2ChainShape>(archive, world, body, fixture);
    }
}

/// The body's own data. The lists that it is in are saved as lists.
template <class Archive>
void Visit(Archive& archive, BodyData& body)
{
    auto& [pose, rotation, localCenter, invMass, invInertia, maxExtent, awakeIndex, flags, mobility,
           linearVelocity, angularVelocity, force, torque, gravityScale, linearDamping,
           angularDamping, sleepTime, previous, sweepStart, sweepVersion, minExtent, room,
           colorMask, island, jointLevel, energyDebt, energyScale, userMovedAt, placedAt,
           islandPrev, islandNext, transform, worldCenter, mass, inertia, fixtureList, fixtureCount,
           jointList, contactList, prev, next, world, userData, number, place] = body;
    archive(number, flags);
    archive.Within(mobility, Mobility::Static, Mobility::Dynamic);
    archive(pose, rotation, localCenter, invMass, invInertia, maxExtent);
    archive(linearVelocity, angularVelocity, force, torque);
    archive(gravityScale, linearDamping, angularDamping, sleepTime);
    archive(previous, sweepStart, sweepVersion, minExtent, room);
    archive(colorMask, energyDebt, energyScale, userMovedAt, placedAt);
    archive(transform, worldCenter, mass, inertia);
    VisitUserData(archive, userData);
}

/// Oldest first, because new ones are inserted at the front.
template <class Archive>
void VisitFixtures(Archive& archive, World& world, b2Body& body)
{
    constexpr std::size_t minBytes = 32;
    Array<b2Fixture*> fixtures;
    for (b2Fixture* f = body.GetFixtureList(); f; f = f->GetNext())
    {
        fixtures.push_back(f);
    }
    auto count = int32(fixtures.size());
    archive.Count(count, minBytes);
    fixtures.resize(std::size_t(count));
    for (auto f = fixtures.rbegin(); f != fixtures.rend() && archive.IsSound(); ++f)
    {
        VisitFixture(archive, world, body, *f);
    }
}

template <class Archive>
void VisitBodies(Archive& archive, World& world)
{
    constexpr std::size_t minBytes = sizeof(BodyData) / 4;
    Array<b2Body*>& bodies = archive.lists.bodies;
    auto count = int32(bodies.size());
    archive.Count(count, minBytes);
    bodies.resize(std::size_t(count));
    int32 number = -1;
    for (int32 i = 0; i < count && archive.IsSound(); ++i)
    {
        if constexpr (Archive::kReads)
        {
            bodies[std::size_t(i)] = &AddBody(world);
        }
        b2Body& body = *bodies[std::size_t(i)];
        archive(Data(body));
        archive.Require(Data(body).number > number);
        number = Data(body).number;
        VisitFixtures(archive, world, body);
    }
    if constexpr (Archive::kReads)
    {
        archive.Require(number < world.bodyNumber &&
                        SnapshotAccess::AreAllConnected(world.proxies));
        bodies.resize(archive.IsSound() ? bodies.size() : 0);
    }
}

} // namespace box2d
