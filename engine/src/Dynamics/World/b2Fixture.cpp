// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2Fixture.h>

#include "../State/World.h"
#include "Fixtures.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Dynamics/b2Body.h>

bool b2Fixture::SetShape(const b2Shape& shape)
{
    box2d::World& world = *box2d::Data(*m_body).world;
    return B2_REQUIRE(
               !world.locked,
               "b2Fixture::SetShape must not be called from inside a callback of the world.") &&
           box2d::SetShape(world, *this, shape);
}

void b2Fixture::SetSensor(bool sensor)
{
    if (sensor != m_isSensor)
    {
        m_isSensor = sensor;
        box2d::UpdateSensor(*box2d::Data(*m_body).world, *this);
    }
}

void b2Fixture::SetFilterData(const b2Filter& filter)
{
    m_filter = filter;
    Refilter();
}

void b2Fixture::Refilter()
{
    box2d::Refilter(*box2d::Data(*m_body).world, *this);
}

bool b2Fixture::TestPoint(const b2Vec2& p) const
{
    return m_shape->TestPoint(m_body->GetTransform(), p);
}

bool b2Fixture::RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                        int32 childIndex) const
{
    return m_shape->RayCast(output, input, m_body->GetTransform(), childIndex);
}

void b2Fixture::SetDensity(float32 density)
{
    if (B2_REQUIRE(b2IsValid(density) && density >= 0.0f,
                   "A fixture's density must be finite and not negative."))
    {
        m_density = density;
    }
}

void b2Fixture::SetFriction(float32 friction)
{
    if (B2_REQUIRE(b2IsValid(friction) && friction >= 0.0f,
                   "A fixture's friction must be finite and not negative."))
    {
        m_friction = friction;
    }
}

void b2Fixture::SetRestitution(float32 restitution)
{
    if (B2_REQUIRE(b2IsValid(restitution) && restitution >= 0.0f,
                   "A fixture's restitution must be finite and not negative."))
    {
        m_restitution = restitution;
    }
}

const b2AABB& b2Fixture::GetAABB(int32 childIndex) const
{
    b2Assert(0 <= childIndex && childIndex < m_shape->GetChildCount());
    return m_proxies[childIndex].aabb;
}

namespace
{

void DumpPoint(const char* name, const b2Vec2& p)
{
    b2Log("    %s.Set(%.8ef, %.8ef);\n", name, double(p.x), double(p.y));
}

void DumpPoints(const b2Vec2* points, int32 count)
{
    b2Log("    b2Vec2 vs[%d];\n", count);
    for (int32 i = 0; i < count; ++i)
    {
        b2Log("    vs[%d].Set(%.8ef, %.8ef);\n", i, double(points[i].x), double(points[i].y));
    }
}

/// Writes only one-sided collision; two-sided is the default of 2.3.
void DumpSides(bool isOneSided)
{
    if (isOneSided)
    {
        b2Log("    shape.m_oneSided = bool(1);\n");
    }
}

void DumpEdge(const b2EdgeShape& edge)
{
    b2Log("    b2EdgeShape shape;\n");
    DumpPoint("shape.m_vertex0", edge.m_vertex0);
    DumpPoint("shape.m_vertex1", edge.m_vertex1);
    DumpPoint("shape.m_vertex2", edge.m_vertex2);
    DumpPoint("shape.m_vertex3", edge.m_vertex3);
    b2Log("    shape.m_hasVertex0 = bool(%d);\n", edge.m_hasVertex0);
    b2Log("    shape.m_hasVertex3 = bool(%d);\n", edge.m_hasVertex3);
    DumpSides(edge.m_oneSided);
}

void DumpShape(const b2Shape& shape)
{
    switch (shape.GetType())
    {
    case b2Shape::e_circle: {
        const auto& circle = static_cast<const b2CircleShape&>(shape);
        b2Log("    b2CircleShape shape;\n");
        b2Log("    shape.m_radius = %.8ef;\n", double(circle.m_radius));
        DumpPoint("shape.m_p", circle.m_p);
        break;
    }
    case b2Shape::e_edge:
        DumpEdge(static_cast<const b2EdgeShape&>(shape));
        break;
    case b2Shape::e_polygon: {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        b2Log("    b2PolygonShape shape;\n");
        DumpPoints(polygon.m_vertices, polygon.GetVertexCount());
        b2Log("    shape.Set(vs, %d);\n", polygon.GetVertexCount());
        break;
    }
    default: {
        const auto& chain = static_cast<const b2ChainShape&>(shape);
        b2Log("    b2ChainShape shape;\n");
        DumpPoints(chain.m_vertices, chain.m_count);
        b2Log("    shape.CreateChain(vs, %d);\n", chain.m_count);
        if (chain.m_hasPrevVertex)
        {
            b2Log("    shape.SetPrevVertex(b2Vec2(%.8ef, %.8ef));\n", double(chain.m_prevVertex.x),
                  double(chain.m_prevVertex.y));
        }
        if (chain.m_hasNextVertex)
        {
            b2Log("    shape.SetNextVertex(b2Vec2(%.8ef, %.8ef));\n", double(chain.m_nextVertex.x),
                  double(chain.m_nextVertex.y));
        }
        DumpSides(chain.m_oneSided);
        break;
    }
    }
}

} // namespace

void b2Fixture::Dump(int32 bodyIndex)
{
    b2Log("    b2FixtureDef fd;\n");
    b2Log("    fd.friction = %.8ef;\n", double(m_friction));
    b2Log("    fd.restitution = %.8ef;\n", double(m_restitution));
    b2Log("    fd.density = %.8ef;\n", double(m_density));
    b2Log("    fd.isSensor = bool(%d);\n", m_isSensor);
    b2Log("    fd.filter.categoryBits = uint16(%d);\n", m_filter.categoryBits);
    b2Log("    fd.filter.maskBits = uint16(%d);\n", m_filter.maskBits);
    b2Log("    fd.filter.groupIndex = int16(%d);\n", m_filter.groupIndex);
    DumpShape(*m_shape);
    b2Log("    fd.shape = &shape;\n");
    b2Log("    bodies[%d]->CreateFixture(&fd);\n", bodyIndex);
}
