// SPDX-License-Identifier: MIT
#include "FigureCanvas.h"

#include "FigureLetters.h"

#include <debugdraw/DrawListText.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

namespace boxreel
{
namespace
{

// Shapes are clipped at this distance outside the picture [px]: both formats limit the size of
// numbers.
constexpr double kGuard = 4096.0;

// Circles that reach further than this from the corner [px] are skipped: scaled by the maximum,
// they would exceed PDF's numbers (Cairo's have 24 bits before the point).
constexpr double kFarthest = 5e5;

// Points closer than this [px] are equal in SVG, whose numbers have three decimals.
constexpr double kOnePoint = 1e-3;

// Maximum width of a character relative to its height, to find texts in the picture.
constexpr double kWidestLetter = 1.5;

/// Draws one panel. Its methods correspond to those of ShapeBuilder, which does the same for the
/// shaders.
class PanelPainter
{
public:
    PanelPainter(const FigurePanel& panel, const Theme& theme, std::set<std::string>& ids,
                 FigureCanvas& canvas)
        : m_panel(panel), m_list(panel.list), m_camera(panel.camera), m_theme(theme), m_ids(ids),
          m_canvas(canvas)
    {}

    void Run()
    {
        m_canvas.BeginPanel(m_panel);
        for (const DrawItem& item : m_list.items)
        {
            assert(std::size_t{item.first} + item.count <= m_list.points.size());
            if (IsShown(item))
            {
                EnterGroupOf(item);
                Add(item);
            }
        }
        if (m_open)
        {
            m_canvas.EndGroup();
        }
        m_canvas.EndPanel();
    }

private:
    Point ToPixel(Vec2 world) const
    {
        return {0.5 * m_camera.width + (world.x - m_camera.centerX) * m_camera.pixelsPerMeter,
                0.5 * m_camera.height - (world.y - m_camera.centerY) * m_camera.pixelsPerMeter};
    }
    FigureInk Stroke(const Paint& asked) const
    {
        return {m_theme.Outline(asked), asked.color.a / 255.0};
    }
    FigureInk Fill(const DrawItem& item) const
    {
        const Paint asked = item.Asked();
        if (item.layer == DrawLayer::Annotations)
        {
            return Stroke(asked);
        }
        const Color fill = m_theme.Fill(asked);
        const auto shaded = [this](std::uint8_t channel) {
            return static_cast<std::uint8_t>(std::floor(m_theme.fillShade * channel + 0.5f));
        };
        return {{shaded(fill.r), shaded(fill.g), shaded(fill.b)},
                double(m_theme.fillAlpha) * asked.color.a / 255.0};
    }

    bool IsShown(const DrawItem& item) const;
    void EnterGroupOf(const DrawItem& item);
    std::string UniqueId(const std::string& wanted) const;

    void Add(const DrawItem& item);
    void AddSolidPolygon(const Vec2* points, const DrawItem& item);
    void AddOutline(const Vec2* points, std::size_t count, const Paint& paint);
    void AddSolidCircle(Point center, double radius, Point axis, const DrawItem& item);
    void AddLine(Point a, Point b, const FigureInk& ink);
    void AddTransform(const Vec2* points, double length);
    void AddText(Point topLeft, const std::string& text, const Paint& paint);

    const FigurePanel& m_panel;
    const DrawList& m_list;
    const Camera& m_camera;
    const Theme& m_theme;
    std::set<std::string>& m_ids; // ids of the whole figure
    FigureCanvas& m_canvas;
    struct DrawnLine
    {
        Point from;
        Point to;
        FigureInk ink;
    };
    bool IsEndOfLastLine(Point at, const FigureInk& ink) const;

    std::optional<DrawnLine> m_lastLine; // of the group, if nothing was drawn above it
    bool m_open = false;                 // a group is open
    std::uint32_t m_owner = kNoOwner;
    DrawLayer m_layer = DrawLayer::Shapes;
};

bool PanelPainter::IsShown(const DrawItem& item) const
{
    const Vec2* const points = m_list.points.data() + item.first;
    if (item.count == 0 || !std::isfinite(item.size))
    {
        return false;
    }
    const double meters = m_camera.pixelsPerMeter;
    // Extent beyond the points [px].
    double reach = kMitreLimit * m_theme.outlineWidth;
    std::size_t places = item.count; // number of remaining points
    switch (item.kind)
    {
    case DrawKind::Circle:
    case DrawKind::SolidCircle:
    case DrawKind::Transform:
        reach += std::abs(item.size) * meters;
        places = 1;
        break;
    case DrawKind::Point:
        reach += std::abs(item.size);
        break;
    case DrawKind::Text:
        reach += kFigureLine * kWidestLetter * double(1 + m_list.texts[item.text].size());
        break;
    default:
        break;
    }
    Point lower = ToPixel(points[0]);
    Point upper = lower;
    for (std::size_t i = 0; i < item.count; ++i)
    {
        if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y))
        {
            return false;
        }
        const Point p = ToPixel(points[std::min(i, places - 1)]);
        lower = {std::min(lower.x, p.x), std::min(lower.y, p.y)};
        upper = {std::max(upper.x, p.x), std::max(upper.y, p.y)};
    }
    const bool isCircle = item.kind == DrawKind::Circle || item.kind == DrawKind::SolidCircle;
    if (isCircle && std::max(std::abs(lower.x), std::abs(lower.y)) + reach > kFarthest)
    {
        return false;
    }
    return upper.x + reach > 0.0 && upper.y + reach > 0.0 && lower.x - reach < m_camera.width &&
           lower.y - reach < m_camera.height;
}

void PanelPainter::EnterGroupOf(const DrawItem& item)
{
    if (m_open && item.owner == m_owner && item.layer == m_layer)
    {
        return;
    }
    if (m_open)
    {
        m_canvas.EndGroup();
    }
    m_open = true;
    m_lastLine.reset();
    m_owner = item.owner;
    m_layer = item.layer;
    const char* const layer = InfoOf(item.layer).name;
    FigureGroup group{"", "", layer};
    if (item.owner == kNoOwner)
    {
        group.id = layer;
    }
    else
    {
        const auto named = m_panel.bodyNames.find(item.owner);
        const bool hasName = named != m_panel.bodyNames.end() && !named->second.empty();
        group.title = hasName ? Readable(named->second) : "";
        group.id = "body-" + std::to_string(item.owner);
        group.id += hasName ? std::string("-").append(AsIdPart(named->second)) : "";
        group.id += item.layer == DrawLayer::Shapes ? "" : std::string("-") + layer;
    }
    if (!m_panel.name.empty())
    {
        group.id = std::string(m_panel.name).append("-").append(group.id);
    }
    group.id = UniqueId(group.id);
    m_ids.insert(group.id);
    m_canvas.BeginGroup(group);
}

std::string PanelPainter::UniqueId(const std::string& wanted) const
{
    std::string id = wanted;
    for (int number = 2; m_ids.contains(id); ++number)
    {
        id = wanted + "-" + std::to_string(number);
    }
    return id;
}

void PanelPainter::Add(const DrawItem& item)
{
    const Vec2* const points = m_list.points.data() + item.first;
    const Point first = ToPixel(points[0]);
    const double radius = std::abs(item.size) * m_camera.pixelsPerMeter;
    if (item.kind != DrawKind::Segment)
    {
        m_lastLine.reset();
    }
    switch (item.kind)
    {
    case DrawKind::Polygon:
        return AddOutline(points, item.count, item.Asked());
    case DrawKind::SolidPolygon:
        return AddSolidPolygon(points, item);
    case DrawKind::Circle:
        return m_canvas.Circle(first, radius, {{}, Stroke(item.Asked())});
    case DrawKind::SolidCircle:
        return AddSolidCircle(first, radius, {points[1].x, -points[1].y}, item);
    case DrawKind::Segment:
        return AddLine(first, ToPixel(points[1]), Stroke(item.Asked()));
    case DrawKind::Transform:
        return AddTransform(points, item.size);
    case DrawKind::Point:
        return m_canvas.Circle(first, 0.5 * std::abs(item.size), {Stroke(item.Asked()), {}});
    case DrawKind::Text:
        return AddText(first, m_list.texts[item.text], item.Asked());
    }
}

void PanelPainter::AddSolidPolygon(const Vec2* points, const DrawItem& item)
{
    const std::size_t count = item.count;
    const Paint paint = item.Asked();
    if (count > kMaxCorners - 4)
    {
        return AddOutline(points, count, paint); // more corners than the interface allows
    }
    std::array<Point, kMaxCorners> corners;
    std::transform(points, points + count, corners.begin(), [this](Vec2 p) { return ToPixel(p); });
    Convex polygon = MakeConvex(corners.data(), count);
    if (polygon.count < 3) // no area
    {
        return AddOutline(points, count, paint);
    }
    polygon =
        Clip(polygon, {-kGuard, -kGuard}, {m_camera.width + kGuard, m_camera.height + kGuard});
    if (polygon.count < 3) // only its bounding box touches the picture
    {
        return;
    }
    const auto all = [](const Convex& p) { return std::span(p.corners.data(), p.count); };
    if (paint.color.a == 255)
    {
        return m_canvas.Polygon(all(polygon), true, {Fill(item), Stroke(paint)});
    }
    // An outline covers what is below the shape, not the shape's own fill.
    const Convex inside = Shrink(polygon, 0.5 * double(m_theme.outlineWidth));
    if (inside.count >= 3)
    {
        m_canvas.Polygon(all(inside), true, {Fill(item), {}});
    }
    m_canvas.Polygon(all(polygon), true, {{}, Stroke(paint)});
}

void PanelPainter::AddOutline(const Vec2* points, std::size_t count, const Paint& paint)
{
    std::vector<Point> corners(count);
    std::transform(points, points + count, corners.begin(), [this](Vec2 p) { return ToPixel(p); });
    const bool isFar = std::any_of(corners.begin(), corners.end(), [this](Point p) {
        return p.x < -kGuard || p.y < -kGuard || p.x > m_camera.width + kGuard ||
               p.y > m_camera.height + kGuard;
    });
    if (!isFar && count > 2)
    {
        return m_canvas.Polygon(corners, false, {{}, Stroke(paint)});
    }
    for (std::size_t i = 0; i < count && !(count == 2 && i == 1); ++i)
    {
        AddLine(corners[i], corners[(i + 1) % count], Stroke(paint));
    }
}

void PanelPainter::AddSolidCircle(Point center, double radius, Point axis, const DrawItem& item)
{
    const Paint paint = item.Asked();
    const double length = Length(axis);
    const Point direction = length > 0.0 ? (1.0 / length) * axis : Point{1.0, 0.0};
    if (paint.color.a == 255)
    {
        m_canvas.Circle(center, radius, {Fill(item), Stroke(paint)});
    }
    else
    {
        const double inside = radius - 0.5 * double(m_theme.outlineWidth);
        if (inside > 0.0)
        {
            m_canvas.Circle(center, inside, {Fill(item), {}});
        }
        m_canvas.Circle(center, radius, {{}, Stroke(paint)});
    }
    AddLine(center, center + radius * direction, Stroke(paint));
}

bool PanelPainter::IsEndOfLastLine(Point at, const FigureInk& ink) const
{
    return m_lastLine && m_lastLine->ink.color == ink.color &&
           m_lastLine->ink.opacity == ink.opacity &&
           (Length(m_lastLine->from - at) < kOnePoint || Length(m_lastLine->to - at) < kOnePoint);
}

void PanelPainter::AddLine(Point a, Point b, const FigureInk& ink)
{
    const auto range =
        ClipSegment(a, b, {-kGuard, -kGuard}, {m_camera.width + kGuard, m_camera.height + kGuard});
    if (range)
    {
        const Point from = range->first > 0.0 ? a + range->first * (b - a) : a;
        const Point to = range->second < 1.0 ? a + range->second * (b - a) : b;
        // A line of zero length is a dot equal to the round end of the line before it: the two
        // anchors of a hinge coincide.
        if (Length(to - from) >= kOnePoint || !IsEndOfLastLine(from, ink))
        {
            m_canvas.Line(from, to, ink);
            m_lastLine = DrawnLine{from, to, ink};
        }
    }
}

void PanelPainter::AddTransform(const Vec2* points, double length)
{
    const Point origin = ToPixel(points[0]);
    const double scale = length * m_camera.pixelsPerMeter;
    const Point x{scale * points[1].x, -scale * points[1].y};
    const Point y{x.y, -x.x}; // rotated by 90 degrees to the left, with y down
    AddLine(origin, origin + x, {m_theme.xAxis, 1.0});
    AddLine(origin, origin + y, {m_theme.yAxis, 1.0});
}

void PanelPainter::AddText(Point topLeft, const std::string& text, const Paint& paint)
{
    double baseline = topLeft.y + kFigureAscent;
    for (std::size_t start = 0; start <= text.size();)
    {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = Readable(std::string_view(text).substr(start, end - start));
        if (!line.empty())
        {
            m_canvas.Text({topLeft.x, baseline}, line, Stroke(paint));
        }
        baseline += kFigureLine;
        start = end + 1;
    }
}

} // namespace

Figure FigureOf(DrawList list, const Camera& camera, const Theme& theme)
{
    Figure figure;
    figure.width = camera.width;
    figure.height = camera.height;
    figure.theme = theme;
    figure.panels.push_back({std::move(list), camera, 0.0, 0.0, {}});
    return figure;
}

void PaintFigure(const Figure& figure, FigureCanvas& canvas)
{
    std::set<std::string> ids;
    for (const FigurePanel& panel : figure.panels)
    {
        PanelPainter(panel, figure.theme, ids, canvas).Run();
    }
}

Result<void> CheckFigure(const Figure& figure)
{
    const auto isSize = [](int width, int height) {
        return width >= 1 && height >= 1 && width <= kLargestFigure && height <= kLargestFigure;
    };
    bool usable = isSize(figure.width, figure.height);
    for (const FigurePanel& panel : figure.panels)
    {
        const Camera& camera = panel.camera;
        usable = usable && isSize(camera.width, camera.height) && std::isfinite(panel.x) &&
                 std::isfinite(panel.y);
        if (!CanBeDrawn(camera))
        {
            return Error{
                ErrorKind::Unusable, "camera",
                "centre and scale must be finite, the scale above zero, both at most 1e15 pixels",
                "check pixelsPerMeter"};
        }
    }
    if (!usable)
    {
        return Error{ErrorKind::Unusable, "size",
                     "a figure and its panels must be 1 to " + std::to_string(kLargestFigure) +
                         " pixels wide and high"};
    }
    if (!(figure.scale >= 0.1 && figure.scale <= 16.0))
    {
        return Error{ErrorKind::Unusable, "scale " + std::to_string(figure.scale),
                     "must be between 0.1 and 16"};
    }
    return {};
}

} // namespace boxreel
