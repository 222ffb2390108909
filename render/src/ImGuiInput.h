// SPDX-License-Identifier: MIT
#pragma once

#include <render/PanelCanvas.h>

#include <imgui.h>

/// Passes mouse and keyboard input to Dear ImGui. Its key interface changed with version 1.87: only
/// ImGuiInput.cpp handles both. For ImGuiPanels.cpp only.
namespace boxreel
{

/// Sets up a new context. Call it before the first frame.
void PrepareInput(ImGuiIO& io);

/// Passes the state of buttons and keys to the next frame, all of it in that frame.
void PassInput(const PanelInput& input, ImGuiIO& io);

/// True if the key was pressed in this frame of the current context, or repeats.
bool IsKeyPressed(Key key);

} // namespace boxreel
