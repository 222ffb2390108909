// SPDX-License-Identifier: MIT
#include "BenchChoice.h"
#include "Commands.h"
#include "PlantedChanges.h"
#include "StopSignals.h"
#include "WorkFolder.h"

#include <bench/GoldenBench.h>
#include <golden/Compare.h>
#include <render/FigureFrame.h>
#include <render/Png.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

const std::vector<std::string> kScenes{"pyramid", "bridge", "tumbler"}; // fills, lines, crowds

/// The pictures that are compared, as files and as frames.
struct Planted
{
    std::vector<PlantedPair> pairs;
    std::vector<PlantedPicture> frames;
};

std::size_t KindNamed(const std::string& name)
{
    const auto& kinds = PlantedKinds();
    return std::size_t(std::find_if(kinds.begin(), kinds.end(),
                                    [&](const auto& kind) { return kind.name == name; }) -
                       kinds.begin());
}

Result<Planted> Plant(const std::vector<std::string>& scenes, const fs::path& folder)
{
    Result<Renderer> renderer = CreatePlantingRenderer();
    if (!renderer)
    {
        return renderer.GetError();
    }
    Planted planted;
    for (const std::string& scene : scenes)
    {
        Result<std::vector<PlantedPicture>> pictures = PlantChanges(scene, *renderer);
        if (!pictures)
        {
            return pictures.GetError();
        }
        for (PlantedPicture& picture : *pictures)
        {
            const std::string stem = std::to_string(planted.pairs.size()) + "-" + picture.change;
            const PlantedPair pair{KindNamed(picture.change), folder / (stem + "-expected.png"),
                                   folder / (stem + "-actual.png")};
            Result<void> written = WritePng(pair.expected, picture.expected);
            written = written ? WritePng(pair.actual, picture.actual) : written;
            if (!written)
            {
                return written.GetError();
            }
            planted.pairs.push_back(pair);
            planted.frames.push_back(std::move(picture));
        }
    }
    return planted;
}

void TimeFrames(const Planted& planted, CompareSettings settings, int rounds, GoldenMethod& method)
{
    settings.paintsDifference = false;
    method.verdicts.resize(planted.pairs.size());
    for (std::size_t i = 0; i < planted.frames.size(); ++i)
    {
        std::vector<double> times;
        for (int round = 0; round < rounds; ++round)
        {
            const auto start = std::chrono::steady_clock::now();
            method.verdicts[i].isDifferent =
                !Compare(planted.frames[i].expected, planted.frames[i].actual, settings).equal;
            times.push_back(
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        method.verdicts[i].decoded = MedianOf(std::move(times));
    }
}

Result<std::vector<GoldenMethod>> RunOurs(const Planted& planted, int rounds,
                                          const std::function<bool()>& isStopped)
{
    std::error_code error;
    const fs::path self = fs::read_symlink("/proc/self/exe", error);
    std::vector<GoldenMethod> methods;
    for (const CompareSettings& settings :
         {CompareSettings::SameMachine(), CompareSettings::CrossMachine()})
    {
        GoldenMethod method;
        method.name = "boxreel " BOXREEL_VERSION ", " + settings.preset;
        method.isOurs = true;
        TimeFrames(planted, settings, rounds, method);
        const std::vector<PairVerdict> fromFrames = method.verdicts;
        const Result<void> timed =
            TimeProgram({self, {"diff"}, {"--preset", settings.preset}, int(ErrorKind::Different)},
                        planted.pairs, rounds, isStopped, method);
        if (!timed)
        {
            return timed.GetError();
        }
        for (std::size_t i = 0; i < fromFrames.size(); ++i)
        {
            if (fromFrames[i].isDifferent != method.verdicts[i].isDifferent)
            {
                return Error{ErrorKind::Failed, "`boxreel diff` judges '" +
                                                    planted.pairs[i].actual.filename().string() +
                                                    "' otherwise than the library; please report "
                                                    "this."};
            }
        }
        methods.push_back(std::move(method));
    }
    return methods;
}

/// Before anything is drawn: what is named is there, and once.
Result<std::vector<std::string>> ChooseScenes(const BenchOptions& options)
{
    const std::vector<std::string>& scenes = options.scenes.empty() ? kScenes : options.scenes;
    for (const std::string& scene : scenes)
    {
        const Result<const SceneEntry*> found = FindScene(scene);
        if (!found)
        {
            return found.GetError();
        }
        if (std::count(scenes.begin(), scenes.end(), scene) > 1)
        {
            return Error{ErrorKind::Unusable, "'" + scene + "' is named twice; give it once."};
        }
    }
    return scenes;
}

Result<GoldenBenchResult> Run(const std::vector<std::string>& scenes, const GoldenPeers& peers,
                              int rounds)
{
    const Result<WorkFolder> folder = WorkFolder::Create();
    if (!folder)
    {
        return folder.GetError();
    }
    const StopSignals stopSignals; // the pictures are removed, whatever comes
    const auto isStopped = [] { return StopSignals::Caught() != 0; };
    WriteMessage("Drawing the pictures");
    Result<Planted> planted = Plant(scenes, folder->Path());
    if (!planted)
    {
        return planted.GetError();
    }
    WriteMessage("Comparing " + std::to_string(planted->pairs.size()) + " of them");
    Result<std::vector<GoldenMethod>> ours = RunOurs(*planted, rounds, isStopped);
    if (!ours)
    {
        return ours.GetError();
    }
    Result<std::vector<GoldenMethod>> others =
        RunGoldenPeers(peers, planted->pairs, rounds, folder->Path(), isStopped);
    if (!others)
    {
        return others.GetError();
    }
    ours->insert(ours->end(), others->begin(), others->end());
    return GoldenBenchResult{scenes, planted->pairs, std::move(*ours), peers.absent};
}

} // namespace

Result<int> RunBenchGolden(const BenchOptions& options)
{
    if (options.list)
    {
        return PrintNames(PlantedKinds());
    }
    const Result<std::vector<std::string>> scenes = ChooseScenes(options);
    if (!scenes)
    {
        return scenes.GetError();
    }
    const char* variable = std::getenv("BOXREEL_PEERS");
    const Result<GoldenPeers> peers =
        FindGoldenPeers(options.peers.empty() && variable ? fs::path(variable) : options.peers);
    if (!peers)
    {
        return peers.GetError();
    }
    const Result<void> draws = PrepareFrames(Backend::Auto);
    if (!draws)
    {
        return draws.GetError();
    }
    const Result<GoldenBenchResult> result = Run(*scenes, *peers, options.rounds);
    if (!result)
    {
        return result.GetError();
    }
    const Result<void> written =
        WriteOutput(options.json ? GoldenJson(*result) : GoldenTable(*result));
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace boxreel
