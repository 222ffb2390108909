// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// The interface for debug drawing.

/// The colour of a debug-drawing call. Channels run from 0 to 1.
struct b2Color
{
    b2Color() = default;
    /// Creates a colour from red, green, blue and opacity, each 0 to 1.
    b2Color(float32 red, float32 green, float32 blue, float32 alpha = 1.0f)
        : r(red), g(green), b(blue), a(alpha)
    {}
    /// Sets red, green, blue and opacity, each 0 to 1.
    void Set(float32 red, float32 green, float32 blue, float32 alpha = 1.0f)
    {
        *this = b2Color(red, green, blue, alpha);
    }

    float32 r = 0.0f; ///< red, 0 to 1
    float32 g = 0.0f; ///< green, 0 to 1
    float32 b = 0.0f; ///< blue, 0 to 1
    float32 a = 1.0f; ///< opacity, 0 to 1
};

/// The interface for debug drawing. Register an implementation with b2World::SetDebugDraw;
/// b2World::DrawDebugData calls it for all layers in the flags. Points are in world coordinates
/// [m].
class b2Draw
{
public:
    virtual ~b2Draw();

    enum
    {
        e_shapeBit = 0x0001,        ///< shapes
        e_jointBit = 0x0002,        ///< joint connections
        e_aabbBit = 0x0004,         ///< broad-phase boxes of the fixtures
        e_pairBit = 0x0008,         ///< pairs of fixtures whose boxes overlap
        e_centerOfMassBit = 0x0010, ///< centre of mass frames
    };

    void SetFlags(uint32 flags) { m_drawFlags = flags; }     ///< replaces all bits
    uint32 GetFlags() const { return m_drawFlags; }          ///< returns the bits
    void AppendFlags(uint32 flags) { m_drawFlags |= flags; } ///< sets bits
    void ClearFlags(uint32 flags) { m_drawFlags &= ~flags; } ///< clears bits

    /// Restricts drawing to what lies at least partly between two corners [m]. Bodies outside then
    /// cost almost no time. Calls whose points' box is outside the view may be omitted; the others
    /// keep their order. BeginBody is called only for bodies that are drawn. Content beyond the
    /// points, such as thick lines or the axes of DrawTransform, needs a larger view. Not allowed
    /// in a callback of a step, when boxes are not up to date. An addition to the manual's
    /// interface.
    void SetView(const b2Vec2& lowerBound, const b2Vec2& upperBound)
    {
        m_viewLower = lowerBound;
        m_viewUpper = upperBound;
        m_hasView = true;
    }
    /// Removes the restriction (default). An addition to the manual's interface.
    void ClearView() { m_hasView = false; }
    bool HasView() const { return m_hasView; }                 ///< true if a view is set
    const b2Vec2& GetViewLower() const { return m_viewLower; } ///< lower corner of the view [m]
    const b2Vec2& GetViewUpper() const { return m_viewUpper; } ///< upper corner of the view [m]

    /// Draws a closed outline, counter-clockwise, of vertexCount points [m].
    virtual void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) = 0;
    /// Draws a filled convex polygon, counter-clockwise, of vertexCount points [m].
    virtual void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount,
                                  const b2Color& color) = 0;
    /// Draws an outline; centre and radius [m].
    virtual void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) = 0;
    /// Draws a filled circle. `axis` is a unit vector that shows the rotation.
    virtual void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                                 const b2Color& color) = 0;
    /// Draws a line from p1 to p2 [m].
    virtual void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) = 0;
    /// Draws a frame of reference; the implementation chooses the length of the axes.
    virtual void DrawTransform(const b2Transform& xf) = 0;

    /// Announces the layer of the calls that follow: one of the bits above. The default does
    /// nothing. An addition to the manual's interface.
    virtual void BeginLayer(uint32 flag) { (void)flag; }
    /// Announces the body of the calls that follow: its number in creation order, or -1 for none.
    /// The default does nothing. An addition to the manual's interface.
    virtual void BeginBody(int32 number) { (void)number; }

protected:
    uint32 m_drawFlags = 0;

private:
    b2Vec2 m_viewLower = b2Vec2(0.0f, 0.0f);
    b2Vec2 m_viewUpper = b2Vec2(0.0f, 0.0f);
    bool m_hasView = false;
};

/// The manual's older name of the interface.
typedef b2Draw b2DebugDraw;
