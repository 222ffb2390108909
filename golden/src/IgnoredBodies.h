// SPDX-License-Identifier: MIT
#pragma once

#include "Moment.h"

#include <debugdraw/Camera.h>
#include <render/Frame.h>

#include <vector>

/// Bodies that a comparison leaves out, at every depth. Used by the reference store only.
namespace boxreel
{

/// Takes the bodies out of both moments: out of the states and of every step on the way, and what
/// they draw out of the draw lists. What the worlds are without them is the same or not: then, and
/// only then, the hashes of all are as well. A trace of more than kLongestTrace bodies has no digit
/// of a single one, and is left out as a whole.
void LeaveOut(const std::vector<int>& bodies, Moment& expected, Moment& actual);

/// Where the bodies are in the pictures, by what they draw in either of the lists: a rectangle a
/// body and list, with the width of lines.
std::vector<PixelBounds> RegionsOf(const std::vector<int>& bodies, const Moment& expected,
                                   const Moment& actual, const Camera& camera);

} // namespace boxreel
