// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Draw.h>
#include <base/Result.h>
#include <debugdraw/Camera.h>

#include <cstdint>
#include <memory>
#include <vector>

/// Debug drawing the classic way, to compare with: a call of GL for each vertex of each shape of
/// each frame (OpenGL 1.1), without smoothed edges, on Mesa's off-screen library; all pixels are
/// read back after every frame.
namespace bench
{

class ImmediateDraw : public b2Draw
{
public:
    /// An Error (Absent) when the library is not installed or offers no such context.
    static boxreel::Result<std::unique_ptr<ImmediateDraw>> Create(int width, int height);

    /// Clears the picture; what is drawn until Read is seen by this camera.
    virtual void Begin(const boxreel::Camera& camera) = 0;

    /// The pixels as RGBA, rows from bottom to top, as GL has them.
    virtual const std::vector<std::uint8_t>& Read() = 0;
};

} // namespace bench
