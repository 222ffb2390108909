// SPDX-License-Identifier: MIT
#include "SceneLayers.h"
#include "Values.h"

#include <base/Nearest.h>

namespace boxreel
{
namespace
{

Error UnknownLayer(const std::string& option, const std::string& layer)
{
    return BadValue(option, layer, "unknown layer",
                    DidYouMean(layer, LayerNames(), "use any of " + JoinedBy(",", LayerNames())));
}

} // namespace

Result<LayerSet> ParseLayers(const std::string& option, const std::string& text)
{
    LayerSet layers = LayerSet::None();
    for (const std::string& part : SplitAt(',', text))
    {
        const std::optional<DrawLayer> known = FindLayer(part);
        if (!known)
        {
            return UnknownLayer(option, part);
        }
        layers[*known] = true;
    }
    return layers;
}

std::string TextOf(const LayerSet& layers)
{
    std::string text;
    for (const LayerInfo& known : kOptionalLayers)
    {
        if (layers[known.layer])
        {
            text.append(text.empty() ? "" : ",").append(known.option);
        }
    }
    return text;
}

View PictureView(const Camera& camera, const Theme& theme, double scale)
{
    constexpr double kCorners = 8.0; // how far a pointed one reaches, in widths of an outline
    constexpr double kEdge = 2.0;    // of the picture: pixels that are touched a little [px]
    return ViewOf(camera, kCorners * double(theme.outlineWidth) + kEdge / scale);
}

} // namespace boxreel
