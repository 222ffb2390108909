// SPDX-License-Identifier: MIT
#include "ImGuiDrawData.h"

#include "SoftShapes.h"

#include <imgui_internal.h>
#include <render/PanelStroke.h>

#include <algorithm>
#include <cassert>

namespace boxreel
{
namespace
{

// A stroke passes through Dear ImGui's lists as a fan of its points. Its first texture coordinate
// is this value, which no glyph has; the second is its width.
constexpr float kOpenStroke = -1.0f;
constexpr float kClosedStroke = -2.0f;

Color ColorOf(ImU32 packed)
{
    const auto channel = [&](int shift) { return std::uint8_t(packed >> shift & 0xffu); };
    return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
            channel(IM_COL32_A_SHIFT)};
}

Vec2 ToVec2(ImVec2 v)
{
    return {v.x, v.y};
}

/// Consecutive triangles around their first vertex, the only primitive of Dear ImGui. The vertices
/// are in order.
using Fan = std::vector<ImDrawVert>;

/// Returns the fan that starts with this triangle, and the index after it.
std::size_t ReadFan(const ImDrawList& list, const ImDrawCmd& command, std::size_t begin, Fan& fan)
{
    const auto index = [&](std::size_t i) {
        return list.IdxBuffer[int(command.IdxOffset + i)] + command.VtxOffset;
    };
    const auto add = [&](std::size_t i) { fan.push_back(list.VtxBuffer[int(index(i))]); };
    fan.clear();
    add(begin);
    add(begin + 1);
    add(begin + 2);
    std::size_t end = begin + 3;
    for (; end + 2 < command.ElemCount && index(end) == index(begin) &&
           index(end + 1) == index(end - 1);
         end += 3)
    {
        add(end + 2);
    }
    return end;
}

bool IsPlain(const Fan& fan)
{
    return std::all_of(fan.begin(), fan.end(), [&](const ImDrawVert& v) {
        return v.col == fan[0].col && v.uv.x == fan[0].uv.x && v.uv.y == fan[0].uv.y;
    });
}

bool IsStroke(const Fan& fan)
{
    return fan[0].uv.x < 0.0f;
}

bool IsUprightRectangle(const Fan& fan)
{
    const auto isBeside = [&](std::size_t a, std::size_t b) {
        return fan[a].pos.x == fan[b].pos.x;
    };
    const auto isLevel = [&](std::size_t a, std::size_t b) { return fan[a].pos.y == fan[b].pos.y; };
    return fan.size() == 4 &&
           ((isLevel(0, 1) && isBeside(1, 2) && isLevel(2, 3) && isBeside(3, 0)) ||
            (isBeside(0, 1) && isLevel(1, 2) && isBeside(2, 3) && isLevel(3, 0)));
}

/// True for a line drawn by Dear ImGui itself; filled quads are axis-aligned.
[[maybe_unused]] bool IsSlantedLine(const Fan& fan)
{
    return fan.size() == 4 && !IsStroke(fan) && !IsUprightRectangle(fan);
}

void AppendAsIs(const Fan& fan, Overlay& overlay)
{
    const auto first = std::uint32_t(overlay.vertices.size());
    for (const ImDrawVert& v : fan)
    {
        overlay.vertices.push_back({OnGrid(ToVec2(v.pos)), ToVec2(v.uv), ColorOf(v.col)});
    }
    for (std::uint32_t i = 2; i < fan.size(); ++i)
    {
        overlay.indices.insert(overlay.indices.end(), {first, first + i - 1, first + i});
    }
}

void Append(const Fan& fan, Vec2 white, Overlay& overlay)
{
    if (!IsPlain(fan) || (IsUprightRectangle(fan) && !IsStroke(fan)))
    {
        AppendAsIs(fan, overlay);
        return;
    }
    const Color color = ColorOf(fan[0].col);
    if (color.a == 0)
    {
        return;
    }
    assert(!IsSlantedLine(fan) && "a slanted line of Dear ImGui's; draw it with AddStroke");
    std::vector<Vec2> points;
    for (const ImDrawVert& v : fan)
    {
        points.push_back(ToVec2(v.pos));
    }
    if (IsStroke(fan))
    {
        AppendLine(points, fan[0].uv.x == kClosedStroke, double(fan[0].uv.y), color, white,
                   overlay);
    }
    else
    {
        AppendPolygon(points, color, white, overlay);
    }
}

} // namespace

void CopyDrawData(const ImDrawData& data, int width, int height, Overlay& overlay)
{
    overlay.vertices.clear();
    overlay.indices.clear();
    overlay.commands.clear();
    Fan fan;
    for (int i = 0; i < data.CmdListsCount; ++i)
    {
        const ImDrawList& list = *data.CmdLists[i];
        const Vec2 white = ToVec2(list._Data->TexUvWhitePixel);
        for (const ImDrawCmd& command : list.CmdBuffer)
        {
            const auto first = std::uint32_t(overlay.indices.size());
            for (std::size_t at = 0; at < command.ElemCount;)
            {
                at = ReadFan(list, command, at, fan);
                Append(fan, white, overlay);
            }
            const auto count = std::uint32_t(overlay.indices.size()) - first;
            const auto limit = [](float value, int maximum) {
                return int(std::clamp(value, 0.0f, float(maximum)));
            };
            if (count > 0)
            {
                overlay.commands.push_back({first, count, limit(command.ClipRect.x, width),
                                            limit(command.ClipRect.y, height),
                                            limit(command.ClipRect.z, width),
                                            limit(command.ClipRect.w, height)});
            }
        }
    }
}

void AddStroke(ImDrawList& list, std::span<const Vec2> points, bool closed, double width,
               Color color)
{
    if (points.size() < 2)
    {
        return;
    }
    const ImVec2 mark{closed ? kClosedStroke : kOpenStroke, float(width)};
    const ImU32 packed = IM_COL32(color.r, color.g, color.b, color.a);
    const auto count = std::max<std::size_t>(points.size(), 3); // at least a triangle
    list.PrimReserve(int(3 * (count - 2)), int(count));
    const unsigned int first = list._VtxCurrentIdx;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec2 p = points[std::min(i, points.size() - 1)];
        list.PrimWriteVtx({p.x, p.y}, mark, packed);
    }
    for (unsigned int i = 2; i < count; ++i)
    {
        list.PrimWriteIdx(ImDrawIdx(first));
        list.PrimWriteIdx(ImDrawIdx(first + i - 1));
        list.PrimWriteIdx(ImDrawIdx(first + i));
    }
}

void AddBorder(ImDrawList& list, const Rect& rectangle, float rounding, float width, Color color)
{
    const float half = 0.5f * width;
    list.PathRect({rectangle.lower.x + half, rectangle.lower.y + half},
                  {rectangle.upper.x - half, rectangle.upper.y - half},
                  std::max(rounding - half, 0.0f));
    std::vector<Vec2> points;
    for (const ImVec2& p : list._Path)
    {
        points.push_back(ToVec2(p));
    }
    list.PathClear();
    AddStroke(list, points, true, double(width), color);
}

} // namespace boxreel
