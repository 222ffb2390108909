// SPDX-License-Identifier: MIT
#include "LabelSpots.h"
#include "WorldSeen.h"

#include <debugdraw/GlyphPen.h>
#include <debugdraw/WorldBodies.h>

#include <algorithm>
#include <vector>

namespace boxreel
{

namespace
{

// Of a digit in the renderer's font [px]. A little off is a label a little off its centre.
constexpr double kDigitWidth = 8.3;
constexpr double kLineHeight = 16.0;
constexpr double kLetterHeight = 12.0; // of the line, what letters have ink on
constexpr double kWidestLetter = 32.0; // only to see which are in the picture [px]

// Beside its body, half a name of the longest reaches into the picture from here at most [px].
constexpr double kFarthestLetter = 1000.0;

constexpr double kMarkRadius = 6.0; // [px]

constexpr Color kInk{255, 255, 255, 255};

Vec2 CenterOf(const b2Body& body)
{
    return {body.GetWorldCenter().x, body.GetWorldCenter().y};
}

bool BeginsLetter(char c)
{
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

std::size_t LetterCount(const std::string& text)
{
    return std::size_t(std::count_if(text.begin(), text.end(), BeginsLetter));
}

/// At most so many bytes, cut between letters: a file may have names of any length.
std::string Shortened(const std::string& name)
{
    constexpr std::size_t kMost = 60;
    std::size_t length = std::min(name.size(), kMost);
    while (length < name.size() && length > 0 && !BeginsLetter(name[length]))
    {
        --length;
    }
    return length < name.size() ? name.substr(0, length) + "..." : name;
}

std::string NameOf(const BodyNames& names, std::uint32_t number)
{
    const auto named = names.find(number);
    return named != names.end() && !named->second.empty() ? Shortened(named->second)
                                                          : std::to_string(number);
}

/// Centred on `place`, or beside it when something is there.
void AddLabel(Vec2 place, const std::string& name, const View& view, LabelSpots& spots,
              DrawList& list)
{
    if (!view.Shows(place, kWidestLetter * double(1 + name.size())))
    {
        return;
    }
    const double width = kDigitWidth * double(LetterCount(name));
    const Vec2 middle = spots.Take(place, width, kLetterHeight);
    const double metersPerPixel = 1.0 / view.camera.pixelsPerMeter;
    list.AddText({float(middle.x - 0.5 * width * metersPerPixel),
                  float(middle.y + 0.5 * kLineHeight * metersPerPixel)},
                 name, kInk);
}

} // namespace

void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list)
{
    LabelSpots spots(view.camera, list);
    list.layer = DrawLayer::Labels;
    for (const b2Body* body : SeenBodies(world, view, kFarthestLetter))
    {
        list.owner = static_cast<std::uint32_t>(body->GetNumber());
        AddLabel(CenterOf(*body), NameOf(names, list.owner), view, spots, list);
    }
    list.owner = kNoOwner;
}

void AddJointNames(const b2World& world, const View& view, const JointNames& names, DrawList& list)
{
    LabelSpots spots(view.camera, list);
    list.layer = DrawLayer::Labels;
    list.owner = kNoOwner;
    std::vector<const b2Joint*> joints; // newest first
    for (const b2Joint* joint = names.empty() ? nullptr : world.GetJointList(); joint != nullptr;
         joint = joint->GetNext())
    {
        joints.push_back(joint);
    }
    for (auto joint = joints.rbegin(); joint != joints.rend(); ++joint)
    {
        const auto named = names.find(*joint);
        if (named != names.end() && !named->second.empty())
        {
            const b2Vec2 place = 0.5f * ((*joint)->GetAnchorA() + (*joint)->GetAnchorB());
            AddLabel({place.x, place.y}, Shortened(named->second), view, spots, list);
        }
    }
}

void AddCenterMarks(const b2World& world, const View& view, DrawList& list)
{
    list.layer = DrawLayer::CentersOfMass;
    for (const b2Body* body : SeenBodies(world, view, kMarkRadius))
    {
        if (body->GetMass() > 0.0f && view.Shows(CenterOf(*body), kMarkRadius))
        {
            list.owner = static_cast<std::uint32_t>(body->GetNumber());
            const b2Vec2 axis = body->GetWorldVector(b2Vec2(1.0f, 0.0f));
            GlyphPen pen(list, view.camera, CenterOf(*body), {axis.x, axis.y}, kInk);
            pen.Circle({0.0, 0.0}, kMarkRadius);
            pen.Quarter(kMarkRadius, 0);
            pen.Quarter(kMarkRadius, 2);
        }
    }
    list.owner = kNoOwner;
}

} // namespace boxreel
