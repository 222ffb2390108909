// SPDX-License-Identifier: MIT
#pragma once

#include "Moment.h"

#include <debugdraw/Camera.h>
#include <render/Frame.h>

#include <vector>

/// Removes bodies from a comparison, at every depth. Used by the reference store only.
namespace boxreel
{

/// Removes the bodies from the states, traces and draw lists of both moments. The hashes are made
/// equal exactly if the worlds without them are. A trace of more than kLongestTrace bodies has no
/// digits of single bodies, and is removed completely.
void LeaveOut(const std::vector<int>& bodies, Moment& expected, Moment& actual);

/// Returns the areas of the bodies in the pictures: one rectangle per body and list, with the width
/// of lines.
std::vector<PixelBounds> RegionsOf(const std::vector<int>& bodies, const Moment& expected,
                                   const Moment& actual, const Camera& camera);

} // namespace boxreel
