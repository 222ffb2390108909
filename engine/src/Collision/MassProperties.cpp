// SPDX-License-Identifier: MIT
#include "MassProperties.h"

#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>

namespace box2d
{
namespace
{
MassProperties OfCircle(const b2CircleShape& circle, double density)
{
    constexpr double pi = 3.14159265358979324;
    const double r2 = static_cast<double>(circle.m_radius) * circle.m_radius;
    MassProperties result;
    result.mass = density * pi * r2;
    result.centerX = circle.m_p.x;
    result.centerY = circle.m_p.y;
    result.centralInertia = 0.5 * result.mass * r2;
    return result;
}

// Sums over the triangle fan from vertex 0, so that no number is larger than the polygon. For a
// triangle with sides a and b from there and D = a x b:
//   area      = D / 2
//   centroid  = (a + b) / 3
//   inertia   = D (a.a + a.b + b.b) / 12     about vertex 0, for density 1
MassProperties OfPolygon(const b2PolygonShape& polygon, double density)
{
    MassProperties result;
    if (polygon.m_count < 3)
    {
        return result;
    }
    const double originX = polygon.m_vertices[0].x;
    const double originY = polygon.m_vertices[0].y;
    double area = 0.0;
    double momentX = 0.0;
    double momentY = 0.0;
    double inertia = 0.0;
    for (int32 i = 1; i + 1 < polygon.m_count; ++i)
    {
        const double ax = polygon.m_vertices[i].x - originX;
        const double ay = polygon.m_vertices[i].y - originY;
        const double bx = polygon.m_vertices[i + 1].x - originX;
        const double by = polygon.m_vertices[i + 1].y - originY;
        const double D = ax * by - ay * bx;
        area += 0.5 * D;
        momentX += D * (ax + bx) / 6.0;
        momentY += D * (ay + by) / 6.0;
        inertia += D * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by) / 12.0;
    }
    const double cx = area > 0.0 ? momentX / area : 0.0;
    const double cy = area > 0.0 ? momentY / area : 0.0;
    result.mass = density * area;
    result.centerX = originX + cx;
    result.centerY = originY + cy;
    result.centralInertia = density * (inertia - area * (cx * cx + cy * cy));
    return result;
}
} // namespace

MassProperties ComputeMassProperties(const b2Shape& shape, float32 density)
{
    switch (shape.GetType())
    {
    case b2Shape::e_circle:
        return OfCircle(static_cast<const b2CircleShape&>(shape), density);
    case b2Shape::e_polygon:
        return OfPolygon(static_cast<const b2PolygonShape&>(shape), density);
    case b2Shape::e_edge: {
        const b2EdgeShape& edge = static_cast<const b2EdgeShape&>(shape);
        const b2Vec2 middle = 0.5f * (edge.m_vertex1 + edge.m_vertex2);
        MassProperties result;
        result.centerX = middle.x;
        result.centerY = middle.y;
        return result;
    }
    default:
        return {};
    }
}

b2MassData ToMassData(const MassProperties& p)
{
    b2MassData data;
    data.mass = static_cast<float32>(p.mass);
    data.center.Set(static_cast<float32>(p.centerX), static_cast<float32>(p.centerY));
    data.I = static_cast<float32>(p.centralInertia +
                                  p.mass * (p.centerX * p.centerX + p.centerY * p.centerY));
    return data;
}
} // namespace box2d
