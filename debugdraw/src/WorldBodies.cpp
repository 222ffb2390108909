// SPDX-License-Identifier: MIT
#include "LabelSpots.h"
#include "WorldSeen.h"

#include <debugdraw/GlyphPen.h>
#include <debugdraw/TextWidth.h>
#include <debugdraw/WorldBodies.h>

#include <algorithm>
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

constexpr Paint kTieInk(ColorRole::Ink, 128);

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

double RoomIn(const View& view)
{
    return view.camera.width - kBeside;
}

struct Label
{
    Vec2 place; // [m]
    std::string name;
    std::uint32_t owner = kNoOwner;
};

void AddLabel(const Label& label, const LabelSpot& spot, const Camera& camera, DrawList& list)
{
    list.owner = label.owner;
    if (spot.tie)
    {
        list.AddSegment(label.place, *spot.tie, kTieInk);
    }
    const double metersPerPixel = 1.0 / camera.pixelsPerMeter;
    list.AddText({float(spot.middle.x - 0.5 * TextWidth(label.name) * metersPerPixel),
                  float(spot.middle.y + 0.5 * kTextHeight * metersPerPixel)},
                 label.name, ColorRole::Ink);
}

/// Each at its position, or beside it if there is an obstacle. Labels outside the picture, by a
/// wider estimate than that of renderers, stay at their position in unrestricted lists.
void AddLabels(const std::vector<Label>& labels, const View& view, DrawList& list)
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

} // namespace

void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list)
{
    std::vector<Label> labels;
    for (const b2Body* body : SeenBodies(world, view, kFarthestShape))
    {
        if (view.Shows(CenterOf(*body)))
        {
            const auto number = static_cast<std::uint32_t>(body->GetNumber());
            const auto named = names.find(number);
            const bool hasName = named != names.end() && !named->second.empty();
            labels.push_back(
                {CenterOf(*body),
                 Shortened(hasName ? named->second : std::to_string(number), RoomIn(view)),
                 number});
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
