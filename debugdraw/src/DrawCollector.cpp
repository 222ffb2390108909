// SPDX-License-Identifier: MIT
#include <debugdraw/DrawCollector.h>

#include <Box2D/Dynamics/b2World.h>

namespace boxreel
{

namespace
{

constexpr float kAxisLength = 0.4f; // of a drawn frame of reference [m]

Vec2 From(const b2Vec2& v)
{
    return {v.x, v.y};
}

// Rounds to 256 steps and clamps; NaN is clamped too.
std::uint8_t ChannelFrom(float32 channel)
{
    return channel > 0.0f
               ? static_cast<std::uint8_t>(channel < 1.0f ? channel * 255.0f + 0.5f : 255.0f)
               : std::uint8_t{0};
}

Color From(const b2Color& color)
{
    return {ChannelFrom(color.r), ChannelFrom(color.g), ChannelFrom(color.b), ChannelFrom(color.a)};
}

// The table of layers does not include the engine.
static_assert(LayerOfFlag(b2Draw::e_shapeBit) == DrawLayer::Shapes &&
              LayerOfFlag(b2Draw::e_jointBit) == DrawLayer::Joints &&
              LayerOfFlag(b2Draw::e_aabbBit) == DrawLayer::Aabbs &&
              LayerOfFlag(b2Draw::e_pairBit) == DrawLayer::Pairs &&
              LayerOfFlag(b2Draw::e_centerOfMassBit) == DrawLayer::CentersOfMass);

} // namespace

// Axes extend beyond their origin; the same margin is used for all items.
void DrawCollector::LookAt(const View& view)
{
    if (!view.area)
    {
        ClearView();
        return;
    }
    const b2Vec2 reach(2.0f * kAxisLength, 2.0f * kAxisLength);
    SetView(b2Vec2(view.area->lower.x, view.area->lower.y) - reach,
            b2Vec2(view.area->upper.x, view.area->upper.y) + reach);
}

// The engine names the body of each shape; shapes without a body are drawn by the user, in the
// user's colours.
Paint DrawCollector::PaintOf(const b2Color& color) const
{
    const Color asked = From(color);
    const bool isOwn = m_list.layer == DrawLayer::Shapes && m_list.owner == kNoOwner;
    const DrawLayer roles = m_list.layer == DrawLayer::Scene ? m_sceneRoles : m_list.layer;
    return isOwn ? Paint(asked) : Paint(asked, EngineRole(roles, asked));
}

const Vec2* DrawCollector::Convert(const b2Vec2* vertices, int32 vertexCount)
{
    m_points.clear();
    for (int32 i = 0; i < vertexCount; ++i)
    {
        m_points.push_back(From(vertices[i]));
    }
    return m_points.data();
}

void DrawCollector::DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color)
{
    if (vertexCount >= 3)
    {
        m_list.AddPolygon(Convert(vertices, vertexCount), std::size_t(vertexCount), PaintOf(color));
    }
    else if (vertexCount > 0)
    {
        DrawSegment(vertices[0], vertices[vertexCount - 1], color);
    }
}

void DrawCollector::DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount,
                                     const b2Color& color)
{
    if (vertexCount < 3)
    {
        DrawPolygon(vertices, vertexCount, color);
        return;
    }
    m_list.AddSolidPolygon(Convert(vertices, vertexCount), std::size_t(vertexCount),
                           PaintOf(color));
}

void DrawCollector::DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color)
{
    m_list.AddCircle(From(center), radius, PaintOf(color));
}

void DrawCollector::DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                                    const b2Color& color)
{
    m_list.AddSolidCircle(From(center), radius, From(axis), PaintOf(color));
}

void DrawCollector::DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color)
{
    m_list.AddSegment(From(p1), From(p2), PaintOf(color));
}

void DrawCollector::DrawTransform(const b2Transform& xf)
{
    m_list.AddTransform(From(xf.p), From(xf.q.GetXAxis()), kAxisLength);
}

void DrawCollector::BeginLayer(uint32 flag)
{
    DrawLayer& layer = m_list.layer == DrawLayer::Scene ? m_sceneRoles : m_list.layer;
    layer = LayerOfFlag(flag);
}

void DrawCollector::BeginBody(int32 number)
{
    m_list.owner = number < 0 ? kNoOwner : static_cast<std::uint32_t>(number);
}

DrawList DrawListOf(b2World& world, uint32 flags)
{
    DrawList list;
    DrawCollector collector(list);
    collector.SetFlags(flags);
    world.SetDebugDraw(&collector);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
    return list;
}

} // namespace boxreel
