// SPDX-License-Identifier: MIT
#include <debugdraw/GlyphPen.h>
#include <debugdraw/TextWidth.h>
#include <debugdraw/WorldGlyphs.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>
#include <string>
#include <vector>

namespace boxreel
{

namespace
{

using Point = GlyphPen::Point;

constexpr ColorRole kGlyphColor = ColorRole::Joint;

// Maximum extent of glyphs and a rope's text beyond their anchor points [px].
constexpr double kReach = 48.0;
constexpr double kLetters = 240.0;

// Sizes of joints' parts [px].
constexpr double kHub = 6.0; // radius
constexpr double kPin = 4.0; // diameter of a dot
constexpr double kArrowRadius = 12.0;
constexpr double kSpring = 5.0;       // half its width
constexpr double kShortSpring = 14.0; // a shorter spring is not legible
constexpr double kRail = 30.0;        // half a rail without limits
constexpr double kPulley = 8.0;       // radius
constexpr double kGear = 18.0;        // radius without the teeth: encloses a hinge, its motor, or a
                                      // carriage
constexpr double kTooth = 4.0;
constexpr double kStrut = 26.0; // length of the spring above an axle
constexpr double kWeld = 5.0;   // half the square
constexpr double kRopeEnd = 4.0;

Vec2 From(const b2Vec2& v)
{
    return {v.x, v.y};
}

b2Vec2 XAxisOf(const b2Body& body)
{
    return body.GetWorldVector(b2Vec2(1.0f, 0.0f));
}

/// One decimal, independent of the locale.
std::string Meters(double length)
{
    std::array<char, 64> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), length,
                                   std::chars_format::fixed, 1);
    return std::string(digits.data(), end.ptr) + " m";
}

class GlyphWriter
{
public:
    GlyphWriter(const View& view, DrawList& list) : m_view(view), m_list(list) {}

    void Add(const b2Joint& joint);

private:
    GlyphPen PenAt(const b2Vec2& origin, const b2Vec2& xAxis)
    {
        return GlyphPen(m_list, m_view.camera, From(origin), From(xAxis), kGlyphColor);
    }
    bool Shows(const b2Vec2& a, const b2Vec2& b) const
    {
        return m_view.Shows(From(a), From(b), kReach);
    }
    void SetSize(std::size_t count, double size);
    void AddDashes(GlyphPen& pen, Point from, Point to);
    void AddMotor(GlyphPen& pen, bool enabled, float32 speed);
    void AddPins(const b2Vec2& a, const b2Vec2& b);
    void AddStop(GlyphPen& pen, float32 distance, bool exists);

    void Add(const b2RevoluteJoint& joint);
    void Add(const b2PrismaticJoint& joint);
    void Add(const b2DistanceJoint& joint);
    void Add(const b2PulleyJoint& joint);
    void AddPulleyWheel(const b2Vec2& wheel, const b2Vec2& end, const b2Vec2& inwards);
    void Add(const b2GearJoint& joint);
    void AddGearWheel(const b2Vec2& center, const b2Body& body);
    void Add(const b2WheelJoint& joint);
    void Add(const b2WeldJoint& joint);
    void Add(const b2RopeJoint& joint);
    void Add(const b2FrictionJoint& joint);
    void Add(const b2MouseJoint& joint);
    void Add(const b2MotorJoint& joint);

    const View& m_view;
    DrawList& m_list;
};

void GlyphWriter::AddMotor(GlyphPen& pen, bool enabled, float32 speed)
{
    if (enabled)
    {
        pen.ArcArrow(kArrowRadius, -4, 12, speed < 0.0f);
    }
}

/// Adds a stop perpendicular to the pen's axis, at this distance from its origin [m].
void GlyphWriter::AddStop(GlyphPen& pen, float32 distance, bool exists)
{
    if (exists)
    {
        const double at = double(distance) * m_view.camera.pixelsPerMeter;
        pen.Line({at, -kHub}, {at, kHub});
    }
}

void GlyphWriter::AddPins(const b2Vec2& a, const b2Vec2& b)
{
    for (const b2Vec2& end : {a, b})
    {
        PenAt(end, b2Vec2(1.0f, 0.0f)).Dot({}, kPin + 2.0);
    }
}

void GlyphWriter::Add(const b2RevoluteJoint& joint)
{
    const b2Vec2 anchor = joint.GetAnchorB();
    if (Shows(anchor, anchor))
    {
        GlyphPen pen = PenAt(anchor, b2Vec2(1.0f, 0.0f));
        pen.Circle({}, kHub);
        pen.Dot({}, kPin);
        AddMotor(pen, joint.IsMotorEnabled(), joint.GetMotorSpeed());
    }
}

void GlyphWriter::Add(const b2PrismaticJoint& joint)
{
    const b2Vec2 axis = joint.GetBodyA()->GetWorldVector(joint.GetLocalAxisA());
    const b2Vec2 carriage = joint.GetAnchorB();
    GlyphPen rail = PenAt(joint.GetAnchorA(), axis);
    const double at = rail.Of(From(carriage)).x;
    const double pixelsPerMeter = m_view.camera.pixelsPerMeter;
    const bool limited = joint.IsLimitEnabled();
    const double from =
        limited ? joint.GetLowerLimit() * pixelsPerMeter : std::min(0.0, at) - kRail;
    const double to = limited ? joint.GetUpperLimit() * pixelsPerMeter : std::max(0.0, at) + kRail;
    if (!m_view.Shows(rail.At({from, 0.0}), rail.At({to, 0.0}), kReach) &&
        !Shows(carriage, carriage))
    {
        return;
    }
    rail.Line({from, 0.0}, {to, 0.0});
    if (limited)
    {
        rail.Line({from, -kHub}, {from, kHub});
        rail.Line({to, -kHub}, {to, kHub});
    }
    GlyphPen pen = PenAt(carriage, axis);
    pen.Box({}, 8.0, 4.5);
    if (joint.IsMotorEnabled())
    {
        const double way = joint.GetMotorSpeed() < 0.0f ? -1.0 : 1.0;
        pen.Line({-10.0 * way, 10.0}, {4.0 * way, 10.0});
        pen.Triangle({11.0 * way, 10.0}, {4.0 * way, 10.0 + 3.5 * way},
                     {4.0 * way, 10.0 - 3.5 * way});
    }
}

void GlyphWriter::Add(const b2DistanceJoint& joint)
{
    const b2Vec2 a = joint.GetAnchorA();
    const b2Vec2 b = joint.GetAnchorB();
    if (!Shows(a, b))
    {
        return;
    }
    GlyphPen pen = PenAt(a, b - a);
    const double length = pen.Of(From(b)).x;
    const bool isLong = joint.IsSpring() && length >= kShortSpring;
    const bool hasBoth = joint.IsSpring() && m_view.zoom > 1.0; // a viewer chooses
    if (hasBoth || !isLong)
    {
        pen.Line({0.0, -2.5}, {length, -2.5});
        pen.Line({0.0, 2.5}, {length, 2.5});
        SetSize(2, hasBoth ? -kShortSpring : 0.0);
    }
    if (hasBoth || isLong)
    {
        const std::size_t before = m_list.items.size();
        pen.Zigzag({}, {length, 0.0}, kSpring);
        SetSize(m_list.items.size() - before, hasBoth ? kShortSpring : 0.0);
    }
    AddStop(pen, joint.GetMinLength(), joint.GetMinLength() > b2_linearSlop);
    AddStop(pen, joint.GetMaxLength(), joint.GetMaxLength() < b2_maxFloat);
    AddPins(a, b);
}

/// For viewers one line, of which they draw the dashes that its length asks for.
void GlyphWriter::AddDashes(GlyphPen& pen, Point from, Point to)
{
    if (m_view.zoom > 1.0)
    {
        pen.Line(from, to);
        m_list.items.back().kind = DrawKind::Polygon;
        SetSize(1, GlyphPen::kDash);
    }
    else
    {
        pen.Dashes(from, to);
    }
}

/// Of the last items.
void GlyphWriter::SetSize(std::size_t count, double size)
{
    for (DrawItem& item : std::span(m_list.items).last(count))
    {
        item.size = float(size);
    }
}

// The rope is tangent to the outer side of the wheel.
void GlyphWriter::AddPulleyWheel(const b2Vec2& wheel, const b2Vec2& end, const b2Vec2& inwards)
{
    GlyphPen pen = PenAt(wheel, end - wheel);
    pen.Circle({}, kPulley);
    pen.Dot({}, kPin);
    const double distance = pen.Of(From(end)).x;
    if (distance > kPulley)
    {
        const double cosine = kPulley / distance;
        const double sine = std::sqrt(1.0 - cosine * cosine);
        const Point inside = pen.Of(From(wheel + inwards));
        const double side = inside.y > 0.0 ? -1.0 : 1.0;
        pen.Line({kPulley * cosine, side * kPulley * sine}, {distance, 0.0});
    }
}

void GlyphWriter::Add(const b2PulleyJoint& joint)
{
    const b2Vec2 wheelA = joint.GetGroundAnchorA();
    const b2Vec2 wheelB = joint.GetGroundAnchorB();
    const b2Vec2 endA = joint.GetAnchorA();
    const b2Vec2 endB = joint.GetAnchorB();
    Rect box{From(wheelA), From(wheelA)};
    for (const b2Vec2& point : {wheelB, endA, endB})
    {
        box.Include(From(point));
    }
    if (!m_view.Shows(box, kReach))
    {
        return;
    }
    const b2Vec2 across = wheelB - wheelA;
    AddPulleyWheel(wheelA, endA, across);
    AddPulleyWheel(wheelB, endB, -across);
    GlyphPen pen = PenAt(wheelA, across);
    const double ends = pen.Of(From(endA)).y + pen.Of(From(endB)).y;
    const double away = ends > 0.0 ? -kPulley : kPulley;
    pen.Line({0.0, away}, {pen.Of(From(wheelB)).x, away});
    AddPins(endA, endB);
}

void GlyphWriter::AddGearWheel(const b2Vec2& center, const b2Body& body)
{
    GlyphPen pen = PenAt(center, XAxisOf(body));
    pen.Circle({}, kGear);
    for (int step = 0; step < GlyphPen::kFullTurn; step += 2)
    {
        const Point out = GlyphPen::Direction(step);
        const double tip = kGear + kTooth;
        pen.Line({kGear * out.x, kGear * out.y}, {tip * out.x, tip * out.y});
    }
}

void GlyphWriter::Add(const b2GearJoint& joint)
{
    const b2Vec2 a = joint.GetAnchorA();
    const b2Vec2 b = joint.GetAnchorB();
    if (!Shows(a, b))
    {
        return;
    }
    AddGearWheel(a, *joint.GetBodyA());
    AddGearWheel(b, *joint.GetBodyB());
    GlyphPen pen = PenAt(a, b - a);
    const double length = pen.Of(From(b)).x;
    const double rim = kGear + kTooth;
    if (length > 2.0 * rim || m_view.zoom > 1.0)
    {
        AddDashes(pen, {rim, 0.0}, {length - rim, 0.0});
    }
}

void GlyphWriter::Add(const b2WheelJoint& joint)
{
    const b2Vec2 axle = joint.GetAnchorB();
    if (!Shows(axle, axle))
    {
        return;
    }
    // Towards the chassis.
    const b2Vec2 axis = joint.GetBodyA()->GetWorldVector(joint.GetLocalAxisA());
    const b2Vec2 chassis = joint.GetBodyA()->GetWorldCenter() - axle;
    GlyphPen pen = PenAt(axle, b2Dot(axis, chassis) < 0.0f ? -axis : axis);
    pen.Circle({}, kHub);
    pen.Dot({}, kPin);
    pen.Zigzag({kHub, 0.0}, {kHub + kStrut, 0.0}, kSpring);
    pen.Line({kHub + kStrut, -9.0}, {kHub + kStrut, 9.0});
    AddMotor(pen, joint.IsMotorEnabled(), joint.GetMotorSpeed());
}

void GlyphWriter::Add(const b2WeldJoint& joint)
{
    const b2Vec2 anchor = joint.GetAnchorB();
    if (Shows(anchor, anchor))
    {
        GlyphPen pen = PenAt(anchor, XAxisOf(*joint.GetBodyA()));
        pen.Box({}, kWeld, kWeld);
        pen.Line({-kWeld, -kWeld}, {kWeld, kWeld});
        pen.Line({-kWeld, kWeld}, {kWeld, -kWeld});
    }
}

// A hanging rope between ends at the distance c is nearly a parabola. With a small sag s, its
// length is c + 8 s^2 / (3 c). The sag is at most half the length. For ends above each other it
// would be a line. There it also sags sideways, more near its first end, so that both strands are
// visible.
void GlyphWriter::Add(const b2RopeJoint& joint)
{
    const b2Vec2 a = joint.GetAnchorA();
    const b2Vec2 b = joint.GetAnchorB();
    const double length = joint.GetMaxLength();
    const double chord = (b - a).Length();
    const double slack = std::max(0.0, length - chord);
    const double sag = std::min(std::sqrt(0.375 * chord * slack + 0.25 * slack * slack),
                                0.5 * length); // also exact for coincident ends
    const double dx = double(b.x) - a.x;
    const double dy = double(b.y) - a.y;
    const double steepness = chord > 0.0f ? 1.0 - std::abs(dx) / double(chord) : 1.0;
    const double aside = (dx * dy < 0.0 ? -1.0 : 1.0) * steepness * sag;
    Rect box{From(a), From(a)};
    box.Include(From(b));
    box.lower.y -= float(sag);
    box.lower.x -= float(sag);
    box.upper.x += float(sag);
    if (!m_view.Shows(box, kReach + kLetters))
    {
        return;
    }
    const auto at = [&](double share) {
        const double hang = 4.0 * share * (1.0 - share);
        return Vec2{float(a.x + share * dx + aside * hang * 1.5 * (1.0 - share)),
                    float(a.y + share * dy - sag * hang)};
    };
    constexpr int kStretches = 31; // odd, so that both ends are drawn
    for (int i = 0; i < kStretches; i += 2)
    {
        m_list.AddSegment(at(double(i) / kStretches), at(double(i + 1) / kStretches), kGlyphColor);
    }
    for (const b2Vec2& end : {a, b})
    {
        PenAt(end, b2Vec2(1.0f, 0.0f)).Circle({}, kRopeEnd);
    }
    GlyphPen letters(m_list, m_view.camera, at(0.5), {1.0f, 0.0f}, kGlyphColor);
    const std::string text = Meters(length);
    // Below the rope, or right of a steep one.
    const double middle = -0.5 * TextWidth(text);
    const double left = middle + steepness * (7.0 - middle);
    m_list.AddText(letters.At({left, -3.0 + 11.0 * steepness}), text, kGlyphColor);
}

void GlyphWriter::Add(const b2FrictionJoint& joint)
{
    const b2Vec2 anchor = joint.GetAnchorB();
    if (Shows(anchor, anchor))
    {
        GlyphPen pen = PenAt(anchor, XAxisOf(*joint.GetBodyA()));
        pen.Circle({}, kHub);
        for (const double side : {-1.0, 1.0})
        {
            pen.Box({0.0, side * (kHub + 2.5)}, 8.0, 2.5);
        }
        pen.Dot({}, kPin);
    }
}

void GlyphWriter::Add(const b2MouseJoint& joint)
{
    const b2Vec2 target = joint.GetTarget();
    const b2Vec2 held = joint.GetAnchorB();
    if (!Shows(target, held))
    {
        return;
    }
    GlyphPen pen = PenAt(target, b2Vec2(1.0f, 0.0f));
    pen.Circle({}, kHub);
    for (int step = 0; step < GlyphPen::kFullTurn; step += 6)
    {
        const Point out = GlyphPen::Direction(step);
        pen.Line({3.0 * out.x, 3.0 * out.y}, {11.0 * out.x, 11.0 * out.y});
    }
    AddDashes(pen, {}, pen.Of(From(held)));
    PenAt(held, b2Vec2(1.0f, 0.0f)).Dot({}, kPin);
}

void GlyphWriter::Add(const b2MotorJoint& joint)
{
    const b2Vec2 a = joint.GetAnchorA();
    const b2Vec2 b = joint.GetAnchorB();
    if (!Shows(a, b))
    {
        return;
    }
    GlyphPen pen = PenAt(b, b2Vec2(1.0f, 0.0f));
    pen.Dot({}, kPin);
    pen.ArcArrow(kArrowRadius, -4, 12, false);
    GlyphPen line = PenAt(a, b - a);
    AddDashes(line, {}, {line.Of(From(b)).x, 0.0});
    PenAt(a, b2Vec2(1.0f, 0.0f)).Circle({}, kPin);
}

void GlyphWriter::Add(const b2Joint& joint)
{
    switch (joint.GetType())
    {
    case e_revoluteJoint:
        return Add(static_cast<const b2RevoluteJoint&>(joint));
    case e_prismaticJoint:
        return Add(static_cast<const b2PrismaticJoint&>(joint));
    case e_distanceJoint:
        return Add(static_cast<const b2DistanceJoint&>(joint));
    case e_pulleyJoint:
        return Add(static_cast<const b2PulleyJoint&>(joint));
    case e_gearJoint:
        return Add(static_cast<const b2GearJoint&>(joint));
    case e_wheelJoint:
        return Add(static_cast<const b2WheelJoint&>(joint));
    case e_weldJoint:
        return Add(static_cast<const b2WeldJoint&>(joint));
    case e_ropeJoint:
        return Add(static_cast<const b2RopeJoint&>(joint));
    case e_frictionJoint:
        return Add(static_cast<const b2FrictionJoint&>(joint));
    case e_mouseJoint:
        return Add(static_cast<const b2MouseJoint&>(joint));
    case e_motorJoint:
        return Add(static_cast<const b2MotorJoint&>(joint));
    case e_unknownJoint:
        return;
    }
}

/// Oldest first.
std::vector<const b2Joint*> JointsOf(const b2World& world)
{
    std::vector<const b2Joint*> joints;
    for (const b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        joints.push_back(joint);
    }
    std::reverse(joints.begin(), joints.end());
    return joints;
}

bool HasSameItems(const DrawList& a, const DrawList& b)
{
    return std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(),
                      [](const DrawItem& x, const DrawItem& y) {
                          return x.kind == y.kind && x.count == y.count;
                      });
}

/// Adds the anchors of a joint's points. A point at W + d, where d is in pixels, is at W + d / zoom
/// when the scale is `zoom` times as large. The glyph is drawn at both scales to find W. Where it
/// has other items there (a pulley's rope), a slightly larger scale does, though rounding counts
/// more.
void AddAnchors(const b2Joint& joint, const View& view, double zoom, std::vector<Vec2>& anchors)
{
    constexpr double kSlightly = 1.0 + 1.0 / 64.0;
    DrawList glyph;
    View own = view;
    own.zoom = zoom;
    GlyphWriter writer(own, glyph);
    writer.Add(joint);
    for (const double factor : {zoom, kSlightly})
    {
        View near = ViewOfEverything(view.camera);
        near.zoom = zoom;
        near.camera.pixelsPerMeter *= factor;
        DrawList enlarged;
        GlyphWriter(near, enlarged).Add(joint);
        if (!HasSameItems(glyph, enlarged))
        {
            continue;
        }
        const double share = factor / (factor - 1.0);
        for (std::size_t i = 0; i < glyph.points.size(); ++i)
        {
            const Vec2 p = glyph.points[i];
            const Vec2 q = enlarged.points[i];
            anchors.push_back({float(p.x - share * (double(p.x) - q.x)),
                               float(p.y - share * (double(p.y) - q.y))});
        }
        return;
    }
    anchors.insert(anchors.end(), glyph.points.begin(), glyph.points.end());
}

} // namespace

void AddJointGlyphs(const b2World& world, const View& view, DrawList& list)
{
    list.layer = DrawLayer::JointGlyphs;
    list.owner = kNoOwner;
    GlyphWriter writer(view, list);
    for (const b2Joint* const joint : JointsOf(world))
    {
        writer.Add(*joint);
    }
}

std::vector<Vec2> JointGlyphAnchors(const b2World& world, const View& view, double zoom)
{
    std::vector<Vec2> anchors;
    for (const b2Joint* const joint : JointsOf(world))
    {
        AddAnchors(*joint, view, zoom, anchors);
    }
    return anchors;
}

} // namespace boxreel
