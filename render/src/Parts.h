// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"
#include "Instances.h"

/// Puts instances into batches, whole or only what lies in a rectangle. The pixels that are drawn
/// are the same bits either way (Shaders.cpp).
namespace boxreel
{

/// All of it.
void AddWhole(const Instances& all, const Instance& instance, Batches& batches);

/// What lies within `rectangle`; at least all pixels that the instance touches there. False when
/// that is nothing. A long thing that runs through at a slant is cut, so that little is drawn in
/// vain.
bool AddPart(const Instances& all, const Instance& instance, const PixelBounds& rectangle,
             Batches& batches);

} // namespace boxreel
