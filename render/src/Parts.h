// SPDX-License-Identifier: MIT
#pragma once

#include "Batches.h"
#include "Instances.h"

/// Adds instances to batches, completely or in a rectangle. The pixels have the same bits in both
/// cases (Shaders.cpp).
namespace boxreel
{

/// Adds the whole instance.
void AddWhole(const Instances& all, const Instance& instance, Batches& batches);

/// Adds the part within `rectangle`: at least all pixels the instance touches there. False if it is
/// empty. A long diagonal part is cut into pieces, to draw fewer empty pixels.
bool AddPart(const Instances& all, const Instance& instance, const PixelBounds& rectangle,
             Batches& batches);

} // namespace boxreel
