// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawList.h>
#include <render/Keys.h>
#include <render/Overlay.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// @file
/// Panels with mouse and keyboard input, created with Dear ImGui and drawn as an Overlay in a
/// window or a frame. Same input, same triangles.
namespace boxreel
{

/// Mouse and keyboard input of one frame.
struct PanelInput
{
    Vec2 pointer{-1.0f, -1.0f};    ///< position of the mouse [px], y down; negative: outside
    std::array<bool, 3> buttons{}; ///< true if pressed: left, right, middle
    float wheel = 0.0f;            ///< notches
    std::string text;              ///< typed text, UTF-8
    std::vector<Key> keys;         ///< pressed keys
    bool shift = false;            ///< true if pressed
    bool control = false;          ///< true if pressed
    double seconds = 1.0 / 60.0;   ///< time since the last frame
};

/// Panels of Dear ImGui as an overlay.
class PanelCanvas
{
public:
    /// Creates a canvas. `width`, `height`: size of the picture, 1 to 8192 [px]. `scale`: factor of
    /// text and distances, 0.1 to 16, as in the renderer. An Error (Unusable) for a value out of
    /// range.
    static Result<PanelCanvas> Create(int width, int height, double scale = 1.0);
    /// Leaves the source in a moved-from state.
    PanelCanvas(PanelCanvas&&) noexcept;
    /// Leaves the source in a moved-from state.
    PanelCanvas& operator=(PanelCanvas&&) noexcept;
    ~PanelCanvas();

    /// Calls `draw`, which calls Dear ImGui, and returns the triangles, valid until the next call.
    /// A click takes three frames: move the mouse, press the button, release it.
    const Overlay& Build(const PanelInput& input, const std::function<void()>& draw);

    /// True if the key was pressed in this frame or repeats. Call it from `draw` only.
    static bool IsPressed(Key key);

    /// Changes the size of the picture, 1 to 8192 [px].
    void Resize(int width, int height);

    /// True if a panel uses the mouse, as of the last frame.
    bool WantsPointer() const;
    /// True if a panel uses the keyboard, as of the last frame.
    bool WantsKeys() const;

private:
    struct Impl;
    explicit PanelCanvas(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
