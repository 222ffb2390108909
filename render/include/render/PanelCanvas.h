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
/// Panels that answer to mouse and keyboard, laid out with Dear ImGui and drawn as an Overlay: in a
/// window, or in pictures without one. Same input, same triangles.
namespace boxreel
{

/// What mouse and keyboard do in one frame of the panels.
struct PanelInput
{
    Vec2 pointer{-1.0f, -1.0f};    ///< where the mouse is [px], y down; outside: nowhere
    std::array<bool, 3> buttons{}; ///< that are down: left, right, middle
    float wheel = 0.0f;            ///< notches
    std::string text;              ///< that was typed, UTF-8
    std::vector<Key> keys;         ///< that are down
    bool shift = false;            ///< whether it is down
    bool control = false;          ///< whether it is down
    double seconds = 1.0 / 60.0;   ///< since the frame before
};

/// Panels of Dear ImGui as an overlay.
class PanelCanvas
{
public:
    /// `width`, `height`: of the picture, 1 to 8192 [px]; `scale`: how much larger than usual
    /// letters and distances are, 0.1 to 16, the renderer's. An Error (Unusable) for a size or a
    /// scale out of range.
    static Result<PanelCanvas> Create(int width, int height, double scale = 1.0);
    /// The other may only be assigned to or destroyed.
    PanelCanvas(PanelCanvas&&) noexcept;
    /// The other may only be assigned to or destroyed.
    PanelCanvas& operator=(PanelCanvas&&) noexcept;
    ~PanelCanvas();

    /// `draw` calls Dear ImGui. Valid until the next call. A click takes three frames: the mouse
    /// is there, its button goes down, and up.
    const Overlay& Build(const PanelInput& input, const std::function<void()>& draw);

    /// True if the key went down in this frame, or repeats. For `draw` alone.
    static bool IsPressed(Key key);

    /// 1 to 8192 [px].
    void Resize(int width, int height);

    /// Whether what the mouse does is meant for a panel, as of the last frame; likewise keys.
    bool WantsPointer() const;
    /// Whether keys are meant for a panel, as of the last frame.
    bool WantsKeys() const;

private:
    struct Impl;
    explicit PanelCanvas(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
