// SPDX-License-Identifier: MIT
#include "LabelSpots.h"
#include "WorldSeen.h"

#include <debugdraw/GlyphPen.h>
#include <debugdraw/TextWidth.h>
#include <debugdraw/WorldBodies.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace boxreel
{

namespace
{

// A body at rest with its centre in the picture gets a name only if a shape is within this distance
// [px].
constexpr double kFarthestShape = 1000.0;

constexpr double kWidestLetter = 32.0; // for a quick test of visibility [px]
constexpr double kBeside = 8.0;        // minimum space beside the longest name [px]

constexpr double kMarkRadius = 6.0; // [px]

// A label that begins this near to the middle between two pixels begins at the second, for
// renderers and pages that round differently [px].
constexpr double kOffEdge = 1.0 / 64.0;

Vec2 CenterOf(const b2Body& body)
{
    return {body.GetWorldCenter().x, body.GetWorldCenter().y};
}

bool BeginsLetter(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

/// Replaces control characters and line ends by spaces; a line feed would continue the name on its
/// neighbour.
std::string InOneLine(std::string_view name)
{
    std::string line;
    for (std::size_t i = 0; i < name.size(); ++i)
    {
        const std::string_view rest = name.substr(i);
        const bool isC1 = rest.size() > 1 && rest[0] == '\xC2' && (rest[1] & 0xE0) == 0x80;
        const bool isEnd = rest.starts_with("\u2028") || rest.starts_with("\u2029");
        const bool isControl = static_cast<unsigned char>(rest[0]) < 0x20 || rest[0] == '\x7F';
        line += isControl || isC1 || isEnd ? ' ' : rest[0];
        i += isEnd ? 2 : isC1 ? 1 : 0;
    }
    return line;
}

/// Returns one line, limited in bytes and width [px], cut between characters: names in files may
/// have any length.
std::string Shortened(const std::string& given, double room)
{
    const std::string name = InOneLine(given);
    constexpr std::size_t kMaxBytes = 60;
    std::string shown = name.substr(0, kMaxBytes);
    while (!shown.empty() && (shown.size() < name.size() && !BeginsLetter(name[shown.size()])))
    {
        shown.pop_back();
    }
    if (shown.size() == name.size() && TextWidth(name) <= room)
    {
        return name;
    }
    while (!shown.empty() && TextWidth(shown + "...") > room)
    {
        do
        {
            shown.pop_back();
        } while (!shown.empty() && !BeginsLetter(name[shown.size()]));
    }
    return shown + "...";
}

bool IsOlder(const b2Body* a, const b2Body* b)
{
    return a->GetNumber() < b->GetNumber();
}

/// True if a shape is at most kFarthestShape beside the picture. The boxes of the tree, in which
/// SeenBodies looks, are larger.
bool HasShapeNear(const b2Body& body, const Camera& camera)
{
    const Rect picture = camera.VisibleArea();
    const auto reach = float(kFarthestShape / camera.pixelsPerMeter);
    b2AABB area;
    area.lowerBound.Set(picture.lower.x - reach, picture.lower.y - reach);
    area.upperBound.Set(picture.upper.x + reach, picture.upper.y + reach);
    for (const b2Fixture* fixture = body.GetFixtureList(); fixture; fixture = fixture->GetNext())
    {
        const b2Shape& shape = *fixture->GetShape();
        for (int32 child = 0; child < shape.GetChildCount(); ++child)
        {
            b2AABB box;
            shape.ComputeAABB(&box, body.GetTransform(), child);
            if (b2TestOverlap(area, box))
            {
                return true;
            }
        }
    }
    return false;
}

double RoomIn(const View& view)
{
    return view.camera.width - kBeside;
}

struct Label
{
    Vec2 place; // [m]
    std::string name;
    std::uint32_t owner = kNoOwner;
    bool needsShape = false; ///< only while a shape of the owner is near the picture
};

/// Returns the pixel with kOffEdge between it and the middle between two pixels.
double OffEdge(double pixel)
{
    const double fraction = pixel + 0.5 - std::floor(pixel + 0.5);
    const bool isNear = fraction < kOffEdge || fraction > 1.0 - kOffEdge;
    return isNear ? std::floor(pixel + 1.0) - 0.5 + kOffEdge : pixel;
}

/// Returns the place of a text, so that all viewers begin it at the same pixel.
Vec2 OffEdge(Vec2 place, const Camera& camera)
{
    const double scale = camera.pixelsPerMeter;
    const double x = 0.5 * camera.width + (double(place.x) - camera.centerX) * scale;
    const double y = 0.5 * camera.height - (double(place.y) - camera.centerY) * scale;
    const double safeX = OffEdge(x);
    const double safeY = OffEdge(y);
    return {safeX == x ? place.x : float(camera.centerX + (safeX - 0.5 * camera.width) / scale),
            safeY == y ? place.y : float(camera.centerY + (0.5 * camera.height - safeY) / scale)};
}

void AddLabel(const Label& label, const LabelSpot& spot, const Camera& camera, DrawList& list)
{
    list.owner = label.owner;
    if (spot.tie)
    {
        list.AddSegment(label.place, *spot.tie, kNameLine);
    }
    const double metersPerPixel = 1.0 / camera.pixelsPerMeter;
    const Vec2 topLeft{float(spot.middle.x - 0.5 * TextWidth(label.name) * metersPerPixel),
                       float(spot.middle.y + 0.5 * kTextHeight * metersPerPixel)};
    list.AddText(OffEdge(topLeft, camera), label.name, ColorRole::Ink);
}

/// Each at its position, or beside it if there is an obstacle. Labels outside the picture, by a
/// wider estimate than that of renderers, stay at their position in unrestricted lists.
void AddPlacedLabels(const std::vector<Label>& labels, const View& view, DrawList& list)
{
    std::vector<LabelWish> wishes;
    wishes.reserve(labels.size());
    for (const Label& label : labels)
    {
        wishes.push_back({label.place, TextWidth(label.name), label.owner});
    }
    LabelSpots room(view.camera, list);
    const std::vector<std::optional<LabelSpot>> spots = room.Settle(wishes);
    const View picture = ViewOf(view.camera, 0.0);
    list.layer = DrawLayer::Labels;
    for (std::size_t i = 0; i < labels.size(); ++i)
    {
        if (spots[i])
        {
            AddLabel(labels[i], *spots[i], view.camera, list);
        }
        else if (!view.area &&
                 !picture.Shows(labels[i].place, kWidestLetter * double(1 + labels[i].name.size())))
        {
            AddLabel(labels[i], {labels[i].place, std::nullopt}, view.camera, list);
        }
    }
    list.owner = kNoOwner;
}

/// At what they name, for a viewer that places them.
void AddWishes(const std::vector<Label>& labels, DrawList& list)
{
    list.layer = DrawLayer::Labels;
    for (const Label& label : labels)
    {
        list.owner = label.owner;
        list.AddText(label.place, label.name, ColorRole::Ink);
        list.items.back().size = label.needsShape ? 2.0f : 1.0f;
    }
    list.owner = kNoOwner;
}

void AddLabels(const std::vector<Label>& labels, const View& view, DrawList& list)
{
    if (view.zoom > 1.0)
    {
        AddWishes(labels, list);
    }
    else
    {
        AddPlacedLabels(labels, view, list);
    }
}

} // namespace

void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list)
{
    std::vector<Label> labels;
    const std::vector<const b2Body*> anywhere = BodiesSeenAnywhere(world);
    for (const b2Body* body : SeenBodies(world, view, kFarthestShape))
    {
        const bool needsShape =
            !std::binary_search(anywhere.begin(), anywhere.end(), body, IsOlder);
        if (view.Shows(CenterOf(*body)) &&
            (!needsShape || !view.area || HasShapeNear(*body, view.camera)))
        {
            const auto number = static_cast<std::uint32_t>(body->GetNumber());
            const auto named = names.find(number);
            const bool hasName = named != names.end() && !named->second.empty();
            labels.push_back(
                {CenterOf(*body),
                 Shortened(hasName ? named->second : std::to_string(number), RoomIn(view)), number,
                 needsShape});
        }
    }
    AddLabels(labels, view, list);
}

void AddJointNames(const b2World& world, const View& view, const JointNames& names, DrawList& list)
{
    std::vector<Label> labels; // newest first
    for (const b2Joint* joint = names.empty() ? nullptr : world.GetJointList(); joint != nullptr;
         joint = joint->GetNext())
    {
        const auto named = names.find(joint);
        const b2Vec2 place = 0.5f * (joint->GetAnchorA() + joint->GetAnchorB());
        if (named != names.end() && !named->second.empty() && view.Shows(Vec2{place.x, place.y}))
        {
            labels.push_back(
                {{place.x, place.y}, Shortened(named->second, RoomIn(view)), kNoOwner});
        }
    }
    std::reverse(labels.begin(), labels.end());
    AddLabels(labels, view, list);
}

void AddCenterMarks(const b2World& world, const View& view, DrawList& list)
{
    list.layer = DrawLayer::CenterMarks;
    for (const b2Body* body : SeenBodies(world, view, kMarkRadius))
    {
        if (body->GetMass() > 0.0f && view.Shows(CenterOf(*body), kMarkRadius))
        {
            list.owner = static_cast<std::uint32_t>(body->GetNumber());
            const b2Vec2 axis = body->GetWorldVector(b2Vec2(1.0f, 0.0f));
            GlyphPen pen(list, view.camera, CenterOf(*body), {axis.x, axis.y}, ColorRole::Ink);
            pen.Circle({0.0, 0.0}, kMarkRadius);
            pen.Quarter(kMarkRadius, 0);
            pen.Quarter(kMarkRadius, 2);
        }
    }
    list.owner = kNoOwner;
}

} // namespace boxreel
