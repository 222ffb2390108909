// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Draw.h>
#include <base/Result.h>
#include <debugdraw/Camera.h>

#include <cstdint>
#include <memory>
#include <vector>

/// Classic debug drawing, for comparison. It makes one GL call for each vertex of each shape of
/// each frame (OpenGL 1.1), without smoothed edges, on Mesa's off-screen library. All pixels are
/// read back after every frame.
namespace bench
{

class ImmediateDraw : public b2Draw
{
public:
    /// An Error (Absent) when the library is not installed or offers no such context.
    static boxreel::Result<std::unique_ptr<ImmediateDraw>> Create(int width, int height);

    /// Clears the picture and sets the camera for all drawing until Read.
    virtual void Begin(const boxreel::Camera& camera) = 0;

    /// The pixels as RGBA, rows from bottom to top, as GL has them.
    virtual const std::vector<std::uint8_t>& Read() = 0;
};

} // namespace bench
