// SPDX-License-Identifier: MIT
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
constexpr double kWidestLetter = 32.0; // only to see which are in the picture [px]

constexpr double kMarkRadius = 6.0; // [px]

constexpr Color kInk{255, 255, 255, 255};

std::vector<const b2Body*> OldestFirst(const b2World& world)
{
    std::vector<const b2Body*> bodies;
    bodies.reserve(std::size_t(world.GetBodyCount()));
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        bodies.push_back(body);
    }
    std::reverse(bodies.begin(), bodies.end());
    return bodies;
}

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

} // namespace

void AddBodyNames(const b2World& world, const View& view, const BodyNames& names, DrawList& list)
{
    list.layer = DrawLayer::Labels;
    for (const b2Body* body : OldestFirst(world))
    {
        list.owner = static_cast<std::uint32_t>(body->GetNumber());
        const std::string name = NameOf(names, list.owner);
        const Vec2 center = CenterOf(*body);
        if (view.Shows(center, kWidestLetter * double(1 + name.size())))
        {
            const double metersPerPixel = 1.0 / view.camera.pixelsPerMeter;
            const double left = 0.5 * kDigitWidth * double(LetterCount(name)) * metersPerPixel;
            const double up = 0.5 * kLineHeight * metersPerPixel;
            list.AddText({float(center.x - left), float(center.y + up)}, name, kInk);
        }
    }
    list.owner = kNoOwner;
}

void AddCenterMarks(const b2World& world, const View& view, DrawList& list)
{
    list.layer = DrawLayer::CentersOfMass;
    for (const b2Body* body : OldestFirst(world))
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
