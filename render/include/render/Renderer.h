// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Result.h>
#include <debugdraw/Theme.h>
#include <render/Frame.h>
#include <render/Overlay.h>

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
};

class Renderer
{
public:
    static Result<Renderer> Create(const RendererSettings& settings);
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    /// Hands the picture to GL and returns; the caller may step its world before it reads.
    /// The camera's size must be the renderer's. `overlay` lies on top of the list.
    Result<void> Submit(const DrawList& list, const Camera& camera, const Overlay* overlay = nullptr);

    /// Waits for the last Submit and copies its pixels; resizes `frame` when needed.
    Result<void> Read(Frame& frame);

    /// Submit and Read in one.
    Result<void> Draw(const DrawList& list, const Camera& camera, Frame& frame, const Overlay* overlay = nullptr);

    /// Which library drew it, e.g. "OSMesa, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 Mesa 22.3.6".
    const std::string& Description() const;

private:
    struct Impl;
    explicit Renderer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
