// SPDX-License-Identifier: MIT
#include <debugdraw/DrawLayer.h>

namespace boxreel
{

std::vector<std::string> LayerNames()
{
    std::vector<std::string> names;
    for (const LayerInfo& known : kOptionalLayers)
    {
        names.emplace_back(known.option);
    }
    return names;
}

std::optional<DrawLayer> FindLayer(std::string_view option)
{
    for (const LayerInfo& known : kOptionalLayers)
    {
        if (option == known.option)
        {
            return known.layer;
        }
    }
    return std::nullopt;
}

} // namespace boxreel
