// SPDX-License-Identifier: MIT
#pragma once

#include <box2d/box2d.h>

#include <debugdraw/DrawList.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// @file
/// The debug drawing of Box2D 2.4, such as Debian's libbox2d-dev, as a DrawList. For programs that
/// simulate with that library and draw, record or compare with this toolkit. Header only, so the
/// toolkit never links that library. Its classes have the names of our engine's classes: a program
/// includes and links one of the two, never both.
namespace boxreel::box2d24
{

/// Register it with b2World::SetDebugDraw, call DebugDraw, read the list. Box2D 2.4 does not
/// announce layers and bodies: items get the list's `layer` and `owner`.
class DrawCollector : public b2Draw
{
public:
    /// The list must outlive it.
    explicit DrawCollector(DrawList& list) : m_list(list) {}

    /// Adds a closed outline of world points [m]; fewer than three points give a line, none
    /// nothing.
    void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override
    {
        if (vertexCount >= 3)
        {
            Convert(vertices, vertexCount);
            m_list.AddPolygon(m_points.data(), m_points.size(), PaintOf(color));
        }
        else if (vertexCount > 0)
        {
            DrawSegment(vertices[0], vertices[vertexCount - 1], color);
        }
    }
    /// Adds a filled polygon; only its outline if it has more than 8 vertices.
    void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override
    {
        if (vertexCount < 3)
        {
            DrawPolygon(vertices, vertexCount, color);
            return;
        }
        Convert(vertices, vertexCount);
        m_list.AddSolidPolygon(m_points.data(), m_points.size(), PaintOf(color));
    }
    /// Adds an outline; centre and radius [m].
    void DrawCircle(const b2Vec2& center, float radius, const b2Color& color) override
    {
        m_list.AddCircle(From(center), radius, PaintOf(color));
    }
    /// Adds a filled circle [m], with a line from the centre along the unit vector `axis`.
    void DrawSolidCircle(const b2Vec2& center, float radius, const b2Vec2& axis,
                         const b2Color& color) override
    {
        m_list.AddSolidCircle(From(center), radius, From(axis), PaintOf(color));
    }
    /// Adds a line between world points [m].
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override
    {
        m_list.AddSegment(From(p1), From(p2), PaintOf(color));
    }
    /// Adds its axes, 0.4 m each, red x and green y.
    void DrawTransform(const b2Transform& xf) override
    {
        constexpr float axisLength = 0.4f; // [m], as in our engine
        m_list.AddTransform(From(xf.p), From(xf.q.GetXAxis()), axisLength);
    }
    /// Adds a point [m]; `size` is its diameter [px].
    void DrawPoint(const b2Vec2& p, float size, const b2Color& color) override
    {
        m_list.AddPoint(From(p), size, PaintOf(color));
    }

private:
    static Vec2 From(const b2Vec2& v) { return {v.x, v.y}; }
    // Rounds to 256 steps and clamps; NaN is clamped too.
    static std::uint8_t ChannelFrom(float channel)
    {
        return channel > 0.0f
                   ? static_cast<std::uint8_t>(channel < 1.0f ? channel * 255.0f + 0.5f : 255.0f)
                   : std::uint8_t{0};
    }
    static Color From(const b2Color& color)
    {
        return {ChannelFrom(color.r), ChannelFrom(color.g), ChannelFrom(color.b),
                ChannelFrom(color.a)};
    }
    // In the layers that the library draws, its colours have roles.
    Paint PaintOf(const b2Color& color) const
    {
        const Color asked = From(color);
        return {asked, EngineRole(m_list.layer, asked)};
    }
    void Convert(const b2Vec2* vertices, int32 vertexCount)
    {
        m_points.clear();
        for (int32 i = 0; i < vertexCount; ++i)
        {
            m_points.push_back(From(vertices[i]));
        }
    }

    DrawList& m_list;
    std::vector<Vec2> m_points; // scratch, kept to avoid allocations per frame
};

/// Returns the debug drawing of a world, for the layers in b2Draw's bits; items have no owner.
/// Replaces the world's debug drawing; none is registered afterwards.
inline DrawList DrawListOf(b2World& world, uint32 flags = b2Draw::e_shapeBit | b2Draw::e_jointBit)
{
    // In the order of DebugDraw, so that items overlap in the same way.
    constexpr std::array<uint32, 5> order{b2Draw::e_shapeBit, b2Draw::e_jointBit, b2Draw::e_pairBit,
                                          b2Draw::e_aabbBit, b2Draw::e_centerOfMassBit};
    DrawList list;
    DrawCollector collector(list);
    world.SetDebugDraw(&collector);
    for (const uint32 flag : order)
    {
        list.layer = LayerOfFlag(flag);
        collector.SetFlags(flags & flag);
        world.DebugDraw();
    }
    world.SetDebugDraw(nullptr);
    list.layer = DrawLayer::Shapes;
    return list;
}

} // namespace boxreel::box2d24
