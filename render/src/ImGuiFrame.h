// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

#include <imgui.h>

#include <functional>

/// A context of Dear ImGui's with the toolkit's font, and its draw data as an Overlay. For
/// ImGui*.cpp alone.
namespace boxreel
{

class ImGuiFrame
{
public:
    /// `width`, `height`: of the picture [px]; `scale`: of the letters.
    ImGuiFrame(int width, int height, double scale);
    ~ImGuiFrame();
    ImGuiFrame(const ImGuiFrame&) = delete;
    ImGuiFrame& operator=(const ImGuiFrame&) = delete;

    /// Does something to the context, which belongs to this thread meanwhile.
    void With(const std::function<void()>& act);

    /// A frame of what `draw` asks of Dear ImGui. The overlay stays valid until the next one.
    const Overlay& Build(const std::function<void()>& draw);

    /// The size must be one that CheckPanelSize has nothing against.
    void Resize(int width, int height);

private:
    int m_width;
    int m_height;
    ImGuiContext* m_context;
    Overlay m_overlay;
};

/// Unusable for a picture of no such size or scale.
Result<void> CheckPanelSize(int width, int height, double scale);

} // namespace boxreel
