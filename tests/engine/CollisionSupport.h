// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/Shapes/b2ChainShape.h>
#include <Box2D/Collision/Shapes/b2CircleShape.h>
#include <Box2D/Collision/Shapes/b2EdgeShape.h>
#include <Box2D/Collision/Shapes/b2PolygonShape.h>
#include <Box2D/Common/b2Math.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <ostream>

/// Seeded random numbers and shapes for the tests of Common and Collision, and a plain
/// double-precision geometry to check them against. Uses nothing of the code under test but its
/// data.

/// SplitMix64: the same numbers on every machine.
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t Bits()
    {
        m_state += 0x9e3779b97f4a7c15u;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    int32 Integer(int32 low, int32 high)
    {
        return low + static_cast<int32>(Bits() % static_cast<std::uint64_t>(high - low + 1));
    }

    float Real(float low, float high)
    {
        return low + (high - low) * static_cast<float>(Bits() >> 40) / 16777216.0f;
    }

    b2Vec2 Point(float reach) { return {Real(-reach, reach), Real(-reach, reach)}; }

    b2Transform Transform(float reach)
    {
        b2Transform xf;
        xf.p = Point(reach);
        xf.q.Set(Real(-4.0f, 4.0f));
        return xf;
    }

    /// A polygon of about the given size around the origin.
    b2PolygonShape Polygon(float size)
    {
        b2PolygonShape polygon;
        b2Vec2 points[b2_maxPolygonVertices];
        int32 count;
        do
        {
            count = Integer(3, b2_maxPolygonVertices);
            for (int32 i = 0; i < count; ++i)
            {
                points[i] = Point(size);
            }
        } while (b2PolygonShape::WhyNotConvex(points, count) != nullptr);
        polygon.Set(points, count);
        return polygon;
    }

    /// A polygon with at least 9 vertices, and at most b2_polygonCapacity, on a circle of the given
    /// radius around the origin.
    b2PolygonShape RoundPolygon(float radius)
    {
        b2Vec2 points[b2_polygonCapacity];
        const int32 count = Integer(b2_maxPolygonVertices + 1, b2_polygonCapacity);
        const float start = Real(-3.0f, 3.0f);
        for (int32 i = 0; i < count; ++i)
        {
            const float angle = start + 2.0f * b2_pi * float(i) / float(count);
            points[i] = radius * b2Rot(angle).GetXAxis();
        }
        b2PolygonShape polygon;
        polygon.Set(points, count);
        return polygon;
    }

    std::unique_ptr<b2Shape> Shape(float size)
    {
        switch (Integer(0, 2))
        {
        case 0: {
            auto circle = std::make_unique<b2CircleShape>();
            circle->m_p = Point(0.5f * size);
            circle->m_radius = Real(0.1f, 0.5f) * size;
            return circle;
        }
        case 1: {
            auto edge = std::make_unique<b2EdgeShape>();
            edge->m_vertex1 = Point(size); // one after the other: arguments have no order
            edge->m_vertex2 = Point(size);
            return edge;
        }
        default:
            return std::make_unique<b2PolygonShape>(Polygon(size));
        }
    }

private:
    std::uint64_t m_state;
};

/// A point or vector in double precision.
struct Vec
{
    double x = 0.0;
    double y = 0.0;
};

inline Vec ToVec(const b2Vec2& v)
{
    return {v.x, v.y};
}

inline Vec operator+(Vec a, Vec b)
{
    return {a.x + b.x, a.y + b.y};
}

inline Vec operator-(Vec a, Vec b)
{
    return {a.x - b.x, a.y - b.y};
}

inline Vec operator*(double s, Vec a)
{
    return {s * a.x, s * a.y};
}

inline double Dot(Vec a, Vec b)
{
    return a.x * b.x + a.y * b.y;
}

inline double Cross(Vec a, Vec b)
{
    return a.x * b.y - a.y * b.x;
}

inline double Length(Vec a)
{
    return std::sqrt(Dot(a, a));
}

inline Vec Unit(Vec a)
{
    return (1.0 / Length(a)) * a;
}

inline Vec Transformed(const b2Transform& xf, const b2Vec2& v)
{
    const double c = xf.q.c;
    const double s = xf.q.s;
    return {c * v.x - s * v.y + xf.p.x, s * v.x + c * v.y + xf.p.y};
}

inline std::ostream& operator<<(std::ostream& out, const b2Vec2& v)
{
    return out << "(" << v.x << ", " << v.y << ")";
}
