// SPDX-License-Identifier: MIT
// Pictures to compare, and our comparison of them. `list` prints the kinds of changes; `plant
// FOLDER SCENE …` draws each scene and each change of it into PNG files; `time PRESET ROUNDS
// EXPECTED ACTUAL …` compares such files, decoded before. Output is JSON, one object per line.
#include "PlantedChanges.h"

#include <base/Result.h>
#include <golden/Compare.h>
#include <render/Png.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace bench
{
namespace
{

using namespace boxreel;
using Words = std::vector<std::string>;

void List()
{
    for (const PlantedKind& kind : PlantedKinds())
    {
        std::printf("{\"change\":\"%s\",\"what\":\"%s\",\"truth\":\"%s\"}\n", kind.change,
                    kind.what, kind.truth);
    }
}

/// Files are named by number and change, for one change comes once for each scene.
Result<void> Plant(const std::filesystem::path& folder, const Words& scenes)
{
    Result<Renderer> renderer = CreatePlantingRenderer();
    if (!renderer)
    {
        return renderer.GetError();
    }
    int number = 0;
    for (const std::string& scene : scenes)
    {
        const Result<std::vector<PlantedPicture>> pictures = PlantChanges(scene, *renderer);
        if (!pictures)
        {
            return pictures.GetError();
        }
        for (const PlantedPicture& picture : *pictures)
        {
            const std::string stem = std::to_string(number++) + "-" + picture.change;
            Result<void> written = WritePng(folder / (stem + "-expected.png"), picture.expected);
            written = written ? WritePng(folder / (stem + "-actual.png"), picture.actual) : written;
            if (!written)
            {
                return written;
            }
            std::printf("{\"change\":\"%s\",\"expected\":\"%s-expected.png\",\"actual\":\"%s-actual"
                        ".png\"}\n",
                        picture.change.c_str(), stem.c_str(), stem.c_str());
        }
    }
    return {};
}

double WallTime()
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

Result<void> TimePair(const CompareSettings& settings, int rounds, const std::string& expectedPath,
                      const std::string& actualPath)
{
    const Result<Frame> expected = ReadPng(expectedPath);
    const Result<Frame> actual = expected ? ReadPng(actualPath) : expected;
    if (!actual)
    {
        return actual.GetError();
    }
    bool isDifferent = false;
    std::vector<double> times;
    for (int round = 0; round < rounds; ++round)
    {
        const double start = WallTime();
        isDifferent = !Compare(*expected, *actual, settings).equal;
        times.push_back(WallTime() - start);
    }
    const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    std::printf("{\"method\":\"boxreel %s, %s\",\"different\":%s,\"decodedSeconds\":%.9g}\n",
                BOXREEL_VERSION, settings.preset.c_str(), isDifferent ? "true" : "false", *middle);
    return {};
}

Result<void> TimePairs(const std::string& preset, int rounds, const Words& files)
{
    Result<CompareSettings> settings = CompareSettings::Preset("PRESET", preset);
    if (!settings)
    {
        return settings.GetError();
    }
    settings->paintsDifference = false;
    Result<void> done;
    for (std::size_t i = 0; done && i + 1 < files.size(); i += 2)
    {
        done = TimePair(*settings, rounds, files[i], files[i + 1]);
    }
    return done;
}

Result<void> Run(const Words& words)
{
    const std::string command = words.size() > 1 ? words[1] : "";
    if (command == "list" && words.size() == 2)
    {
        List();
        return {};
    }
    if (command == "plant" && words.size() > 3)
    {
        return Plant(words[2], {words.begin() + 3, words.end()});
    }
    const int rounds = command == "time" && words.size() > 5 ? std::atoi(words[3].c_str()) : 0;
    if (rounds < 1 || words.size() % 2 != 0)
    {
        return Error{ErrorKind::Unusable,
                     "Usage: " + words[0] +
                         " list | plant FOLDER SCENE ... | time PRESET ROUNDS EXPECTED ACTUAL ..."};
    }
    return TimePairs(words[2], rounds, {words.begin() + 4, words.end()});
}

} // namespace
} // namespace bench

int main(int count, char** words)
try
{
    const boxreel::Result<void> done = bench::Run({words, words + count});
    if (!done)
    {
        std::fprintf(stderr, "%s\n", done.GetError().Text().c_str());
        return int(done.GetError().kind);
    }
    return 0;
}
catch (const std::exception& thrown) // such as memory that is not there
{
    std::fprintf(stderr, "%s\n", thrown.what());
    return int(boxreel::ErrorKind::Failed);
}
