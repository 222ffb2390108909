// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

/// @file
/// What a world draws itself through.

/// The colour of a debug-drawing call. Channels run from 0 to 1.
struct b2Color
{
    b2Color() = default;
    /// From red, green, blue and opacity, each 0 to 1.
    b2Color(float32 red, float32 green, float32 blue, float32 alpha = 1.0f)
        : r(red), g(green), b(blue), a(alpha)
    {}
    /// To red, green, blue and opacity, each 0 to 1.
    void Set(float32 red, float32 green, float32 blue, float32 alpha = 1.0f)
    {
        *this = b2Color(red, green, blue, alpha);
    }

    float32 r = 0.0f; ///< red, 0 to 1
    float32 g = 0.0f; ///< green, 0 to 1
    float32 b = 0.0f; ///< blue, 0 to 1
    float32 a = 1.0f; ///< opacity, 0 to 1
};

/// Derive from this, register it with b2World::SetDebugDraw and b2World::DrawDebugData calls back
/// for everything the flags ask for. Points are in world coordinates [m].
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
        e_centerOfMassBit = 0x0010, ///< centre of mass frame
    };

    void SetFlags(uint32 flags) { m_drawFlags = flags; }     ///< bits that replace all
    uint32 GetFlags() const { return m_drawFlags; }          ///< which bits are set
    void AppendFlags(uint32 flags) { m_drawFlags |= flags; } ///< bits to be set
    void ClearFlags(uint32 flags) { m_drawFlags &= ~flags; } ///< bits to be cleared

    /// Only what lies, in whole or in part, between these two corners [m] has to be drawn: what the
    /// world does not show costs next to nothing then. Calls whose points' box misses the view may
    /// be left out, all others come as they would without it, in the same order; BeginBody only for
    /// bodies of which something is drawn. What reaches beyond its points, as thick lines and the
    /// axes of DrawTransform do, is the drawer's to allow for. Not to be used in a callback of a
    /// step, when boxes lag behind. An addition to the manual's interface.
    void SetView(const b2Vec2& lowerBound, const b2Vec2& upperBound)
    {
        m_viewLower = lowerBound;
        m_viewUpper = upperBound;
        m_hasView = true;
    }
    /// Everything is drawn, as from the start. An addition to the manual's interface.
    void ClearView() { m_hasView = false; }
    bool HasView() const { return m_hasView; }                 ///< whether there is a view
    const b2Vec2& GetViewLower() const { return m_viewLower; } ///< as SetView was given [m]
    const b2Vec2& GetViewUpper() const { return m_viewUpper; } ///< as SetView was given [m]

    /// A closed outline, counter-clockwise, of vertexCount points [m].
    virtual void DrawPolygon(const b2Vec2* vertices, int32 vertexCount, const b2Color& color) = 0;
    /// A filled convex polygon, counter-clockwise, of vertexCount points [m].
    virtual void DrawSolidPolygon(const b2Vec2* vertices, int32 vertexCount,
                                  const b2Color& color) = 0;
    /// An outline; centre and radius [m].
    virtual void DrawCircle(const b2Vec2& center, float32 radius, const b2Color& color) = 0;
    /// `axis` is the unit vector that shows how the circle has turned.
    virtual void DrawSolidCircle(const b2Vec2& center, float32 radius, const b2Vec2& axis,
                                 const b2Color& color) = 0;
    /// A line from p1 to p2 [m].
    virtual void DrawSegment(const b2Vec2& p1, const b2Vec2& p2, const b2Color& color) = 0;
    /// A frame of reference; how long its axes are drawn is the drawer's choice.
    virtual void DrawTransform(const b2Transform& xf) = 0;

    /// What the calls that follow show: one of the bits above. An addition to the manual's
    /// interface; may be left as it is.
    virtual void BeginLayer(uint32 flag) { (void)flag; }
    /// Which body the calls that follow belong to: its number in order of creation, or -1 for none.
    /// An addition to the manual's interface; may be left as it is.
    virtual void BeginBody(int32 number) { (void)number; }

protected:
    uint32 m_drawFlags = 0;

private:
    b2Vec2 m_viewLower = b2Vec2(0.0f, 0.0f);
    b2Vec2 m_viewUpper = b2Vec2(0.0f, 0.0f);
    bool m_hasView = false;
};

/// The manual's name for the same interface.
typedef b2Draw b2DebugDraw;
