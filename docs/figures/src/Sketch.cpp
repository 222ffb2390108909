// SPDX-License-Identifier: MIT
#include "Sketch.h"

#include <debugdraw/Arrow.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Faded.h>
#include <debugdraw/GlyphPen.h>
#include <debugdraw/TextWidth.h>
#include <debugdraw/Trail.h>
#include <debugdraw/WorldBodies.h>
#include <debugdraw/WorldGlyphs.h>

#include <cmath>
#include <set>

using namespace boxreel;

namespace figures
{
namespace
{

struct Direction
{
    double x, y; // y down
};

Direction DirectionOf(Side side)
{
    switch (side)
    {
    case Side::Right:
        return {1, 0};
    case Side::AboveRight:
        return {1, -1};
    case Side::Above:
        return {0, -1};
    case Side::AboveLeft:
        return {-1, -1};
    case Side::Left:
        return {-1, 0};
    case Side::BelowLeft:
        return {-1, 1};
    case Side::Below:
        return {0, 1};
    case Side::BelowRight:
        return {1, 1};
    case Side::On:
        break;
    }
    return {0, 0};
}

/// Bodies are numbered in the order of their creation, and listed newest first.
std::set<std::uint32_t> MovingBodies(const b2World& world)
{
    std::set<std::uint32_t> moving;
    auto number = std::uint32_t(world.GetBodyCount());
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        --number;
        if (body->GetType() != b2_staticBody)
        {
            moving.insert(number);
        }
    }
    return moving;
}

void Collect(b2World& world, uint32 flags, DrawList& list)
{
    DrawCollector collector(list);
    collector.SetFlags(flags);
    world.SetDebugDraw(&collector);
    world.DrawDebugData();
    world.SetDebugDraw(nullptr);
}

} // namespace

Vec2 From(const b2Vec2& v)
{
    return {v.x, v.y};
}

Sketch::Sketch(int width, int height, const b2Vec2& center, double pixelsPerMeter)
{
    m_camera.width = width;
    m_camera.height = height;
    m_camera.centerX = center.x;
    m_camera.centerY = center.y;
    m_camera.pixelsPerMeter = pixelsPerMeter;
}

void Sketch::Annotate()
{
    m_list.layer = DrawLayer::Annotations;
    m_list.owner = kNoOwner;
}

void Sketch::Draw(b2World& world, uint32 flags)
{
    Collect(world, flags, m_list);
}

void Sketch::DrawFaint(b2World& world, double opacity)
{
    DrawList now;
    Collect(world, b2Draw::e_shapeBit, now);
    const std::set<std::uint32_t> moving = MovingBodies(world);
    AddFaded(m_list, now, opacity,
             [&](const DrawItem& item) { return moving.contains(item.owner); });
}

void Sketch::DrawGlyphs(const b2World& world)
{
    AddJointGlyphs(world, ViewOfEverything(m_camera), m_list);
}

void Sketch::DrawCenterMarks(const b2World& world)
{
    AddCenterMarks(world, ViewOfEverything(m_camera), m_list);
}

void Sketch::Line(const b2Vec2& from, const b2Vec2& to, Paint color)
{
    Annotate();
    m_list.AddSegment(From(from), From(to), color);
}

void Sketch::Dashes(const b2Vec2& from, const b2Vec2& to, Paint color)
{
    Annotate();
    GlyphPen pen(m_list, m_camera, From(from), From(to - from), color);
    pen.Dashes({}, {pen.Of(From(to)).x, 0.0});
}

void Sketch::Bar(const b2Vec2& from, const b2Vec2& to, Paint color)
{
    const b2Vec2 way = to - from;
    b2Vec2 across(-way.y, way.x);
    across.Normalize();
    across *= float32(1.0 / m_camera.pixelsPerMeter); // an outline adds half a pixel each side
    const Vec2 corners[4] = {From(from - across), From(to - across), From(to + across),
                             From(from + across)};
    Annotate();
    m_list.AddSolidPolygon(corners, 4, color);
}

void Sketch::Arrow(const b2Vec2& from, const b2Vec2& to, Paint color)
{
    const Paper paper = OnPaper();
    paper.Arrow(paper.ToPixel(From(from)), paper.ToPixel(From(to)), color);
}

void Sketch::ArrowAlong(const b2Vec2& from, const b2Vec2& direction, double pixels, Paint color)
{
    b2Vec2 unit = direction;
    unit.Normalize();
    Arrow(from, Shifted(from, pixels * unit.x, pixels * unit.y), color);
}

void Sketch::ArcArrow(const b2Vec2& center, double radius, float32 from, float32 to, Paint color)
{
    constexpr float32 kStretch = 0.1f; // [rad]
    const auto at = [&](float32 angle) {
        const b2Vec2 out = b2Rot(angle).GetXAxis();
        return Shifted(center, radius * out.x, radius * out.y);
    };
    // The head is straight, and lies on the arc with both ends.
    const auto head = float32(ArrowHead().length / radius);
    const float32 last = from < to ? to - head : to + head;
    const int count = 1 + int(b2Abs(last - from) / kStretch);
    for (int i = 0; i < count; ++i)
    {
        Line(at(from + (last - from) * float32(i) / float32(count)),
             at(from + (last - from) * float32(i + 1) / float32(count)), color);
    }
    Arrow(at(last), at(to), color);
}

void Sketch::Dot(const b2Vec2& at, Paint color, double diameter)
{
    Annotate();
    m_list.AddPoint(From(at), float(diameter), color);
}

void Sketch::Ring(const b2Vec2& at, double radius, Paint color)
{
    const Paper paper = OnPaper();
    paper.Circle(paper.ToPixel(From(at)), radius, color);
}

void Sketch::Outline(const std::vector<b2Vec2>& corners, Paint color)
{
    Annotate();
    std::vector<Vec2> points;
    for (const b2Vec2& corner : corners)
    {
        points.push_back(From(corner));
    }
    m_list.AddPolygon(points.data(), points.size(), color);
}

void Sketch::Fill(const std::vector<b2Vec2>& corners, ColorRole role)
{
    constexpr std::uint8_t kFillOpacity = 56; // as a theme's fillAlpha
    Annotate();
    std::vector<Vec2> points;
    for (const b2Vec2& corner : corners)
    {
        points.push_back(From(corner));
    }
    m_list.AddSolidPolygon(points.data(), points.size(), Paint(role, kFillOpacity));
}

void Sketch::Trail(const std::vector<b2Vec2>& way, Paint color)
{
    std::vector<Vec2> points;
    for (const b2Vec2& point : way)
    {
        points.push_back(From(point));
    }
    m_list.owner = kNoOwner;
    AddTrail(m_list, m_camera, points, {.color = color});
}

void Sketch::Measure(const b2Vec2& from, const b2Vec2& to, std::string_view label, double offset,
                     Paint color)
{
    AddDimension(m_list, m_camera, From(from), From(to),
                 {.offset = offset, .label = std::string(label), .color = color});
}

void Sketch::LabelAt(PixelPoint at, Side side, std::string_view text, Paint color, double gap)
{
    const Direction way = DirectionOf(side);
    // On a slant the corner of the text is nearest, so as much is left free in less of each axis.
    const double share = way.x != 0.0 && way.y != 0.0 ? 0.6 : 1.0;
    const Paper paper = OnPaper();
    std::vector<std::string> lines = WrapText(text, 1e9);
    const double height = kTextHeight * double(lines.size());
    const double x = at.x + share * gap * way.x;
    double y = at.y + share * gap * way.y - 0.5 * (1.0 - way.y) * height;
    for (const std::string& line : lines)
    {
        paper.Text({x, y}, line, {0.5 * (1.0 - way.x), 0.0}, color);
        y += kTextHeight;
    }
}

void Sketch::Label(const b2Vec2& at, Side side, std::string_view text, Paint color, double gap)
{
    LabelAt(OnPaper().ToPixel(From(at)), side, text, color, gap);
}

void Sketch::Caption(double x, double y, Side side, std::string_view text, Paint color)
{
    LabelAt({x, y}, side, text, color, 0.0);
}

void Sketch::Note(const b2Vec2& at, double right, double up, std::string_view text, Paint color)
{
    const b2Vec2 end = Shifted(at, right, up);
    Line(at, end, kQuiet);
    const bool isLevel = std::abs(right) >= std::abs(up);
    const Side side =
        isLevel ? (right > 0.0 ? Side::Right : Side::Left) : (up > 0.0 ? Side::Above : Side::Below);
    Label(end, side, text, color, isLevel ? 5.0 : 2.0);
}

b2Vec2 Sketch::Shifted(const b2Vec2& at, double right, double up) const
{
    return {float(at.x + right / m_camera.pixelsPerMeter),
            float(at.y + up / m_camera.pixelsPerMeter)};
}

b2Vec2 Sketch::AtPixel(double x, double y) const
{
    const b2Vec2 middle(float32(m_camera.centerX), float32(m_camera.centerY));
    return Shifted(middle, x - 0.5 * m_camera.width, 0.5 * m_camera.height - y);
}

void Sketch::Inset(const Sketch& detail, double x, double y)
{
    const auto pixels = [&](double right, double down) {
        return OnPaper().ToWorld({x + right, y + down});
    };
    const double width = detail.m_camera.width;
    const double height = detail.m_camera.height;
    Annotate();
    const Vec2 frame[4] = {pixels(0, 0), pixels(width, 0), pixels(width, height),
                           pixels(0, height)};
    m_list.AddPolygon(frame, 4, kQuiet);
    m_insets.push_back({detail.m_list, detail.m_camera, x, y, {}});
}

Figure Sketch::Finished() const
{
    Figure figure = FigureOf(m_list, m_camera, Theme::Print());
    figure.panels.insert(figure.panels.end(), m_insets.begin(), m_insets.end());
    return figure;
}

} // namespace figures
