// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>

#include <string>
#include <vector>

/// @file
/// A camera that moves between views at given times. A function of time only, independent of frames
/// and steps. Plain arithmetic, so that every machine computes the same view.
namespace boxreel
{

/// A view at a time.
struct CameraKey
{
    double time = 0.0;    ///< simulated [s]
    double centerX = 0.0; ///< world point in the centre of the frame [m]
    double centerY = 0.0; ///< its y coordinate [m]
    double height = 50.0; ///< height of the visible area [m], > 0
    /// True if all members are equal.
    friend bool operator==(const CameraKey&, const CameraKey&) = default;
};

/// Returns why these keys do not form a path, as the end of a sentence ("…: its times must grow");
/// empty if they do. At least two keys, all numbers finite, increasing times, heights > 0.
std::string WhyNotPath(const std::vector<CameraKey>& keys);

/// Rests at each key and starts smoothly; constant before the first and after the last key. Between
/// keys of different heights it zooms at a constant rate about a fixed point of the world. Between
/// equal heights it pans.
class CameraPath
{
public:
    /// `keys` must pass WhyNotPath.
    CameraPath(int width, int height, std::vector<CameraKey> keys);

    Camera At(double time) const; ///< view at this simulated time [s]

private:
    Camera ViewOf(const CameraKey& key) const;

    int m_width;  // [px]
    int m_height; // [px]
    std::vector<CameraKey> m_keys;
};

} // namespace boxreel
