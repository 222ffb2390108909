// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Draw.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <vector>

class b2World;

/// @file
/// The engine's debug drawing as a DrawList: register it with b2World::SetDebugDraw, call
/// DrawDebugData, read the list. The World* headers add what the engine does not draw itself.
namespace boxreel
{

/// A b2Draw that appends to a list.
class DrawCollector : public b2Draw
{
public:
    /// The list must outlive it.
    explicit DrawCollector(DrawList& list) : m_list(list) {}

    /// Restricts collection to items visible in the view; by default all. The picture is the same.
    void LookAt(const View& view);

    void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override;
    /// Adds a filled polygon; only its outline if it has more than 8 vertices.
    void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) override;
    /// Adds the outline of a circle [m].
    void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) override;
    void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                         const b2Color& color) override;
    /// Adds a line from p1 to p2 [m].
    void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) override;
    void DrawTransform(const b2Transform& xf) override;

    /// Sets the layer of the calls that follow. In a list whose layer is DrawLayer::Scene they stay
    /// in that layer, and only the engine's colours take their roles from the announced one.
    void BeginLayer(uint32 flag) override;
    /// Sets the body of the calls that follow.
    void BeginBody(int32 number) override;

private:
    Paint PaintOf(const b2Color& color) const;
    const Vec2* Convert(const b2Vec2* vertices, int32 vertexCount);

    DrawList& m_list;
    DrawLayer m_sceneRoles = DrawLayer::Scene; // whose roles the layer Scene has; Scene: none
    std::vector<Vec2> m_points;                // scratch, kept to avoid allocations per frame
};

/// Returns the debug drawing of a world, for the layers in b2Draw's bits. Replaces the world's
/// debug drawing; none is registered afterwards.
DrawList DrawListOf(b2World& world, uint32 flags = b2Draw::e_shapeBit | b2Draw::e_jointBit);

} // namespace boxreel
