// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <render/Renderer.h>

#include <string>
#include <vector>

/// Pictures with a known difference, for judging comparisons by: of a scene as the renderer draws
/// it, and again with one thing changed. Used by `boxreel bench --golden`; writes no files.
namespace boxreel
{

struct PlantedPicture
{
    std::string change; ///< "body": what benchmarks call it
    Frame expected;
    Frame actual;
};

/// One of each kind of change, of the scene of that name after a second, 1280 x 720, with labels.
Result<std::vector<PlantedPicture>> PlantChanges(const std::string& scene, Renderer& renderer);

/// A renderer for them.
Result<Renderer> CreatePlantingRenderer();

} // namespace boxreel
