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
/// Turns a DrawList into pixels, off-screen. Owns the GL context, so use one per thread.
/// Knows nothing of worlds: what is not in the list is not drawn. The GL library is loaded by
/// Create, not before.
namespace boxreel
{

class Window;

/// How a renderer draws.
struct RendererSettings
{
    int width = 1280;                ///< of the picture, 1 to 8192 [px]
    int height = 720;                ///< of the picture, 1 to 8192 [px]
    Theme theme = Theme::Classic();  ///< colours and widths
    Backend backend = Backend::Auto; ///< who draws
    double scale = 1.0; ///< of all lengths in pixels: outlines, points, letters; 0.1 to 16. The
                        ///< camera and the overlay are given at their full size.
    bool redrawsWhole = false; ///< draws every frame that changes as a whole: to test and to
                               ///< measure against; not a bit differs
};

/// What the last Submit did. Of the items of the list, some are outside the picture, some drawn,
/// and the rest is where nothing has changed.
struct RenderStatistics
{
    std::size_t items = 0;        ///< of the list
    std::size_t itemsDrawn = 0;   ///< with at least a part of them
    std::size_t itemsOutside = 0; ///< outside the picture, or with coordinates that are not finite
    std::size_t itemsReused = 0;  ///< known from the last Submit: drawn or not, but not built anew
    std::size_t drawCalls = 0;    ///< without the overlay's
    std::size_t rectangles = 0;   ///< that were drawn anew; one when it was the whole picture
    std::int64_t pixels = 0;      ///< in them
    bool unchanged = false;       ///< it shows the same as before: nothing was drawn
};

/// The sum over all Submits so far.
struct RenderTotals
{
    std::int64_t frames = 0;          ///< that were drawn
    std::int64_t framesUnchanged = 0; ///< of the frames
    std::int64_t framesInPart = 0;    ///< of the frames; the others were drawn as a whole
    std::int64_t pixels = 0;          ///< of all frames
    std::int64_t pixelsDrawn = 0;     ///< of these
    std::int64_t items = 0;           ///< of all lists
    std::int64_t itemsDrawn = 0;      ///< of these …
    std::int64_t itemsOutside = 0;    ///< … or outside the picture …
    std::int64_t itemsReused = 0;     ///< … and how many were known from the frame before
    std::int64_t drawCalls = 0;       ///< without the overlays'
    /// Adds each of the numbers.
    RenderTotals& operator+=(const RenderTotals& other);
};

/// Turns draw lists into frames.
class Renderer
{
public:
    /// A renderer off-screen. An Error (Absent) that names all that was tried when no back end
    /// works; (Unusable) for a size out of range, or a BOXREEL_BACKEND that is none.
    static Result<Renderer> Create(const RendererSettings& settings);
    /// A renderer in a window's GL context, whatever back end the settings name: one renderer a
    /// window at a time, which must not outlive it. Errors as of Create.
    static Result<Renderer> CreateIn(Window& window, const RendererSettings& settings);
    /// The other may only be assigned to or destroyed.
    Renderer(Renderer&&) noexcept;
    /// The other may only be assigned to or destroyed.
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Hands the picture to GL and returns; the caller may step its world before it reads.
    /// The camera's size must be the renderer's. `overlay` lies on top of the list; its commands
    /// must name indices that it has, and its indices vertices. An Error (Unusable) otherwise, and
    /// nothing is drawn. Under the camera of the last Submit only what has changed is drawn, with
    /// the same bits as if it were all.
    Result<void> Submit(const DrawList& list, const Camera& camera,
                        const Overlay* overlay = nullptr);

    /// Waits for the last Submit (the first must come before) and copies its pixels; resizes
    /// `frame` when needed. An Error (Failed) when GL does not give them.
    Result<void> Read(Frame& frame);

    /// Waits for the last Submit without a copy: only what has changed since the last ReadChanges
    /// is read, into a frame of the renderer's, which stays as it is until the next ReadChanges. An
    /// Error as of Read.
    Result<const Frame*> ReadChanges();

    /// Where the last ReadChanges may have changed its frame; everything the first time, nothing
    /// when no Submit came between. No two share a pixel. Valid until the next ReadChanges.
    std::span<const PixelBounds> Changes() const;

    /// Submit and Read in one, with their Errors.
    Result<void> Draw(const DrawList& list, const Camera& camera, Frame& frame,
                      const Overlay* overlay = nullptr);

    /// Shows the picture of the last Submit in its window (the renderer is one of CreateIn), and
    /// waits for the display. An Error (Failed) when the window's GL context cannot be used.
    Result<void> Show();

    /// What drawing the last frame took.
    const RenderStatistics& Statistics() const;
    /// What drawing took, of all frames so far.
    const RenderTotals& Totals() const;

    /// Which library drew it, e.g. "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 Mesa 22.3.6".
    const std::string& Description() const;

    /// Which bits this renderer gives: 16 hex digits, the same for all that draw a probe picture
    /// (blending, edges, text) with the same bits. The first call of a process draws it, in a
    /// renderer of its own of the same back end; Errors as of Create.
    Result<std::string> Fingerprint() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
