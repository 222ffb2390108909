// SPDX-License-Identifier: MIT
#pragma once

#include <render/PanelCanvas.h>

#include <imgui.h>

/// Passes mouse and keyboard to Dear ImGui. Its interface for keys changed with version 1.87: only
/// ImGuiInput.cpp knows both. For ImGuiPanels.cpp alone.
namespace boxreel
{

/// Sets up a new context. Call it before the first frame.
void PrepareInput(ImGuiIO& io);

/// Passes what is down in the next frame. All of it reaches that frame.
void PassInput(const PanelInput& input, ImGuiIO& io);

/// True if the key went down in this frame of the current context, or repeats.
bool IsKeyPressed(Key key);

} // namespace boxreel
