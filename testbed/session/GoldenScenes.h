// SPDX-License-Identifier: MIT
#pragma once

#include "SceneSearch.h"
#include "SceneSession.h"

#include <base/Result.h>
#include <golden/ContactSheet.h>
#include <golden/ReferenceStore.h>
#include <render/Renderer.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// The scenes as golden candidates: each at three moments, small. Used by `boxreel golden` and by
/// the test suite alike, so that both judge the same pictures. Never prints.
namespace boxreel
{

/// Small enough that the references of all scenes stay light, large enough that a line shows.
inline constexpr int kGoldenWidth = 480;  // [px]
inline constexpr int kGoldenHeight = 270; // [px]

/// A renderer for those pictures.
Result<Renderer> CreateGoldenRenderer(Backend backend = Backend::Auto);

/// A film instead of a scene: its contact sheet has the reference of that name.
struct GoldenFilm
{
    std::filesystem::path path;
    std::string name;
    ContactSheetSettings sheet;
};

/// The selection of a golden command: a scene at all its moments or at one, or a film.
struct GoldenSelection
{
    const SceneEntry* scene = nullptr;
    std::string moment{}; ///< such as "2s"; empty: all
    std::optional<GoldenFilm> film{};
};

/// "pyramid" or "pyramid/2s"; an Error (Unusable) for a scene or a moment that is not there.
Result<GoldenSelection> SelectGolden(const std::string& name);

/// Its scene as the candidates are made of it, in a picture of this size [px].
Result<SceneSession> OpenGolden(const GoldenSelection& selection, int width = kGoldenWidth,
                                int height = kGoldenHeight);

/// Simulates the scene and hands over the candidates "pyramid/0.5s", "pyramid/2s", "pyramid/5s" in
/// turn, or the selected one; of a film its sheet.
Result<void> VisitGoldenMoments(const GoldenSelection& selection, Renderer& renderer,
                                const std::function<Result<void>(const GoldenCandidate&)>& visit);

/// One verdict a moment.
Result<std::vector<GoldenVerdict>> VerifyGolden(const GoldenSelection& selection,
                                                const ReferenceStore& store, Renderer& renderer,
                                                const CompareSettings& settings = {});

/// The moments to accept: all, only those that differ, or only those without a reference.
enum class GoldenFilter
{
    All,
    Changed,
    Missing,
};

struct GoldenAcceptance
{
    GoldenFilter only = GoldenFilter::All;
    bool forThisRenderer = false; ///< the pictures; else for all
};

/// Makes the scene's present pictures the references. Returns the accepted moments, with their
/// previous verdict.
Result<std::vector<GoldenVerdict>> AcceptGolden(const GoldenSelection& selection,
                                                const ReferenceStore& store, Renderer& renderer,
                                                const GoldenAcceptance& acceptance = {});

/// The step of the selection's last moment.
Result<std::int64_t> LastStepOf(const GoldenSelection& selection);

/// The steps that a selection goes through and the state at its end.
struct GoldenRun
{
    StateTrace trace;
    std::string stateHash;
    WorldState state;
};

/// Simulates the selection with the settings of the references, to `lastStep` or to the selection's
/// last moment.
Result<GoldenRun> SimulateGolden(const GoldenSelection& selection,
                                 std::optional<std::int64_t> lastStep = {});

} // namespace boxreel
