// SPDX-License-Identifier: MIT
#include <render/PanelCanvas.h>

#include "ImGuiFrame.h"
#include "ImGuiInput.h"

#include <utility>

namespace boxreel
{
namespace
{

ImVec4 Ink(int red, int green, int blue, float alpha)
{
    return {float(red) / 255.0f, float(green) / 255.0f, float(blue) / 255.0f, alpha};
}

/// Dark and muted colours, so that the picture stands out.
void SetColors(ImGuiStyle& style)
{
    const auto set = [&](ImGuiCol color, const ImVec4& ink) { style.Colors[color] = ink; };
    const ImVec4 accent = Ink(64, 132, 198, 1.0f);
    set(ImGuiCol_Text, Ink(232, 235, 240, 1.0f));
#if IMGUI_VERSION_NUM >= 19200 // had the colour of the text before
    set(ImGuiCol_InputTextCursor, Ink(232, 235, 240, 1.0f));
#endif
    set(ImGuiCol_TextDisabled, Ink(142, 150, 162, 1.0f));
    set(ImGuiCol_WindowBg, Ink(20, 22, 27, 0.94f));
    set(ImGuiCol_PopupBg, Ink(26, 29, 35, 0.98f));
    set(ImGuiCol_Border, Ink(255, 255, 255, 0.12f));
    set(ImGuiCol_FrameBg, Ink(48, 53, 62, 1.0f));
    set(ImGuiCol_FrameBgHovered, Ink(60, 67, 79, 1.0f));
    set(ImGuiCol_FrameBgActive, Ink(70, 79, 94, 1.0f));
    set(ImGuiCol_CheckMark, Ink(120, 190, 255, 1.0f));
    set(ImGuiCol_SliderGrab, accent);
    set(ImGuiCol_SliderGrabActive, Ink(104, 172, 238, 1.0f));
    set(ImGuiCol_Button, Ink(52, 59, 70, 1.0f));
    set(ImGuiCol_ButtonHovered, Ink(68, 78, 94, 1.0f));
    set(ImGuiCol_ButtonActive, accent);
    set(ImGuiCol_Header, Ink(42, 47, 56, 1.0f));
    set(ImGuiCol_HeaderHovered, Ink(58, 66, 79, 1.0f));
    set(ImGuiCol_HeaderActive, accent);
    set(ImGuiCol_Separator, Ink(255, 255, 255, 0.10f));
    set(ImGuiCol_ScrollbarBg, Ink(0, 0, 0, 0.0f));
    set(ImGuiCol_ScrollbarGrab, Ink(70, 77, 90, 1.0f));
    set(ImGuiCol_PlotLines, Ink(120, 190, 255, 1.0f));
    set(ImGuiCol_TextSelectedBg, Ink(64, 132, 198, 0.5f));
}

void SetStyle(float scale)
{
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowPadding = {10.0f, 10.0f};
    style.WindowRounding = 0.0f;
    style.WindowBorderSize = 0.0f;
    style.FramePadding = {6.0f, 3.0f};
    style.FrameRounding = 3.0f;
    style.ItemSpacing = {6.0f, 4.0f};
    style.ItemInnerSpacing = {6.0f, 4.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 11.0f;
    style.ScrollbarRounding = 5.0f;
    style.GrabMinSize = 9.0f;
    style.GrabRounding = 3.0f;
    style.PopupRounding = 5.0f;
    style.ScaleAllSizes(scale);
    SetColors(style);
}

} // namespace

struct PanelCanvas::Impl
{
    Impl(int width, int height, double scale) : frame(width, height, scale)
    {
        frame.With([scale] {
            SetStyle(float(scale));
            PrepareInput(ImGui::GetIO());
        });
    }

    ImGuiFrame frame;
    bool wantsPointer = false;
    bool wantsKeys = false;
};

PanelCanvas::PanelCanvas(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}
PanelCanvas::PanelCanvas(PanelCanvas&&) noexcept = default;
PanelCanvas& PanelCanvas::operator=(PanelCanvas&&) noexcept = default;
PanelCanvas::~PanelCanvas() = default;

Result<PanelCanvas> PanelCanvas::Create(int width, int height, double scale)
{
    const Result<void> usable = CheckPanelSize(width, height, scale);
    return usable ? Result<PanelCanvas>(PanelCanvas(std::make_unique<Impl>(width, height, scale)))
                  : usable.GetError();
}

const Overlay& PanelCanvas::Build(const PanelInput& input, const std::function<void()>& draw)
{
    m_impl->frame.With([&] { PassInput(input, ImGui::GetIO()); });
    const Overlay& overlay = m_impl->frame.Build(draw);
    m_impl->frame.With([&] {
        m_impl->wantsPointer = ImGui::GetIO().WantCaptureMouse;
        m_impl->wantsKeys = ImGui::GetIO().WantTextInput;
    });
    return overlay;
}

void PanelCanvas::Resize(int width, int height)
{
    m_impl->frame.Resize(width, height);
}

bool PanelCanvas::IsPressed(Key key)
{
    return IsKeyPressed(key);
}

bool PanelCanvas::WantsPointer() const
{
    return m_impl->wantsPointer;
}

bool PanelCanvas::WantsKeys() const
{
    return m_impl->wantsKeys;
}

} // namespace boxreel
