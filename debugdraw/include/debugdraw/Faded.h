// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <functional>

/// @file
/// Combines lists: several moments in one picture, earlier ones fainter. Used for stroboscopic
/// pictures and onion skins.
namespace boxreel
{

/// Selects items.
using ItemFilter = std::function<bool(const DrawItem&)>;

/// Appends the items selected by `filter`, by default all.
void Append(DrawList& to, const DrawList& from, const ItemFilter& filter = {});

/// Appends the items selected by `filter`, by default all, in the layer Poses. Their opacity is
/// multiplied by `opacity`, 0 to 1. Frames of reference are skipped, because they have no opacity.
void AddFaded(DrawList& to, const DrawList& from, double opacity, const ItemFilter& filter = {});

/// True if all items of `owner` in both lists are equal up to `distance` [m]; drawing both would
/// only blur them. False if the items do not correspond.
bool StandsStill(const DrawList& before, const DrawList& after, std::uint32_t owner,
                 double distance);

} // namespace boxreel
