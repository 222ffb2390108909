// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <functional>

/// @file
/// Lists over lists: several moments in one picture, earlier ones fainter. Stroboscopes and onion
/// skins are made of it.
namespace boxreel
{

/// Says which items are meant.
using ItemFilter = std::function<bool(const DrawItem&)>;

/// Adds the items that `filter` lets pass (all, when it is empty), as they are, on top of what is
/// there.
void Append(DrawList& to, const DrawList& from, const ItemFilter& filter = {});

/// Adds the items that `filter` lets pass (all, when it is empty) with `opacity` times their own,
/// 0 to 1, in the layer Poses. Frames of reference, which have no opacity, are left out.
void AddFaded(DrawList& to, const DrawList& from, double opacity, const ItemFilter& filter = {});

/// Whether everything that `owner` has in both lists lies within `distance` [m] of the same place:
/// then the one, drawn over the other, would only blur it. False when one has what the other has
/// not.
bool StandsStill(const DrawList& before, const DrawList& after, std::uint32_t owner,
                 double distance);

} // namespace boxreel
