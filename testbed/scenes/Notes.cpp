// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>

#include <cstdio>

namespace boxreel
{

namespace
{

constexpr float32 kDotRadius = 0.1f;  ///< [m]
constexpr float32 kHeadLength = 0.3f; ///< of an arrow, at most [m]

} // namespace

void DrawDot(b2Draw& draw, const b2Vec2& point, const b2Color& color)
{
    draw.DrawSolidCircle(point, kDotRadius, b2Vec2(1.0f, 0.0f), color);
}

void DrawArrow(b2Draw& draw, const b2Vec2& from, const b2Vec2& to, const b2Color& color)
{
    b2Vec2 along = to - from;
    const float32 length = along.Normalize();
    const float32 head = b2Min(kHeadLength, 0.5f * length);
    const b2Vec2 neck = to - head * along;
    draw.DrawSegment(from, to, color);
    draw.DrawSegment(to, neck + 0.5f * head * along.Skew(), color);
    draw.DrawSegment(to, neck - 0.5f * head * along.Skew(), color);
}

void DrawBox(b2Draw& draw, const b2AABB& box, const b2Color& color)
{
    const b2Vec2 corners[] = {box.lowerBound,
                              {box.upperBound.x, box.lowerBound.y},
                              box.upperBound,
                              {box.lowerBound.x, box.upperBound.y}};
    draw.DrawPolygon(corners, 4, color);
}

void DrawOutline(b2Draw& draw, const b2Shape& shape, const b2Transform& transform,
                 const b2Color& color)
{
    if (shape.GetType() == b2Shape::e_circle)
    {
        const auto& circle = static_cast<const b2CircleShape&>(shape);
        draw.DrawCircle(b2Mul(transform, circle.m_p), circle.m_radius, color);
    }
    else if (shape.GetType() == b2Shape::e_polygon)
    {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        b2Vec2 corners[b2_polygonCapacity];
        for (int32 i = 0; i < polygon.GetVertexCount(); ++i)
        {
            corners[i] = b2Mul(transform, polygon.GetVertex(i));
        }
        draw.DrawPolygon(corners, polygon.GetVertexCount(), color);
    }
    else if (shape.GetType() == b2Shape::e_edge)
    {
        const auto& edge = static_cast<const b2EdgeShape&>(shape);
        draw.DrawSegment(b2Mul(transform, edge.m_vertex1), b2Mul(transform, edge.m_vertex2), color);
    }
}

std::string WithUnit(float32 value, const char* unit)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.2f %s", static_cast<double>(value), unit);
    return text;
}

} // namespace boxreel
