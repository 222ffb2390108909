// SPDX-License-Identifier: MIT
#include <render/Overlay.h>

#include "FontAtlas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <mutex>
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
constexpr float kUnderTitle = 9.0f; // room for the line below the title
// The panel's width grows in steps of this, so that it does not jump with every digit of a number.
constexpr float kWidthStep = 24.0f;
constexpr float kMinWidth = 168.0f;

constexpr ImU32 kGround = IM_COL32(12, 14, 18, 190);
constexpr ImU32 kRim = IM_COL32(255, 255, 255, 36);
constexpr ImU32 kTitleInk = IM_COL32(255, 255, 255, 255);
constexpr ImU32 kNameInk = IM_COL32(170, 178, 190, 255);
constexpr ImU32 kValueInk = IM_COL32(240, 242, 245, 255);

// Dear ImGui keeps its current context in one variable of the process.
std::mutex g_imgui;

float Width(std::string_view text)
{
    return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

/// The text, or as much of its beginning as leaves room for three dots.
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
        } while (length > 0 && isInside(length)); // never cut a UTF-8 character in two
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

/// Where things go in the panel [px].
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
    const float most = std::max(1.0f, frame.x - 2.0f * unit * kFrameMargin);
    layout.width = std::min(most, std::max(unit * kMinWidth, step * std::ceil(wanted / step)));
    layout.firstRow = padding + (content.title.empty() ? 0.0f : line + unit * kUnderTitle);
    layout.height = layout.firstRow + float(content.rows.size()) * (line + unit * kLineGap) -
                    unit * kLineGap + padding;
    layout.height = std::clamp(std::floor(layout.height), 1.0f,
                               std::max(1.0f, frame.y - 2.0f * unit * kFrameMargin));
    // In a narrow frame names give way before values, down to half of the width.
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
                                                  {corner.x + right, y + unit}, kRim);
    }
    float y = layout.firstRow;
    for (const auto& [name, value] : content.rows)
    {
        Text({padding, y}, kNameInk, Fitted(name, layout.valueColumn - unit * 4.0f - padding));
        Text({layout.valueColumn, y}, kValueInk, Fitted(value, right - layout.valueColumn));
        y += line + unit * kLineGap;
    }
}

void Copy(const ImDrawData& data, int width, int height, Overlay& overlay)
{
    overlay.vertices.clear();
    overlay.indices.clear();
    overlay.commands.clear();
    for (int i = 0; i < data.CmdListsCount; ++i)
    {
        const ImDrawList& list = *data.CmdLists[i];
        const auto firstVertex = std::uint32_t(overlay.vertices.size());
        for (const ImDrawVert& vertex : list.VtxBuffer)
        {
            const auto channel = [&](int shift) {
                return std::uint8_t(vertex.col >> shift & 0xffu);
            };
            overlay.vertices.push_back({{vertex.pos.x, vertex.pos.y},
                                        {vertex.uv.x, vertex.uv.y},
                                        {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT),
                                         channel(IM_COL32_B_SHIFT), channel(IM_COL32_A_SHIFT)}});
        }
        for (const ImDrawCmd& command : list.CmdBuffer)
        {
            if (command.ElemCount == 0)
            {
                continue;
            }
            const auto firstIndex = std::uint32_t(overlay.indices.size());
            for (unsigned int k = 0; k < command.ElemCount; ++k)
            {
                const ImDrawIdx index = list.IdxBuffer[int(command.IdxOffset + k)];
                overlay.indices.push_back(firstVertex + command.VtxOffset + index);
            }
            const auto limit = [](float value, int most) {
                return int(std::clamp(value, 0.0f, float(most)));
            };
            overlay.commands.push_back(
                {firstIndex, command.ElemCount, limit(command.ClipRect.x, width),
                 limit(command.ClipRect.y, height), limit(command.ClipRect.z, width),
                 limit(command.ClipRect.w, height)});
        }
    }
}

void SetStyle(float unit)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {0.0f, 0.0f};
    style.WindowRounding = unit * 6.0f;
    style.WindowBorderSize = unit;
    style.WindowMinSize = {1.0f, 1.0f};
    style.ItemSpacing = {0.0f, 0.0f};
    style.Colors[ImGuiCol_WindowBg] = ImGui::ColorConvertU32ToFloat4(kGround);
    style.Colors[ImGuiCol_Border] = ImGui::ColorConvertU32ToFloat4(kRim);
}

} // namespace

struct Hud::Impl
{
    Impl(int w, int h, double s) : width(w), height(h), scale(s)
    {
        const std::lock_guard lock(g_imgui);
        // The atlas is shared; Dear ImGui only marks it as in use while a frame is built, under the
        // lock.
        context = ImGui::CreateContext(FontAtlas::Get(scale).ImGuiAtlas());
        ImGui::SetCurrentContext(context);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.LogFilename = nullptr;
        io.DisplaySize = {float(width), float(height)};
        io.DeltaTime = 1.0f / 60.0f;
        SetStyle(float(scale));
        ImGui::SetCurrentContext(nullptr);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl()
    {
        const std::lock_guard lock(g_imgui);
        ImGui::DestroyContext(context);
    }

    int width;
    int height;
    double scale;
    ImGuiContext* context;
    Overlay overlay;
};

Hud::Hud(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
Hud::Hud(Hud&&) noexcept = default;
Hud& Hud::operator=(Hud&&) noexcept = default;
Hud::~Hud() = default;

Result<Hud> Hud::Create(int width, int height, double scale)
{
    if (width < 1 || width > 8192 || height < 1 || height > 8192)
    {
        return Error{ErrorKind::Unusable, "a panel cannot be laid out in a picture of " +
                                              std::to_string(width) + "x" + std::to_string(height) +
                                              " pixels; width and height go from 1 to 8192"};
    }
    if (!(scale >= 0.1 && scale <= 16.0))
    {
        return Error{ErrorKind::Unusable, "a panel cannot be scaled by " + std::to_string(scale) +
                                              "; give a scale from 0.1 to 16"};
    }
    return Hud(std::make_unique<Impl>(width, height, scale));
}

const Overlay& Hud::Build(const HudContent& content)
{
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing;
    const std::lock_guard lock(g_imgui);
    ImGui::SetCurrentContext(m_impl->context);
    ImGui::NewFrame();
    const Layout layout = Arrange(content, ImGui::GetIO().DisplaySize, float(m_impl->scale));
    const float margin = layout.unit * kFrameMargin;
    ImGui::SetNextWindowPos({margin, margin});
    ImGui::SetNextWindowSize({layout.width, layout.height});
    if (ImGui::Begin("hud", nullptr, kFlags))
    {
        Panel(content, layout);
    }
    ImGui::End();
    ImGui::Render();
    Copy(*ImGui::GetDrawData(), m_impl->width, m_impl->height, m_impl->overlay);
    ImGui::SetCurrentContext(nullptr);
    return m_impl->overlay;
}

} // namespace boxreel
