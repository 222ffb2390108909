// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <string>
#include <vector>

/// @file
/// A camera that goes from one view to the next at given times. A function of the time alone: no
/// frame rate and no step is in it. Plain arithmetic, so that every machine sees the same view.
namespace boxreel
{

/// Where a camera is to be at a moment.
struct CameraKey
{
    double time = 0.0;    ///< simulated [s]
    double centerX = 0.0; ///< world point in the middle of the frame [m]
    double centerY = 0.0; ///< its height in the world [m]
    double height = 50.0; ///< of the visible area [m], above 0
    /// True if all members are equal.
    friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// Why these keys are no path, as the end of a sentence ("…: its times must grow"); empty if they
/// are one. Two keys or more, all numbers finite, times growing, heights above 0.
std::string WhyNotPath(const std::vector<CameraKey>& keys);

/// Rests at each key and leaves it softly; before the first and after the last key it stands still.
/// Between two keys it zooms evenly, each moment by the same factor, about one point of the world
/// that keeps its place in the frame; where both show the same height it pans.
class CameraPath
{
public:
    /// Expects what WhyNotPath has nothing against.
    CameraPath(int width, int height, std::vector<CameraKey> keys);

    Camera At(double time) const; ///< what is seen at this simulated time [s]

private:
    Camera ViewOf(const CameraKey& key) const;

    int m_width;  // [px]
    int m_height; // [px]
    std::vector<CameraKey> m_keys;
};

} // namespace boxreel
