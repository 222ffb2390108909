// SPDX-License-Identifier: MIT
#include "ImGuiInput.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace boxreel
{
namespace
{

constexpr std::pair<decltype(ImGuiKey_Tab), Key> kKeys[] = {{ImGuiKey_Tab, Key::Tab},
                                                            {ImGuiKey_LeftArrow, Key::Left},
                                                            {ImGuiKey_RightArrow, Key::Right},
                                                            {ImGuiKey_UpArrow, Key::Up},
                                                            {ImGuiKey_DownArrow, Key::Down},
                                                            {ImGuiKey_PageUp, Key::PageUp},
                                                            {ImGuiKey_PageDown, Key::PageDown},
                                                            {ImGuiKey_Home, Key::Home},
                                                            {ImGuiKey_End, Key::End},
                                                            {ImGuiKey_Delete, Key::Delete},
                                                            {ImGuiKey_Backspace, Key::Backspace},
                                                            {ImGuiKey_Space, Key::Space},
                                                            {ImGuiKey_Enter, Key::Enter},
                                                            {ImGuiKey_Escape, Key::Escape},
                                                            {ImGuiKey_A, KeyOf('a')},
                                                            {ImGuiKey_C, KeyOf('c')},
                                                            {ImGuiKey_V, KeyOf('v')},
                                                            {ImGuiKey_X, KeyOf('x')},
                                                            {ImGuiKey_Y, KeyOf('y')},
                                                            {ImGuiKey_Z, KeyOf('z')}};

#if IMGUI_VERSION_NUM >= 18700 // keys as events

void PrepareKeys(ImGuiIO& io)
{
    // Otherwise Dear ImGui distributes the events of one frame over several.
    io.ConfigInputTrickleEventQueue = false;
}

void PassKeys(const PanelInput& input, ImGuiIO& io)
{
    for (const auto& [theirs, ours] : kKeys)
    {
        const bool isDown = std::ranges::find(input.keys, ours) != input.keys.end();
        io.AddKeyEvent(theirs, isDown);
    }
    io.AddKeyEvent(ImGuiMod_Shift, input.shift);
    io.AddKeyEvent(ImGuiMod_Ctrl, input.control);
}

bool IsPressed(decltype(ImGuiKey_Tab) key)
{
    return ImGui::IsKeyPressed(key);
}

#else // keys as an array, with indices of the caller's choice

static_assert(kKeyCount <= 512, "Dear ImGui has room for so many keys");

void PrepareKeys(ImGuiIO& io)
{
    for (const auto& [theirs, ours] : kKeys)
    {
        io.KeyMap[theirs] = static_cast<int>(ours);
    }
}

void PassKeys(const PanelInput& input, ImGuiIO& io)
{
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    for (const Key key : input.keys)
    {
        io.KeysDown[static_cast<int>(key)] = true;
    }
    io.KeyShift = input.shift;
    io.KeyCtrl = input.control;
}

bool IsPressed(decltype(ImGuiKey_Tab) key)
{
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

#endif

} // namespace

void PrepareInput(ImGuiIO& io)
{
    PrepareKeys(io);
}

void PassInput(const PanelInput& input, ImGuiIO& io)
{
    io.MousePos = {input.pointer.x, input.pointer.y};
    std::copy(input.buttons.begin(), input.buttons.end(), io.MouseDown);
    io.MouseWheel = input.wheel;
    PassKeys(input, io);
    io.AddInputCharactersUTF8(input.text.c_str());
    io.DeltaTime = std::clamp(float(input.seconds), 1.0f / 1000.0f, 1.0f);
}

bool IsKeyPressed(Key key)
{
    const auto* const found =
        std::ranges::find(kKeys, key, &std::pair<decltype(ImGuiKey_Tab), Key>::second);
    return found != std::end(kKeys) && IsPressed(found->first);
}

} // namespace boxreel
