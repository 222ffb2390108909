// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/DrawLayer.h>
#include <debugdraw/Theme.h>
#include <debugdraw/View.h>
#include <debugdraw/WorldLayers.h>

#include <string>

/// The layers of a world in a picture, as the text of `--draw`.
namespace boxreel
{

/// Reads a list such as "shapes,contacts" of the only visible layers. For any other text, returns
/// an Error (Unusable) that names `option` and all layers.
Result<LayerSet> ParseLayers(const std::string& option, const std::string& text);

/// Returns the text that ParseLayers accepts; empty when nothing is shown.
std::string TextOf(const LayerSet& layers);

/// Returns the area that is visible in a picture of this camera with `scale` times as many pixels.
/// Includes a margin for outlines and their corners.
View PictureView(const Camera& camera, const Theme& theme, double scale);

} // namespace boxreel
