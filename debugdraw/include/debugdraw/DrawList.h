// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Color.h>
#include <debugdraw/DrawLayer.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// The items that a world draws: plain arrays in metres, in painter's order (later covers earlier).
/// Filled by a collector (ours or an adapter for another engine), read by renderers, figures and
/// golden tests. Can be built by hand, hashed and printed. Only the sizes of points and text are in
/// pixels.
namespace boxreel
{

/// A point or a direction; in a list in metres, world frame, y up.
struct Vec2
{
    float x = 0.0f; ///< to the right
    float y = 0.0f; ///< upwards
    /// True if all members are equal.
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

/// An axis-aligned rectangle in metres; empty when upper < lower.
struct Rect
{
    Vec2 lower{1.0f, 1.0f};   ///< lower left corner
    Vec2 upper{-1.0f, -1.0f}; ///< upper right corner
    /// True if it contains no point.
    bool IsEmpty() const { return upper.x < lower.x || upper.y < lower.y; }
    /// Grows to contain the point.
    void Include(Vec2 point);
    void Include(const Rect& other); ///< an empty rectangle adds nothing
    /// True if all members are equal.
    friend bool operator==(const Rect&, const Rect&) = default;
};

/// The kind of an item.
enum class DrawKind : std::uint8_t
{
    Polygon,      ///< count points, outline only
    SolidPolygon, ///< count points (3..16, convex, counter-clockwise): outline, and fill of half
                  ///< the colour
    Circle,       ///< point: centre; size: radius [m]; outline only
    SolidCircle,  ///< points: centre, unit axis; size: radius [m]; fill, outline and axis line
    Segment,      ///< two points
    Transform,    ///< points: origin, unit x axis; drawn as a red and a green axis of `size` metres
    Point,        ///< point: centre; size: diameter [px]
    Text,         ///< point: top left corner of the text; `text`: index into texts
};

/// The owner of an item without a body. Other owners are the body's number in order of creation.
inline constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// One item; its points and text are in the list.
struct DrawItem
{
    DrawKind kind = DrawKind::Segment;   ///< kind of the item
    DrawLayer layer = DrawLayer::Shapes; ///< layer of the item
    std::uint16_t count = 0;             ///< number of points
    std::uint32_t first = 0;             ///< index of the first in DrawList::points
    std::uint32_t owner = kNoOwner;      ///< the body it belongs to; kNoOwner: none
    std::uint32_t text = 0;              ///< Text only: index into DrawList::texts
    float size = 0.0f; ///< radius or length of axes [m], or diameter of a point [px]; for viewers
                       ///< that zoom, see View::zoom
    Color color;       ///< colour of lines, fill or letters in the classic theme
    ColorRole role = ColorRole::None;             ///< role of the colour
    Paint Asked() const { return {color, role}; } ///< colour and role
    /// True if all members are equal.
    friend bool operator==(const DrawItem&, const DrawItem&) = default;
};

/// A list of items in drawing order.
class DrawList
{
public:
    std::vector<DrawItem> items;    ///< painter's order
    std::vector<Vec2> points;       ///< points of all items, in order [m], world frame, y up
    std::vector<std::string> texts; ///< UTF-8; Text items refer to them by index

    /// Layer of the items added next.
    DrawLayer layer = DrawLayer::Shapes;
    std::uint32_t owner = kNoOwner; ///< owner of the items added next; kNoOwner: none

    /// An outline; corners [m] in either order.
    void AddPolygon(const Vec2* vertices, std::size_t count, const Paint& paint);
    /// An outline (DrawKind::Polygon) when there are more corners than 8, or it is not convex: all
    /// renderers and formats fill the same shapes then.
    void AddSolidPolygon(const Vec2* vertices, std::size_t count, const Paint& paint);
    /// An outline [m], radius 0 or more.
    void AddCircle(Vec2 center, float radius, const Paint& paint);
    /// A filled circle [m] with its radius drawn along `axis`, of length 1.
    void AddSolidCircle(Vec2 center, float radius, Vec2 axis, const Paint& paint);
    /// A line from a to b [m].
    void AddSegment(Vec2 a, Vec2 b, const Paint& paint);
    /// Two axes of that length [m]; `xAxis` has the length 1.
    void AddTransform(Vec2 origin, Vec2 xAxis, float axisLength);
    /// A dot of fixed size in pixels at every scale.
    void AddPoint(Vec2 center, float diameterPixels, const Paint& paint);
    /// Letters, UTF-8, below and right of a point of the world [m].
    void AddText(Vec2 topLeft, std::string_view text, const Paint& paint);

    /// Clears the list and keeps the memory.
    void Clear();

    /// True if both contain equal items; the layer and owner of further items are ignored.
    friend bool operator==(const DrawList& a, const DrawList& b)
    {
        return a.items == b.items && a.points == b.points && a.texts == b.texts;
    }

private:
    DrawItem& Add(DrawKind kind, const Vec2* vertices, std::size_t count, const Paint& paint);
};

/// Returns the role of a colour in the debug drawing of `layer`, as engines of the Box2D family use
/// it. None if the colour has no role there.
ColorRole EngineRole(DrawLayer layer, Color color);

} // namespace boxreel
