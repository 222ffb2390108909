// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>
#include <render/Frame.h>

#include <vector>

/// The expected picture of a list, computed the slow way. Every pixel is the mean of 16 x 16
/// points. Each point is tested against the definition of every shape near it and blended in
/// painter's order. Shares no code with the renderer. For tests and the benchmark. Draws no text.
namespace boxreel
{

struct TruthPicture
{
    int width = 0;
    int height = 0;
    std::vector<double> rgba; ///< 0 to 255, premultiplied, not rounded
    std::vector<bool> edge;   ///< pixels whose points are not all alike
};

TruthPicture Supersample(const DrawList& list, const Camera& camera, const Theme& theme,
                         int grid = 16);

struct EdgeError
{
    double rms = 0.0;     ///< over the red, green and blue of the pixels on edges, of 255
    double maximum = 0.0; ///< over all pixels
    std::size_t edgePixels = 0;
};

EdgeError Compare(const Frame& frame, const TruthPicture& truth);

} // namespace boxreel
