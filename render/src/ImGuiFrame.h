// SPDX-License-Identifier: MIT
#pragma once

#include <render/Overlay.h>

#include <imgui.h>

#include <functional>

/// A Dear ImGui context with the toolkit's font, and its draw data as an Overlay. For ImGui*.cpp
/// only.
namespace boxreel
{

class ImGuiFrame
{
public:
    /// `width`, `height`: of the picture [px]; `scale`: of the text.
    ImGuiFrame(int width, int height, double scale);
    ~ImGuiFrame();
    ImGuiFrame(const ImGuiFrame&) = delete;
    ImGuiFrame& operator=(const ImGuiFrame&) = delete;

    /// Calls `act` with the context current in this thread.
    void With(const std::function<void()>& act);

    /// Builds a frame from the Dear ImGui calls in `draw`. The overlay is valid until the next
    /// call.
    const Overlay& Build(const std::function<void()>& draw);

    /// The size must pass CheckPanelSize.
    void Resize(int width, int height);

private:
    int m_width;
    int m_height;
    ImGuiContext* m_context;
    Overlay m_overlay;
};

/// Returns an Error (Unusable) for a size or scale out of range.
Result<void> CheckPanelSize(int width, int height, double scale);

} // namespace boxreel
