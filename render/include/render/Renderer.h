// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>
#include <render/Backend.h>
#include <render/Frame.h>
#include <render/Overlay.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

/// @file
/// Turns a DrawList into pixels, off-screen. Owns the GL context, so use one per thread. Draws only
/// what is in the list; it does not know worlds. Create loads the GL library.
namespace boxreel
{

class Window;

/// Options of a renderer.
struct RendererSettings
{
    int width = 1280;                ///< width of the picture, 1 to 8192 [px]
    int height = 720;                ///< height of the picture, 1 to 8192 [px]
    Theme theme = Theme::Classic();  ///< colours and widths
    Backend backend = Backend::Auto; ///< library that draws
    double scale = 1.0; ///< factor of all lengths in pixels: outlines, points, text; 0.1 to 16.
                        ///< Camera and overlay are given in scaled pixels.
    bool redrawsWhole = false; ///< redraws every changed frame completely, for tests and
                               ///< measurements; the bits are the same
};

/// Statistics of the last Submit. Items of the list are outside, drawn, or in an area that did not
/// change.
struct RenderStatistics
{
    std::size_t items = 0;        ///< in the list
    std::size_t itemsDrawn = 0;   ///< with at least a part
    std::size_t itemsOutside = 0; ///< outside the picture, or with coordinates that are not finite
    std::size_t itemsReused = 0;  ///< with vertices reused from the last Submit, drawn or not
    std::size_t drawCalls = 0;    ///< without the overlay
    std::size_t rectangles = 0;   ///< redrawn; one if it was the whole picture
    std::int64_t pixels = 0;      ///< in the redrawn rectangles
    bool unchanged = false;       ///< identical to the last frame: nothing was drawn
};

/// Sums over all Submits so far.
struct RenderTotals
{
    std::int64_t frames = 0;          ///< drawn or unchanged
    std::int64_t framesUnchanged = 0; ///< identical to the previous frame
    std::int64_t framesInPart = 0;    ///< redrawn in part; the others completely
    std::int64_t pixels = 0;          ///< in all frames
    std::int64_t pixelsDrawn = 0;     ///< redrawn pixels
    std::int64_t items = 0;           ///< in all lists
    std::int64_t itemsDrawn = 0;      ///< drawn items
    std::int64_t itemsOutside = 0;    ///< items outside the picture
    std::int64_t itemsReused = 0;     ///< items with vertices reused from the previous frame
    std::int64_t drawCalls = 0;       ///< without the overlays
    /// Adds all members.
    RenderTotals& operator+=(const RenderTotals& other);
};

/// Turns draw lists into frames.
class Renderer
{
public:
    /// Creates an off-screen renderer. An Error (Absent) lists what was tried when no back end
    /// works. An Error (Unusable) for a size out of range or an invalid BOXREEL_BACKEND.
    static Result<Renderer> Create(const RendererSettings& settings);
    /// Creates a renderer in a window's GL context; the back end of the settings is ignored. One
    /// renderer per window at a time, which must not outlive it. Errors as in Create.
    static Result<Renderer> CreateIn(Window& window, const RendererSettings& settings);
    /// Leaves the source in a moved-from state.
    Renderer(Renderer&&) noexcept;
    /// Leaves the source in a moved-from state.
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Submits the picture to GL and returns, so that the caller can step its world before reading.
    /// The camera's size must be that of the renderer. `overlay` is drawn on top; its commands and
    /// indices must be in range. Otherwise an Error (Unusable), and nothing is drawn. With the
    /// camera of the last Submit only changes are drawn, with the same bits as a complete redraw.
    Result<void> Submit(const DrawList& list, const Camera& camera,
                        const Overlay* overlay = nullptr);

    /// Waits for the last Submit, which is required, and copies its pixels; resizes `frame` if
    /// needed. An Error (Failed) when GL fails.
    Result<void> Read(Frame& frame);

    /// Waits for the last Submit and reads only what changed since the last ReadChanges. The result
    /// is a frame of the renderer, unchanged until the next ReadChanges. An Error as in Read.
    Result<const Frame*> ReadChanges();

    /// Returns the rectangles that the last ReadChanges may have changed: all the first time, none
    /// without a Submit in between. They do not overlap. Valid until the next ReadChanges.
    std::span<const PixelBounds> Changes() const;

    /// Submits and reads, with the Errors of both.
    Result<void> Draw(const DrawList& list, const Camera& camera, Frame& frame,
                      const Overlay* overlay = nullptr);

    /// Shows the picture of the last Submit in the window of CreateIn, and waits for the display.
    /// An Error (Failed) when the window's GL context cannot be used.
    Result<void> Show();

    /// Returns the statistics of the last frame.
    const RenderStatistics& Statistics() const;
    /// Returns the sums over all frames so far.
    const RenderTotals& Totals() const;

    /// Returns the library and its version, e.g. "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5
    /// Mesa 22.3.6".
    const std::string& Description() const;

    /// Returns 16 hex digits that identify the bits of this renderer. They are equal for all
    /// renderers with the same bits in a probe picture (blending, edges, text). The first call in a
    /// process draws it, in a separate renderer of the same back end. Errors as in Create.
    Result<std::string> Fingerprint() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
