// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Result.h>
#include <debugdraw/Theme.h>
#include <render/Backend.h>
#include <render/Frame.h>
#include <render/Overlay.h>

#include <cstddef>
#include <memory>
#include <string>

/// Turns a DrawList into pixels, off-screen. Owns the GL context, so use one per thread.
/// Knows nothing of worlds: what is not in the list is not drawn. The GL library is loaded by
/// Create, not before.
namespace boxreel
{

struct RendererSettings
{
    int width = 1280; ///< 1 to 8192 [px]
    int height = 720; ///< 1 to 8192 [px]
    Theme theme = Theme::Classic();
    Backend backend = Backend::Auto;
    double scale = 1.0; ///< of all lengths in pixels: outlines, points, letters; 0.1 to 16. The
                        ///< camera and the overlay are given at their full size.
};

/// What the last Submit did.
struct RenderStatistics
{
    std::size_t itemsDrawn = 0;
    std::size_t itemsSkipped = 0; ///< outside the picture, or with coordinates that are not finite
    std::size_t drawCalls = 0;    ///< without the overlay's
    bool unchanged = false; ///< the same list, camera and overlay as before: nothing was drawn
};

class Renderer
{
public:
    /// An Error (Absent) that names all that was tried when no back end works; (Unusable) for a
    /// size out of range, or a BOXREEL_BACKEND that is none.
    static Result<Renderer> Create(const RendererSettings& settings);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Hands the picture to GL and returns; the caller may step its world before it reads.
    /// The camera's size must be the renderer's. `overlay` lies on top of the list.
    Result<void> Submit(const DrawList& list, const Camera& camera,
                        const Overlay* overlay = nullptr);

    /// Waits for the last Submit (the first must come before) and copies its pixels; resizes
    /// `frame` when needed.
    Result<void> Read(Frame& frame);

    /// Submit and Read in one.
    Result<void> Draw(const DrawList& list, const Camera& camera, Frame& frame,
                      const Overlay* overlay = nullptr);

    const RenderStatistics& Statistics() const;

    /// Which library drew it, e.g. "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 Mesa 22.3.6".
    const std::string& Description() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
