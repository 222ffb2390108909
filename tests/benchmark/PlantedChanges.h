// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Renderer.h>

#include <string>
#include <vector>

/// Pictures with a known difference, to judge comparisons by: of a scene as the renderer draws it,
/// and again with one thing changed. Called by GoldenMain.cpp only; writes no files.
namespace bench
{

/// A kind of change.
struct PlantedKind
{
    const char* change; ///< its name: "body"
    const char* what;   ///< in a few words
    const char* truth;  ///< "different", "equal" (else it is a false alarm), or "either"
};

/// All kinds, in the order of the table.
const std::vector<PlantedKind>& PlantedKinds();

struct PlantedPicture
{
    std::string change; ///< name of its kind
    boxreel::Frame expected;
    boxreel::Frame actual;
};

/// One of each kind of change, of the scene of that name after a second, 1280 x 720, with labels.
boxreel::Result<std::vector<PlantedPicture>> PlantChanges(const std::string& scene,
                                                          boxreel::Renderer& renderer);

/// A renderer for them.
boxreel::Result<boxreel::Renderer> CreatePlantingRenderer();

} // namespace bench
