// SPDX-License-Identifier: MIT
#pragma once

#include "SceneSearch.h"

#include <debugdraw/Result.h>
#include <golden/ReferenceStore.h>
#include <render/Renderer.h>

#include <functional>
#include <vector>

/// The scenes as golden candidates: each at three moments, small. Used by `boxreel golden` and by
/// the test suite alike, so that both judge the same pictures. Never prints.
namespace boxreel
{

/// Small enough that the references of all scenes stay light, large enough that a line shows.
inline constexpr int kGoldenWidth = 480;  // [px]
inline constexpr int kGoldenHeight = 270; // [px]

/// A renderer for those pictures.
Result<Renderer> CreateGoldenRenderer();

/// Simulates the scene and hands over the candidates "pyramid/0.5s", "pyramid/2s", "pyramid/5s" in
/// turn.
Result<void> VisitGoldenMoments(const SceneEntry& entry, Renderer& renderer,
                                const std::function<Result<void>(const GoldenCandidate&)>& visit);

/// One verdict a moment.
Result<std::vector<GoldenVerdict>>
VerifyGoldenScene(const SceneEntry& entry, const ReferenceStore& store, Renderer& renderer);

/// Makes every moment of the scene the reference; returns how many.
Result<int> AcceptGoldenScene(const SceneEntry& entry, const ReferenceStore& store,
                              Renderer& renderer);

} // namespace boxreel
