// SPDX-License-Identifier: MIT
#include "ImGuiFrame.h"

#include <base/ErrorMacros.h>
#include <render/PanelStroke.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace boxreel
{
namespace
{

// All lengths in pixels, at scale 1.
constexpr float kFrameMargin = 10.0f; // between the panel and the frame's edges
constexpr float kPadding = 10.0f;     // between the panel's edge and its text
constexpr float kColumnGap = 16.0f;
constexpr float kLineGap = 3.0f;
constexpr float kUnderTitle = 9.0f; // space for the line below the title
// The panel's width is a multiple of this, so that it does not change with every digit of a number.
constexpr float kWidthStep = 24.0f;
constexpr float kMinWidth = 168.0f;
constexpr float kRounding = 6.0f; // of the panel's corners

constexpr ImU32 kGround = IM_COL32(12, 14, 18, 190);
constexpr Color kRim{255, 255, 255, 36};
constexpr ImU32 kTitleInk = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kNameInk = IM_COL32(170, 178, 190, 255);
constexpr ImU32 kValueInk = IM_COL32(240, 242, 245, 255);

float Width(std::string_view text)
{
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

/// Returns the text, or its start followed by three dots, to fit the width.
std::string Fitted(const std::string& text, float room)
{
    if (Width(text) <= room)
    {
        return text;
    }
    std::size_t length = text.size();
    const auto isInside = [&](std::size_t at) {
        return (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u;
    };
    while (length > 0)
    {
        do
        {
            --length;
        } while (length > 0 && isInside(length)); // never split a UTF-8 character
        const std::string shorter = text.substr(0, length) + "…";
        if (Width(shorter) <= room)
        {
            return shorter;
        }
    }
    return {};
}

void Text(ImVec2 at, ImU32 ink, const std::string& text)
{
    ImGui::SetCursorPos(at);
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

/// Layout of the panel [px].
struct Layout
{
    float unit = 1.0f; ///< the scale
    float width = 0.0f;
    float height = 0.0f;
    float firstRow = 0.0f;
    float valueColumn = 0.0f;
};

Layout Arrange(const HudContent& content, ImVec2 frame, float unit)
{
    float names = 0.0f;
    float values = 0.0f;
    for (const auto& [name, value] : content.rows)
    {
        names = std::max(names, Width(name));
        values = std::max(values, Width(value));
    }
    const float gap = names > 0.0f ? unit * kColumnGap : 0.0f;
    const float line = ImGui::GetFontSize();
    const float padding = unit * kPadding;
    const float step = unit * kWidthStep;
    Layout layout;
    layout.unit = unit;
    const float wanted = 2.0f * padding + std::max(Width(content.title), names + gap + values);
    const float maximum = std::max(1.0f, frame.x - 2.0f * unit * kFrameMargin);
    layout.width = std::min(maximum, std::max(unit * kMinWidth, step * std::ceil(wanted / step)));
    layout.firstRow = padding + (content.title.empty() ? 0.0f : line + unit * kUnderTitle);
    layout.height = layout.firstRow + float(content.rows.size()) * (line + unit * kLineGap) -
                    unit * kLineGap + padding;
    layout.height = std::clamp(std::floor(layout.height), 1.0f,
                               std::max(1.0f, frame.y - 2.0f * unit * kFrameMargin));
    // In a narrow frame names are shortened before values, down to half of the width.
    const float inner = layout.width - 2.0f * padding;
    layout.valueColumn =
        padding + std::floor(std::min(names + gap, std::max(0.5f * inner, inner - values)));
    return layout;
}

void Panel(const HudContent& content, const Layout& layout)
{
    const float line = ImGui::GetFontSize();
    const float unit = layout.unit;
    const float padding = unit * kPadding;
    const float right = layout.width - padding;
    if (!content.title.empty())
    {
        Text({padding, padding}, kTitleInk, Fitted(content.title, right - padding));
        const ImVec2 corner = ImGui::GetWindowPos();
        const float y = corner.y + padding + line + unit * 4.0f;
        ImGui::GetWindowDrawList()->AddRectFilled({corner.x + padding, y},
                                                  {corner.x + right, y + unit},
                                                  IM_COL32(kRim.r, kRim.g, kRim.b, kRim.a));
    }
    float y = layout.firstRow;
    for (const auto& [name, value] : content.rows)
    {
        Text({padding, y}, kNameInk, Fitted(name, layout.valueColumn - unit * 4.0f - padding));
        Text({layout.valueColumn, y}, kValueInk, Fitted(value, right - layout.valueColumn));
        y += line + unit * kLineGap;
    }
}

void Border(float unit)
{
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    const Vec2 high{low.x + size.x, low.y + size.y};
    AddBorder(*ImGui::GetWindowDrawList(), {{low.x, low.y}, high}, unit * kRounding, unit, kRim);
}

void SetStyle(float unit)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {0.0f, 0.0f};
    style.WindowRounding = unit * kRounding;
    style.WindowMinSize = {1.0f, 1.0f};
    style.ItemSpacing = {0.0f, 0.0f};
    style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(kGround);
}

} // namespace

struct Hud::Impl
{
    Impl(int width, int height, double s) : scale(s), frame(width, height, s)
    {
        frame.With([s] { SetStyle(float(s)); });
    }

    double scale;
    ImGuiFrame frame;
};

Hud::Hud(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Hud::Hud(Hud&&) noexcept = default;
Hud& Hud::operator=(Hud&&) noexcept = default;
Hud::~Hud() = default;

Result<Hud> Hud::Create(int width, int height, double scale)
{
    RETURN_IF_ERROR(CheckPanelSize(width, height, scale));
    return Hud(std::make_unique<Impl>(width, height, scale));
}

const Overlay& Hud::Build(const HudContent& content)
{
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;
    return m_impl->frame.Build([&] {
        const Layout layout = Arrange(content, ImGui::GetIO().DisplaySize, float(m_impl->scale));
        const float margin = layout.unit * kFrameMargin;
        ImGui::SetNextWindowPos({margin, margin});
        ImGui::SetNextWindowSize({layout.width, layout.height});
        if (ImGui::Begin("hud", nullptr, kFlags))
        {
            Panel(content, layout);
            Border(layout.unit);
        }
        ImGui::End();
    });
}

} // namespace boxreel
