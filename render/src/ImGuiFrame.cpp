// SPDX-License-Identifier: MIT
#include "ImGuiFrame.h"

#include "FontAtlas.h"
#include "ImGuiDrawData.h"

#include <imgui_internal.h>

#include <cmath>
#include <mutex>
#include <string>

namespace boxreel
{
namespace
{

// Dear ImGui has one current context per process.
std::mutex g_imgui;

// Sines and cosines differ between versions of the C library. Rounded to these steps they are
// equal, because no value of the table is near the middle between two steps.
constexpr float kArcSteps = 65536.0f;

/// Makes the draw data the same on every processor; see ImGuiDrawData.h.
void DrawPlainly(ImGuiStyle& style, ImDrawListSharedData& shared)
{
    style.AntiAliasedLines = false;
    style.AntiAliasedFill = false;
    // Rounded borders would contain slanted lines; AddBorder draws them instead.
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 0.0f;
    for (ImVec2& point : shared.ArcFastVtx)
    {
        point = {std::round(point.x * kArcSteps) / kArcSteps,
                 std::round(point.y * kArcSteps) / kArcSteps};
    }
}

} // namespace

ImGuiFrame::ImGuiFrame(int width, int height, double scale) : m_width(width), m_height(height)
{
    const std::lock_guard lock(g_imgui);
    // The atlas is shared; Dear ImGui only marks it as in use while a frame is built under the
    // lock.
    m_context = ImGui::CreateContext(FontAtlas::Get(scale).ImGuiAtlas());
    ImGui::SetCurrentContext(m_context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.DisplaySize = {float(width), float(height)};
    io.DeltaTime = 1.0f / 60.0f;
    // The picture must depend on the input only, not on the number of frames.
    io.ConfigInputTextCursorBlink = false;
    DrawPlainly(ImGui::GetStyle(), *ImGui::GetDrawListSharedData());
    ImGui::SetCurrentContext(nullptr);
}

ImGuiFrame::~ImGuiFrame()
{
    const std::lock_guard lock(g_imgui);
    ImGui::DestroyContext(m_context);
}

void ImGuiFrame::With(const std::function<void()>& act)
{
    const std::lock_guard lock(g_imgui);
    ImGui::SetCurrentContext(m_context);
    act();
    ImGui::SetCurrentContext(nullptr);
}

const Overlay& ImGuiFrame::Build(const std::function<void()>& draw)
{
    With([&] {
        ImGui::NewFrame();
        draw();
        ImGui::Render();
        CopyDrawData(*ImGui::GetDrawData(), m_width, m_height, m_overlay);
    });
    return m_overlay;
}

void ImGuiFrame::Resize(int width, int height)
{
    m_width = width;
    m_height = height;
    With([&] { ImGui::GetIO().DisplaySize = {float(width), float(height)}; });
}

Result<void> CheckPanelSize(int width, int height, double scale)
{
    if (width < 1 || width > 8192 || height < 1 || height > 8192)
    {
        return Error{ErrorKind::Unusable,
                     "size " + std::to_string(width) + "x" + std::to_string(height),
                     "width and height must be between 1 and 8192"};
    }
    if (!(scale >= 0.1 && scale <= 16.0))
    {
        return Error{ErrorKind::Unusable, "scale " + std::to_string(scale),
                     "must be between 0.1 and 16"};
    }
    return {};
}

} // namespace boxreel
