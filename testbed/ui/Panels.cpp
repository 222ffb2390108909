// SPDX-License-Identifier: MIT
#include "Panels.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string_view>
#include <utility>

namespace boxreel
{
namespace
{

std::string Text(const char* format, ...)
{
    char text[160];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

/// Returns the x of the second column of check boxes, from the window's side [px].
float SecondColumn()
{
    float widest = 0.0f;
    for (std::size_t i = 0; i < kOptionalLayers.size(); i += 2) // those in the left column
    {
        widest = std::max(widest, Widgets::CheckWidth(kOptionalLayers[i].label));
    }
    return std::ceil(ImGui::GetCursorPosX() + widest + ImGui::GetStyle().ItemSpacing.x);
}

/// Check boxes, two in a row.
class TwoColumns
{
public:
    explicit TwoColumns(Widgets& widgets) : m_widgets(widgets), m_second(SecondColumn()) {}
    void Check(const char* name, bool& value)
    {
        if (m_isSecond)
        {
            ImGui::SameLine(m_second);
        }
        m_widgets.Check(name, value);
        m_isSecond = !m_isSecond;
    }

private:
    Widgets& m_widgets;
    float m_second; // its x
    bool m_isSecond = false;
};

struct KeyHelp
{
    const char* keys;
    const char* effect;
};
constexpr KeyHelp kKeyHelp[] = {
    {"P", "pause, go on"},
    {"O", "a single step"},
    {"R", "restart"},
    {"[  ]", "previous, next scene"},
    {"Ctrl+O", "find a scene"},
    {"Tab", "hide or show the panels"},
    {"Z  X, wheel", "zoom"},
    {"arrows, right drag", "pan"},
    {"Home", "reset the view"},
    {"left drag", "pull a body"},
    {"Space", "throw a bomb"},
    {"Shift+drag", "sling a bomb"},
    {"Ctrl+arrows", "shift the origin"},
    {"Esc", "quit"},
};

// Sections of the column that depend only on their content.

/// The scene's own texts; most scenes have none.
void SceneSection(Widgets& widgets, const PanelFacts& facts)
{
    for (const auto& [name, value] : facts.description)
    {
        widgets.Fact(name.c_str(), value);
    }
    for (const KeyBinding& binding : facts.keys)
    {
        ImGui::Text("%c", binding.key == ' ' ? '_' : binding.key - (binding.key >= 'a' ? 32 : 0));
        ImGui::SameLine(widgets.Px(36.0));
        ImGui::TextDisabled("%s", binding.effect);
    }
}

void SolverSection(Widgets& widgets, PanelChoices& choices)
{
    if (!widgets.Section("Solver", true))
    {
        return;
    }
    SolverChoices& solver = choices.solver;
    for (const SolverSetting& setting : SolverSettings())
    {
        if (const auto* const number = std::get_if<int SolverChoices::*>(&setting.member))
        {
            widgets.Number(setting.label, solver.**number, 1, setting.sliderMaximum);
        }
    }
    widgets.Number("Hertz", solver.hertz, 5, 480);
    if (ImGui::IsItemHovered())
    {
        widgets.Tip("Another rate restarts the scene.");
    }
    TwoColumns columns(widgets);
    for (const SolverSetting& setting : SolverSettings())
    {
        if (const auto* const flag = std::get_if<bool SolverChoices::*>(&setting.member))
        {
            columns.Check(setting.label, solver.**flag);
        }
    }
    widgets.Check("Keep for every scene", choices.keepsSolver);
}

void KeysSection(Widgets& widgets)
{
    if (!widgets.Section("Keys", false))
    {
        return;
    }
    for (const KeyHelp& help : kKeyHelp)
    {
        widgets.Fact(help.keys, help.effect);
    }
}

} // namespace

Panels::Panels(PanelCanvas canvas, int width, int height, double scale)
    : m_canvas(std::move(canvas)), m_widgets(scale), m_width(width), m_height(height)
{}

Result<Panels> Panels::Create(int width, int height, double scale)
{
    Result<PanelCanvas> canvas = PanelCanvas::Create(width, height, scale);
    return canvas ? Result<Panels>(Panels(std::move(*canvas), width, height, scale))
                  : canvas.GetError();
}

void Panels::Resize(int width, int height)
{
    m_width = width;
    m_height = height;
    m_canvas.Resize(width, height);
}

double Panels::Width(const PanelChoices& choices) const
{
    return choices.showsPanels ? std::min(double(m_widgets.Px(kColumnWidth)), double(m_width))
                               : 0.0;
}

/// Discards the observed steps if the scene is another one or has started again.
void Panels::Recognise(const PanelFacts& facts)
{
    if (facts.scene != m_observed || facts.step < m_observedStep)
    {
        m_contacts.Clear();
        m_times.fill(History());
    }
    m_observed = facts.scene;
    m_observedStep = facts.step;
}

void Panels::Observe(const PanelFacts& facts)
{
    Recognise(facts);
    m_contacts.Add(float(facts.contacts));
    for (std::size_t i = 0; facts.times && i < m_times.size(); ++i)
    {
        m_times[i].Add((*facts.times)[i]);
    }
}

PanelAnswer Panels::Build(const PanelFacts& facts, PanelChoices& choices, const PanelInput& input)
{
    m_answer = {};
    Recognise(facts);
    m_widgets.BeginFrame();
    m_picture = m_canvas.Build(input, [&] {
        if (choices.showsPanels)
        {
            Column(facts, choices);
        }
        const int uncovered = m_width - static_cast<int>(Width(choices));
        const std::string chosen = m_picker.Build(
            choices.showsPicker, std::max(uncovered, m_width / 2), m_height, m_widgets);
        m_answer.scene = chosen.empty() ? m_answer.scene : chosen;
    });
    return std::exchange(m_answer, {});
}

void Panels::Column(const PanelFacts& facts, PanelChoices& choices)
{
    const float width = float(Width(choices));
    ImGui::SetNextWindowPos({float(m_width) - width, 0.0f});
    ImGui::SetNextWindowSize({width, float(m_height)});
    if (ImGui::Begin("panels", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoBringToFrontOnFocus |
                         ImGuiWindowFlags_AlwaysVerticalScrollbar))
    {
        ImGui::TextUnformatted(facts.scene.c_str());
        ImGui::SameLine();
        ImGui::TextDisabled(
            "%s",
            Text("%.2f s, step %lld", facts.seconds, static_cast<long long>(facts.step)).c_str());
        Buttons(facts, choices);
        SceneSection(m_widgets, facts);
        ScenesSection(facts);
        SolverSection(m_widgets, choices);
        DrawSection(facts, choices);
        if (choices.statistics)
        {
            StatisticsSection(facts);
        }
        if (choices.profile)
        {
            ProfileSection(facts);
        }
        KeysSection(m_widgets);
    }
    ImGui::End();
}

void Panels::Buttons(const PanelFacts& facts, PanelChoices& choices)
{
    m_widgets.SetPanel("Run");
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
    // The name of the control stays the same while its face changes.
    if (ImGui::Button(choices.isPaused ? "Go on###pause" : "Pause###pause", {third, 0.0f}))
    {
        choices.isPaused = !choices.isPaused;
    }
    m_widgets.Note("Pause");
    ImGui::SameLine();
    if (m_widgets.Button("Step", third))
    {
        Ask(PanelWish::Step);
    }
    ImGui::SameLine();
    if (m_widgets.Button("Restart", third))
    {
        Ask(PanelWish::Restart);
    }
    if (m_widgets.Button("Find scene", third))
    {
        choices.showsPicker = true;
    }
    ImGui::SameLine();
    if (m_widgets.Button("Reset view", third))
    {
        Ask(PanelWish::ResetView);
    }
    ImGui::SameLine();
    if (m_widgets.Button("Bomb", third))
    {
        Ask(PanelWish::Bomb);
    }
    if (facts.isWindow)
    {
        FileButtons(facts, choices);
    }
    ImGui::Spacing();
}

void Panels::FileButtons(const PanelFacts& facts, PanelChoices& choices)
{
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
    const bool isFilming = facts.filmSeconds.has_value();
    if (isFilming)
    {
        ImGui::PushStyleColor(ImGuiCol_Button, {0.72f, 0.16f, 0.16f, 1.0f});
    }
    const std::string face =
        (isFilming ? Text("End %.1f s", *facts.filmSeconds) : std::string("Record")) + "###record";
    if (ImGui::Button(face.c_str(), {third, 0.0f}))
    {
        Ask(PanelWish::Film);
    }
    m_widgets.Note("Record");
    if (isFilming)
    {
        ImGui::PopStyleColor();
    }
    ImGui::SameLine();
    const float sixth = (third - gap) / 2.0f;
    if (m_widgets.Button("SVG", sixth))
    {
        Ask(PanelWish::FigureSvg);
    }
    ImGui::SameLine();
    if (m_widgets.Button("PNG", sixth))
    {
        Ask(PanelWish::FigurePng);
    }
    ImGui::SameLine();
    if (m_widgets.Button("Script", third))
    {
        Ask(PanelWish::Script);
    }
    m_widgets.Check("Panels in films", choices.filmsPanels);
    // Always reserves its space, so the controls below do not move.
    ImGui::BeginChild("message", {0.0f, 3.0f * ImGui::GetTextLineHeight()}, false,
                      ImGuiWindowFlags_NoScrollbar);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextDisabled("%s", facts.message.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    if (ImGui::IsItemHovered() && !facts.message.empty())
    {
        m_widgets.Tip(facts.message);
    }
}

void Panels::ScenesSection(const PanelFacts& facts)
{
    if (!m_widgets.Section("Scenes", false))
    {
        return;
    }
    std::vector<std::string_view> categories; // in the order of the table
    for (const SceneEntry& entry : AllScenes())
    {
        if (std::find(categories.begin(), categories.end(), entry.category) == categories.end())
        {
            categories.emplace_back(entry.category);
        }
    }
    for (const std::string_view category : categories)
    {
        const bool isOpen = ImGui::TreeNode(std::string(category).c_str());
        m_widgets.Note(std::string(category));
        for (const SceneEntry& entry : AllScenes())
        {
            if (isOpen && category == entry.category &&
                m_widgets.Line(entry.name, facts.scene == entry.name))
            {
                m_answer.scene = entry.name;
            }
        }
        if (isOpen)
        {
            ImGui::TreePop();
        }
    }
}

void Panels::DrawSection(const PanelFacts& facts, PanelChoices& choices)
{
    if (!m_widgets.Section("Draw", true))
    {
        return;
    }
    TwoColumns columns(m_widgets);
    for (const LayerInfo& layer : kOptionalLayers)
    {
        columns.Check(layer.label, choices.layers[layer.layer]);
    }
    columns.Check("Numbers", choices.labels);
    columns.Check("Statistics", choices.statistics);
    columns.Check("Profile", choices.profile);
    if (!facts.isWindow)
    {
        return; // a film has one theme
    }
    ImGui::SetNextItemWidth(m_widgets.Px(130.0));
    if (ImGui::BeginCombo("Theme", choices.theme.c_str()))
    {
        for (const std::string_view name : ThemeNames())
        {
            const std::string text(name);
            if (m_widgets.Line(text.c_str(), choices.theme == name))
            {
                choices.theme = text;
            }
        }
        m_widgets.Border(ImGui::GetStyle().PopupRounding);
        ImGui::EndCombo();
    }
    m_widgets.Note("Theme");
}

/// Its line is as long as there are steps, up to the whole width.
void Panels::Plot(const char* name, const History& history)
{
    const auto& values = history.Values();
    const int count = int(history.Count());
    const bool isWhole = history.Count() == History::kLength;
    const float top = std::max(1e-3f, *std::max_element(values.begin(), values.end()));
    const float room = ImGui::GetContentRegionAvail().x;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(
        corner, {corner.x + room, corner.y + m_widgets.Px(44.0)},
        ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
    // Dear ImGui's plot answers to the mouse; its lines are slanted, and drawn below.
    for (const ImGuiCol_ color : {ImGuiCol_FrameBg, ImGuiCol_PlotLines, ImGuiCol_PlotLinesHovered})
    {
        ImGui::PushStyleColor(color, 0);
    }
    ImGui::PlotLines(name, values.data(), count, isWhole ? int(history.Oldest()) : 0, nullptr, 0.0f,
                     1.15f * top,
                     {std::max(m_widgets.Px(16.0), room * float(count) / float(History::kLength)),
                      m_widgets.Px(44.0)});
    ImGui::PopStyleColor(3);
    m_widgets.Note(name + 2); // without the two signs that hide it
    DrawCurve(history, 1.15f * top);
}

/// The values from 0 to `top`, oldest first, inside the last item.
void Panels::DrawCurve(const History& history, float top)
{
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const Vec2 size{high.x - low.x - 2.0f * padding.x, high.y - low.y - 2.0f * padding.y};
    // The middle of the pixel at the lower left: a level line fills a row of pixels.
    const Vec2 zero{low.x + padding.x + 0.5f, high.y - padding.y + 0.5f};
    const std::size_t count = history.Count();
    const std::size_t oldest = count == History::kLength ? history.Oldest() : 0;
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count && count > 1; ++i)
    {
        const float value = history.Values()[(oldest + i) % History::kLength];
        points.push_back(
            {zero.x + size.x * float(i) / float(count - 1), zero.y - size.y * value / top});
    }
    m_widgets.Curve(points);
}

void Panels::StatisticsSection(const PanelFacts& facts)
{
    if (!m_widgets.Section("Statistics", true))
    {
        return;
    }
    m_widgets.Fact("bodies, awake", Text("%d, %d", facts.bodies, facts.awake));
    m_widgets.Fact("joints", Text("%d", facts.joints));
    m_widgets.Fact("proxies", Text("%d", facts.proxies));
    m_widgets.Fact("tree", Text("height %d, balance %d", facts.treeHeight, facts.treeBalance));
    m_widgets.Fact("", Text("quality %.2f", facts.treeQuality));
    m_widgets.Fact("contacts", Text("%d [%.1f] (%.0f)", facts.contacts, double(m_contacts.Mean()),
                                    double(m_contacts.Largest())));
    Plot("##Contacts", m_contacts);
}

void Panels::ProfileSection(const PanelFacts& facts)
{
    if (!m_widgets.Section("Profile", true))
    {
        return;
    }
    if (m_times.front().IsEmpty())
    {
        ImGui::TextDisabled("%s", facts.isWindow ? "no step yet" : "only with --hud-ms");
        return;
    }
    ImGui::TextDisabled("ms of a step: now [average] (most)");
    for (std::size_t i = 0; i < m_times.size(); ++i)
    {
        const History& time = m_times[i];
        m_widgets.Fact(kStageNames[i], Text("%6.3f [%6.3f] (%6.3f)", double(time.Last()),
                                            double(time.Mean()), double(time.Largest())));
    }
    Plot("##Step time", m_times.front());
}

} // namespace boxreel
