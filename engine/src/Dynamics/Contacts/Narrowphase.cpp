// SPDX-License-Identifier: MIT
#include "Narrowphase.h"

#include "../../Collision/Manifolds.h"

#include <Box2D/Collision/Shapes/b2ChainShape.h>

namespace box2d
{

namespace
{

// Edges and chains, then polygons, then circles.
int32 Rank(b2Shape::Type type)
{
    return IsThin(type) ? 0 : (type == b2Shape::e_polygon ? 1 : 2);
}

void CollideEdge(b2Manifold* manifold, const b2EdgeShape& edge, const b2Shape& b,
                 const b2Transform& bInA)
{
    if (b.GetType() == b2Shape::e_circle)
    {
        CollideEdgeAndCircle(manifold, edge, static_cast<const b2CircleShape&>(b), bInA);
    }
    else
    {
        CollideEdgeAndPolygon(manifold, edge, static_cast<const b2PolygonShape&>(b), bInA);
    }
}

} // namespace

bool CanCollide(b2Shape::Type a, b2Shape::Type b)
{
    return !(IsThin(a) && IsThin(b));
}

bool MustSwap(b2Shape::Type a, b2Shape::Type b)
{
    return Rank(b) < Rank(a);
}

float32 Collide(b2Manifold* manifold, const b2Shape& a, int32 childA, const b2Shape& b,
                const b2Transform& bInA)
{
    switch (a.GetType())
    {
    case b2Shape::e_circle:
        return CollideCircles(manifold, static_cast<const b2CircleShape&>(a),
                              static_cast<const b2CircleShape&>(b), bInA);
    case b2Shape::e_polygon:
        if (b.GetType() == b2Shape::e_circle)
        {
            return CollidePolygonAndCircle(manifold, static_cast<const b2PolygonShape&>(a),
                                           static_cast<const b2CircleShape&>(b), bInA);
        }
        return CollidePolygons(manifold, static_cast<const b2PolygonShape&>(a),
                               static_cast<const b2PolygonShape&>(b), bInA);
    case b2Shape::e_edge:
        CollideEdge(manifold, static_cast<const b2EdgeShape&>(a), b, bInA);
        return 0.0f;
    default: {
        b2EdgeShape edge;
        static_cast<const b2ChainShape&>(a).GetChildEdge(&edge, childA);
        CollideEdge(manifold, edge, b, bInA);
        return 0.0f;
    }
    }
}

} // namespace box2d
