// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What a world asked to draw: plain arrays in metres, in painter's order (later covers earlier).
/// Filled by a collector (ours or an adapter for another engine), read by renderers, figures and
/// golden tests. Can be built by hand, hashed, printed. Knows no pixels but the sizes of points and
/// text.
namespace boxreel
{

struct Vec2
{
    float x = 0.0f;
    float y = 0.0f;
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Axis-aligned, in metres; empty when upper < lower.
struct Rect
{
    Vec2 lower{1.0f, 1.0f};
    Vec2 upper{-1.0f, -1.0f};
    bool IsEmpty() const { return upper.x < lower.x || upper.y < lower.y; }
    void Include(Vec2 point);
    void Include(const Rect& other); ///< an empty rect adds nothing
    friend bool operator==(const Rect&, const Rect&) = default;
};

/// sRGB, not premultiplied.
struct Color
{
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;
    friend bool operator==(const Color&, const Color&) = default;
};

enum class DrawKind : std::uint8_t
{
    Polygon,      ///< count points, outline only
    SolidPolygon, ///< count points (3..8, convex, counter-clockwise): fill of half the colour, and
                  ///< outline
    Circle,       ///< point: centre; size: radius [m]; outline only
    SolidCircle,  ///< points: centre, unit axis; size: radius [m]; fill, outline and axis line
    Segment,      ///< two points
    Transform,    ///< points: origin, unit x axis; drawn as a red and a green axis of `size` metres
    Point,        ///< point: centre; size: diameter [px]
    Text,         ///< point: where the text's top left corner lies; `text`: index into texts
};

/// What switched the item on; a layer that is off is never collected.
enum class DrawLayer : std::uint8_t
{
    Shapes,
    Joints,
    Aabbs,
    Pairs,
    CentersOfMass,
    Contacts,
    Labels,
    ContactNormals,
    ContactImpulses,
    ContactFriction,
    Velocities,
    JointForces,
    JointGlyphs,
    Trails,      ///< where bodies have been, as lines
    Poses,       ///< how bodies stood earlier, faded
    Scene,       ///< what a scene draws beside its bodies: rays, hulls, marks
    Annotations, ///< axes, scale bars, dimensions, captions; solid shapes (heads of arrows) are
                 ///< filled with all of their colour
};

/// Whom an item belongs to: the body's number in its world, in order of creation.
inline constexpr std::uint32_t kNoOwner = 0xffffffffu;

struct DrawItem
{
    DrawKind kind = DrawKind::Segment;
    DrawLayer layer = DrawLayer::Shapes;
    std::uint16_t count = 0; ///< number of points
    std::uint32_t first = 0; ///< index of the first in DrawList::points
    std::uint32_t owner = kNoOwner;
    std::uint32_t text = 0; ///< Text only: index into DrawList::texts
    float size = 0.0f;
    Color color;
    friend bool operator==(const DrawItem&, const DrawItem&) = default;
};

class DrawList
{
public:
    std::vector<DrawItem> items; ///< painter's order
    std::vector<Vec2> points;    ///< [m], world frame, y up
    std::vector<std::string> texts;

    /// What the Add functions stamp on the items that follow.
    DrawLayer layer = DrawLayer::Shapes;
    std::uint32_t owner = kNoOwner;

    void AddPolygon(const Vec2* vertices, std::size_t count, Color color);
    /// An outline (DrawKind::Polygon) when there are more corners than 8, or it is not convex: all
    /// renderers and formats fill the same shapes then.
    void AddSolidPolygon(const Vec2* vertices, std::size_t count, Color color);
    void AddCircle(Vec2 center, float radius, Color color);
    void AddSolidCircle(Vec2 center, float radius, Vec2 axis, Color color);
    void AddSegment(Vec2 a, Vec2 b, Color color);
    void AddTransform(Vec2 origin, Vec2 xAxis, float axisLength);
    void AddPoint(Vec2 center, float diameterPixels, Color color);
    void AddText(Vec2 topLeft, std::string_view text, Color color);

    /// Empties the list and keeps the memory.
    void Clear();

    friend bool operator==(const DrawList& a, const DrawList& b)
    {
        return a.items == b.items && a.points == b.points && a.texts == b.texts;
    }

private:
    DrawItem& Add(DrawKind kind, const Vec2* vertices, std::size_t count, Color color);
};

} // namespace boxreel
