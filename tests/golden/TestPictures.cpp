// SPDX-License-Identifier: MIT
#include "TestPictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace boxreel::test
{

namespace
{

constexpr int kWidth = 320;
constexpr int kHeight = 180;

struct Pixel
{
    int x;
    int y;
};

Pixel Snap(Vec2 world, const Style& style)
{
    return {kWidth / 2 + static_cast<int>(std::lround(world.x * style.pixelsPerMeter)),
            kHeight - 10 - static_cast<int>(std::lround(world.y * style.pixelsPerMeter))};
}

std::uint8_t Blend(std::uint8_t over, std::uint8_t ground, int shift)
{
    return static_cast<std::uint8_t>(std::clamp(over / 4 + ground / 2 + shift, 0, 255));
}

void PaintBox(Frame& frame, Pixel lower, Pixel upper, Color color, const Style& style)
{
    const Color fill{Blend(color.r, style.ground.r, style.fillShift),
                     Blend(color.g, style.ground.g, style.fillShift),
                     Blend(color.b, style.ground.b, style.fillShift), 255};
    FillRect(frame, lower.x, upper.y, upper.x, lower.y, color);
    const int inset = style.outline;
    FillRect(frame, lower.x + inset, upper.y + inset, upper.x - inset, lower.y - inset, fill);
}

void PaintLine(Frame& frame, Pixel a, Pixel b, Color color)
{
    const int steps = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), 1});
    for (int i = 0; i <= steps; ++i)
    {
        const int x = a.x + (b.x - a.x) * i / steps;
        const int y = a.y + (b.y - a.y) * i / steps;
        FillRect(frame, x, y, x + 1, y + 1, color);
    }
}

// A letter is five by seven blocks, any pattern that its code alone decides.
void PaintText(Frame& frame, Pixel at, const std::string& text, Color color)
{
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const std::uint64_t pattern =
            (static_cast<unsigned char>(text[i]) + 1) * 0x9e3779b97f4a7c15u;
        for (int block = 0; block < 35; ++block)
        {
            if (pattern >> (63 - block) & 1u)
            {
                const int x = at.x + 6 * static_cast<int>(i) + block % 5;
                FillRect(frame, x, at.y + block / 5, x + 1, at.y + block / 5 + 1, color);
            }
        }
    }
}

void AddBox(DrawList& list, Vec2 center, Vec2 half, Color color)
{
    const Vec2 corners[4] = {{center.x - half.x, center.y - half.y},
                             {center.x + half.x, center.y - half.y},
                             {center.x + half.x, center.y + half.y},
                             {center.x - half.x, center.y + half.y}};
    list.AddSolidPolygon(corners, 4, color);
    ++list.owner;
}

} // namespace

Frame Filled(int width, int height, Color color)
{
    Frame frame(width, height);
    FillRect(frame, 0, 0, width, height, color);
    return frame;
}

void FillRect(Frame& frame, int x0, int y0, int x1, int y1, Color color)
{
    for (int y = std::max(y0, 0); y < std::min(y1, frame.height); ++y)
    {
        for (int x = std::max(x0, 0); x < std::min(x1, frame.width); ++x)
        {
            const std::uint8_t bytes[4] = {color.r, color.g, color.b, color.a};
            std::copy(bytes, bytes + 4, frame.Pixel(x, y));
        }
    }
}

DrawList SmallScene()
{
    DrawList list;
    list.owner = 0;
    AddBox(list, {0.0f, 0.25f}, {10.0f, 0.25f}, kStatic);
    AddBox(list, {-4.0f, 1.5f}, {1.0f, 1.0f}, kAwake);
    AddBox(list, {-3.5f, 3.0f}, {1.0f, 1.0f}, kStatic); // overlaps the one before
    AddBox(list, {5.0f, 6.0f}, {1.0f, 0.5f}, kAwake);
    list.layer = DrawLayer::Joints;
    list.AddSegment({-3.5f, 3.0f}, {5.0f, 6.0f}, kJoint);
    list.layer = DrawLayer::Labels;
    list.AddText({-9.0f, 10.0f}, "crank", kJoint);
    return list;
}

Frame Painted(const DrawList& list, const Style& style)
{
    Frame frame = Filled(kWidth, kHeight, style.ground);
    for (const DrawItem& item : list.items)
    {
        const Vec2* points = list.points.data() + item.first;
        switch (item.kind)
        {
        case DrawKind::SolidPolygon:
            PaintBox(frame, Snap(points[0], style), Snap(points[2], style), item.color, style);
            break;
        case DrawKind::Segment:
            PaintLine(frame, Snap(points[0], style), Snap(points[1], style), item.color);
            break;
        case DrawKind::Text:
            PaintText(frame, Snap(points[0], style), list.texts[item.text], item.color);
            break;
        default:
            break;
        }
    }
    return frame;
}

GoldenCandidate Candidate(const std::string& name, const DrawList& list, const Style& style)
{
    return {name, "0123456789abcdef", list, Painted(list, style)};
}

DrawList WithSwappedOrder(const DrawList& list, std::size_t index)
{
    DrawList swapped = list;
    std::swap(swapped.items[index], swapped.items[index + 1]);
    return swapped;
}

DrawList WithoutItem(const DrawList& list, std::size_t index)
{
    DrawList shorter = list;
    shorter.items.erase(shorter.items.begin() + static_cast<std::ptrdiff_t>(index));
    return shorter;
}

} // namespace boxreel::test
