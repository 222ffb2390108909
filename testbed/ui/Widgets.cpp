// SPDX-License-Identifier: MIT
#include "Widgets.h"

#include <imgui.h>
#include <imgui_internal.h>
#include <render/PanelStroke.h>

#include <algorithm>
#include <array>
#include <utility>

namespace boxreel
{
namespace
{

Color StyleColor(ImGuiCol_ which)
{
    const ImU32 packed = ImGui::GetColorU32(which);
    const auto channel = [&](int shift) { return std::uint8_t(packed >> shift & 0xffu); };
    return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT),
            channel(IM_COL32_A_SHIFT)};
}

/// In the box at the left end of the last item.
void DrawTick()
{
    const ImVec2 low = ImGui::GetItemRectMin();
    const float side = ImGui::GetFrameHeight();
    const auto place = [&](float x, float y) { return Vec2{low.x + x * side, low.y + y * side}; };
    const std::array tick{place(0.18f, 0.53f), place(0.40f, 0.75f), place(0.83f, 0.32f)};
    AddStroke(*ImGui::GetWindowDrawList(), tick, false, double(side) * 0.14,
              StyleColor(ImGuiCol_CheckMark));
}

/// Draws a header as wide as the content below it. Dear ImGui draws it wider by half the window's
/// padding, rounded differently since 1.92. Half of 1 px is 0 in both versions.
bool Header(const char* name, bool opensFirst)
{
    float& padding = ImGui::GetCurrentWindow()->WindowPadding.x;
    const float usual = std::exchange(padding, 1.0f);
    const bool isOpen = ImGui::CollapsingHeader(name, opensFirst ? ImGuiTreeNodeFlags_DefaultOpen
                                                                 : ImGuiTreeNodeFlags_None);
    padding = usual;
    return isOpen;
}

} // namespace

void Widgets::BeginFrame()
{
    m_places.clear();
    m_panel.clear();
    m_opening = std::exchange(m_toOpen, std::nullopt);
}

void Widgets::Note(const std::string& name)
{
    const std::string full = m_panel + "/" + name;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float middle = 0.5f * (low.y + high.y);
    // An item that is scrolled out of its window is not there for the mouse.
    const float top = ImGui::GetWindowPos().y;
    const bool isSeen =
        ImGui::IsItemVisible() && middle >= top && middle < top + ImGui::GetWindowSize().y;
    m_places[full] =
        isSeen ? std::optional(ControlPlace{{low.x, low.y}, {high.x, high.y}}) : std::nullopt;
    if (IsRevealed(full) && !isSeen)
    {
        ImGui::SetScrollHereY(0.5f);
    }
}

std::optional<ControlPlace> Widgets::PlaceOf(const std::string& name) const
{
    const auto found = m_places.find(name);
    return found == m_places.end() ? std::nullopt : found->second;
}

std::optional<Vec2> Widgets::Find(const std::string& name) const
{
    const std::optional<ControlPlace> place = PlaceOf(name);
    return place ? std::optional(Vec2{0.5f * (place->low.x + place->high.x),
                                      0.5f * (place->low.y + place->high.y)})
                 : std::nullopt;
}

std::vector<std::string> Widgets::Names() const
{
    std::vector<std::string> names;
    for (const auto& [name, place] : m_places)
    {
        names.push_back(name);
    }
    return names;
}

bool Widgets::Section(const char* name, bool opensFirst)
{
    m_panel = name;
    const std::string inside = m_panel + "/";
    const bool isRevealed = m_revealed && m_revealed->starts_with(inside);
    if (isRevealed || m_opening)
    {
        ImGui::SetNextItemOpen(isRevealed || m_opening->contains(name));
    }
    const bool isOpen = Header(name, opensFirst);
    m_panel = "Panels";
    Note(name);
    m_panel = name;
    isOpen ? (void)m_open.insert(name) : (void)m_open.erase(name);
    return isOpen;
}

bool Widgets::Button(const char* name, float width)
{
    const bool isPressed = ImGui::Button(name, {width, 0.0f});
    Note(name);
    return isPressed;
}

bool Widgets::Check(const char* name, bool& value)
{
    ImGui::PushStyleColor(ImGuiCol_CheckMark, 0); // slanted lines; DrawTick draws them
    const bool hasChanged = ImGui::Checkbox(name, &value);
    ImGui::PopStyleColor();
    if (value)
    {
        DrawTick();
    }
    Note(name);
    return hasChanged;
}

float Widgets::CheckWidth(const char* name)
{
    return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
           ImGui::CalcTextSize(name).x;
}

bool Widgets::Number(const char* name, int& value, int lowest, int highest)
{
    const int before = value;
    ImGui::PushID(name);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    const float side = ImGui::GetFrameHeight();
    const float gap = Px(2.0);
    ImGui::SameLine(Px(140.0));
    ImGui::SetNextItemWidth(
        std::max(Px(40.0), ImGui::GetContentRegionAvail().x - 2.0f * (side + gap)));
    ImGui::SliderInt("##value", &value, lowest, highest, "%d", ImGuiSliderFlags_AlwaysClamp);
    Note(name);
    ImGui::SameLine(0.0f, gap);
    value -= ImGui::Button("-", {side, 0.0f}) ? 1 : 0;
    Note(std::string(name) + "/less");
    ImGui::SameLine(0.0f, gap);
    value += ImGui::Button("+", {side, 0.0f}) ? 1 : 0;
    Note(std::string(name) + "/more");
    ImGui::PopID();
    value = std::clamp(value, lowest, highest);
    return value != before;
}

void Widgets::Curve(std::span<const Vec2> points)
{
    AddStroke(*ImGui::GetWindowDrawList(), points, false, 1.0, StyleColor(ImGuiCol_PlotLines));
}

void Widgets::Border(float rounding)
{
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const Vec2 high{low.x + size.x, low.y + size.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    AddBorder(list, {{low.x, low.y}, high}, rounding, Px(1.0), StyleColor(ImGuiCol_Border));
    list.PopClipRect();
}

void Widgets::Tip(const std::string& text)
{
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(text.c_str());
    Border(ImGui::GetStyle().WindowRounding);
    ImGui::EndTooltip();
}

bool Widgets::Line(const char* name, bool isChosen)
{
    const bool isPicked = ImGui::Selectable(name, isChosen);
    Note(name);
    return isPicked;
}

void Widgets::Fact(const char* name, const std::string& value)
{
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(Px(140.0));
    ImGui::TextUnformatted(value.c_str());
}

} // namespace boxreel
