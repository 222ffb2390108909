// SPDX-License-Identifier: MIT
#include "ScenePicker.h"

#include "Fuzzy.h"

#include <render/PanelCanvas.h>
#include <scenes/Scene.h>

#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace boxreel
{
namespace
{

constexpr std::size_t kMaxLines = 12;

std::vector<const SceneEntry*> Matching(const char* query)
{
    std::vector<std::string_view> names;
    for (const SceneEntry& entry : AllScenes())
    {
        names.emplace_back(entry.name);
    }
    std::vector<const SceneEntry*> found;
    for (const std::size_t place : FindFuzzily(query, names))
    {
        found.push_back(&AllScenes()[place]);
    }
    found.resize(std::min(found.size(), kMaxLines));
    return found;
}

/// The name with the letters that were typed in another colour.
void WriteName(const char* query, const char* name)
{
    const FuzzyMatch match = MatchFuzzily(query, name).value_or(FuzzyMatch{});
    const std::size_t length = std::strlen(name);
    const ImVec4 plain = ImGui::GetStyleColorVec4(ImGuiCol_Text);
    const ImVec4 found = ImGui::GetStyleColorVec4(ImGuiCol_CheckMark);
    const auto isFound = [&](std::size_t at) {
        return std::binary_search(match.letters.begin(), match.letters.end(), at);
    };
    for (std::size_t at = 0; at < length;)
    {
        std::size_t end = at + 1;
        while (end < length && isFound(end) == isFound(at))
        {
            ++end;
        }
        ImGui::PushStyleColor(ImGuiCol_Text, isFound(at) ? found : plain);
        ImGui::TextUnformatted(name + at, name + end);
        ImGui::PopStyleColor();
        ImGui::SameLine(0.0f, 0.0f);
        at = end;
    }
}

} // namespace

std::string ScenePicker::Build(bool& isOpen, int width, int height, Widgets& widgets)
{
    if (!isOpen)
    {
        m_wasOpen = false;
        return {};
    }
    const float wide = std::min(float(width) - widgets.Px(20.0), widgets.Px(460.0));
    ImGui::SetNextWindowPos({0.5f * (float(width) - wide), 0.12f * float(height)});
    ImGui::SetNextWindowSize({wide, 0.0f});
    if (!m_wasOpen)
    {
        ImGui::SetNextWindowFocus();
    }
    std::string chosen;
    const float rounding = widgets.Px(6.0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
    if (ImGui::Begin("picker", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings))
    {
        chosen = Choose(isOpen, widgets);
        widgets.Border(rounding);
    }
    ImGui::End();
    ImGui::PopStyleVar();
    m_wasOpen = isOpen;
    return chosen;
}

std::string ScenePicker::Choose(bool& isOpen, Widgets& widgets)
{
    widgets.SetPanel("Picker");
    if (!m_wasOpen)
    {
        m_query[0] = '\0';
        m_chosen = 0;
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1.0f);
    // The arrows are the list's; Dear ImGui would let a line of text move its cursor.
    const bool isEntered =
        ImGui::InputTextWithHint("##query", "Find a scene by a few letters", m_query,
                                 sizeof m_query, ImGuiInputTextFlags_EnterReturnsTrue);
    const bool isEdited = ImGui::IsItemEdited();
    widgets.Note("Query");
    const std::vector<const SceneEntry*> found = Matching(m_query);
    m_chosen = isEdited ? 0 : m_chosen;
    m_chosen += PanelCanvas::IsPressed(Key::Down) ? 1 : 0;
    m_chosen -= PanelCanvas::IsPressed(Key::Up) ? 1 : 0;
    m_chosen = std::clamp(m_chosen, 0, std::max(0, int(found.size()) - 1));
    std::string chosen;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
        ImGui::PushID(int(i));
        const ImVec2 start = ImGui::GetCursorPos();
        const bool isPicked = ImGui::Selectable("##line", int(i) == m_chosen);
        widgets.Note(found[i]->name);
        const ImVec2 next = ImGui::GetCursorPos();
        ImGui::SetCursorPos({start.x + widgets.Px(4.0), start.y});
        WriteName(m_query, found[i]->name);
        ImGui::SetCursorPos({widgets.Px(280.0), start.y});
        ImGui::TextDisabled("%s", found[i]->category);
        ImGui::SetCursorPos(next);
        ImGui::PopID();
        if (isPicked || (isEntered && int(i) == m_chosen))
        {
            chosen = found[i]->name;
        }
    }
    if (found.empty())
    {
        ImGui::TextDisabled("No scene has these letters in this order.");
    }
    ImGui::Dummy({0.0f, 0.0f});
    const bool isLeft = PanelCanvas::IsPressed(Key::Escape) ||
                        (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && m_wasOpen &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows |
                                                 ImGuiHoveredFlags_AllowWhenBlockedByActiveItem));
    isOpen = chosen.empty() && !isLeft;
    return chosen;
}

} // namespace boxreel
