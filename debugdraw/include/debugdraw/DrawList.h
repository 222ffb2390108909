// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// What a world asked to draw: plain arrays in metres, in painter's order (later covers earlier).
/// Filled by a collector (ours or an adapter for another engine), read by renderers, figures and
/// golden tests. Can be built by hand, hashed, printed. Knows no pixels but the sizes of points and
/// text.
namespace boxreel
{

/// A point or a direction; in a list [m], world frame, y up.
struct Vec2
{
    float x = 0.0f; ///< to the right
    float y = 0.0f; ///< upwards
    /// True if all members are equal.
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// Axis-aligned, in metres; empty when upper < lower.
struct Rect
{
    Vec2 lower{1.0f, 1.0f};   ///< left and below
    Vec2 upper{-1.0f, -1.0f}; ///< right and above
    /// Whether it holds no point.
    bool IsEmpty() const { return upper.x < lower.x || upper.y < lower.y; }
    /// Grows as far as it must to hold the point.
    void Include(Vec2 point);
    void Include(const Rect& other); ///< an empty rect adds nothing
    /// True if all members are equal.
    friend bool operator==(const Rect&, const Rect&) = default;
};

/// sRGB, not premultiplied.
struct Color
{
    std::uint8_t r = 0;   ///< red, 0 to 255
    std::uint8_t g = 0;   ///< green, 0 to 255
    std::uint8_t b = 0;   ///< blue, 0 to 255
    std::uint8_t a = 255; ///< opacity, 0 to 255
    /// True if all members are equal.
    friend bool operator==(const Color&, const Color&) = default;
};

/// What an item is.
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

/// One thing to be drawn, its points and text in the list.
struct DrawItem
{
    DrawKind kind = DrawKind::Segment;   ///< what it is
    DrawLayer layer = DrawLayer::Shapes; ///< which layer it belongs to
    std::uint16_t count = 0;             ///< number of points
    std::uint32_t first = 0;             ///< index of the first in DrawList::points
    std::uint32_t owner = kNoOwner;      ///< the body it belongs to; kNoOwner: none
    std::uint32_t text = 0;              ///< Text only: index into DrawList::texts
    float size = 0.0f; ///< radius or length of axes [m], or diameter of a point [px]
    Color color;       ///< of lines, filling or letters
    /// True if all members are equal.
    friend bool operator==(const DrawItem&, const DrawItem&) = default;
};

/// What was asked to be drawn, in the order of asking.
class DrawList
{
public:
    std::vector<DrawItem> items;    ///< painter's order
    std::vector<Vec2> points;       ///< of all items, one after the other [m], world frame, y up
    std::vector<std::string> texts; ///< UTF-8; items of the kind Text name them by index

    /// What the Add functions stamp on the items that follow.
    DrawLayer layer = DrawLayer::Shapes;
    std::uint32_t owner = kNoOwner; ///< the body that is being drawn; kNoOwner: none

    /// An outline; corners [m] in either order.
    void AddPolygon(const Vec2* vertices, std::size_t count, Color color);
    /// An outline (DrawKind::Polygon) when there are more corners than 8, or it is not convex: all
    /// renderers and formats fill the same shapes then.
    void AddSolidPolygon(const Vec2* vertices, std::size_t count, Color color);
    /// An outline [m], radius 0 or more.
    void AddCircle(Vec2 center, float radius, Color color);
    /// A filled circle [m] with its radius drawn along `axis`, of length 1.
    void AddSolidCircle(Vec2 center, float radius, Vec2 axis, Color color);
    /// A line from a to b [m].
    void AddSegment(Vec2 a, Vec2 b, Color color);
    /// Two axes of that length [m]; `xAxis` has the length 1.
    void AddTransform(Vec2 origin, Vec2 xAxis, float axisLength);
    /// A dot, as large whatever the camera's scale is.
    void AddPoint(Vec2 center, float diameterPixels, Color color);
    /// Letters, UTF-8, below and right of a point of the world [m].
    void AddText(Vec2 topLeft, std::string_view text, Color color);

    /// Empties the list and keeps the memory.
    void Clear();

    /// Whether both draw the same, item by item; not what is stamped next.
    friend bool operator==(const DrawList& a, const DrawList& b)
    {
        return a.items == b.items && a.points == b.points && a.texts == b.texts;
    }

private:
    DrawItem& Add(DrawKind kind, const Vec2* vertices, std::size_t count, Color color);
};

} // namespace boxreel
