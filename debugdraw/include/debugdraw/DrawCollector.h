// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Draw.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <vector>

class b2World;

/// @file
/// The engine's debug drawing as a DrawList: register it with b2World::SetDebugDraw, call
/// DrawDebugData, read the list. What the engine does not draw itself is in the World* headers.
namespace boxreel
{

/// A b2Draw that appends what the engine draws to a list.
class DrawCollector : public b2Draw
{
public:
    /// The list must outlive it.
    explicit DrawCollector(DrawList& list) : m_list(list) {}

    /// Only what this view may show is collected; everything unless said. The picture is the same.
    void LookAt(const View& view);

    void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override;
    /// With more corners than a DrawList fills (8): the outline alone.
    void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override;
    /// The outline of a circle [m].
    void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) override;
    void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                         const b2Color& color) override;
    /// A line from p1 to p2 [m].
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override;
    void DrawTransform(const b2Transform& xf) override;

    /// Which layer and which body the calls that follow belong to.
    void BeginLayer(uint32 flag) override;
    void BeginBody(int32 number) override;

private:
    Paint PaintOf(const b2Color& color) const;
    const Vec2* Convert(const b2Vec2* vertices, int32 vertexCount);

    DrawList& m_list;
    std::vector<Vec2> m_points; // scratch, kept so that drawing a frame allocates nothing
};

/// All that a world shows, of the layers that b2Draw's bits name. The world's debug drawing is
/// borrowed for it and none is registered afterwards.
DrawList DrawListOf(b2World& world, uint32 flags = b2Draw::e_shapeBit | b2Draw::e_jointBit);

} // namespace boxreel
