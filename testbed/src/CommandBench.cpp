// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "Nearest.h"
#include "Terminal.h"

#include <bench/Benchmark.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// The scenes that were asked for, in the order of the list; all when none was.
Result<std::vector<BenchScene>> Choose(const std::vector<BenchScene>& all,
                                       const std::vector<std::string>& names)
{
    std::vector<BenchScene> chosen;
    std::vector<std::string> known;
    for (const BenchScene& scene : all)
    {
        known.push_back(scene.name);
    }
    for (const std::string& name : names)
    {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end())
        {
            const int nearest = NearestWord(name, known);
            const std::string hint =
                nearest < 0 ? "" : " Did you mean '" + known[std::size_t(nearest)] + "'?";
            return Error{ErrorKind::Unusable, "No benchmark is called '" + name +
                                                  "'; `boxreel bench --list` shows them." + hint};
        }
        chosen.push_back(all[std::size_t(found - known.begin())]);
    }
    return names.empty() ? all : chosen;
}

Result<int> PrintList(const std::vector<BenchScene>& scenes)
{
    std::string text;
    for (const BenchScene& scene : scenes)
    {
        text += scene.name + std::string(scene.name.size() < 16 ? 16 - scene.name.size() : 1, ' ') +
                scene.what + "\n";
    }
    const Result<void> written = WriteOutput(text);
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace

Result<int> RunBench(const BenchOptions& options)
{
    const std::vector<std::filesystem::path> programs = FindBenchPrograms();
    if (programs.empty())
    {
        return Error{ErrorKind::Absent, "The benchmark programs are not beside this program; run "
                                        "`./boxreel bench` in a checkout, which builds them."};
    }
    const Result<std::vector<BenchScene>> all = ListBenchScenes(programs.front());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintList(*all);
    }
    const Result<std::vector<BenchScene>> scenes = Choose(*all, options.scenes);
    if (!scenes)
    {
        return scenes.GetError();
    }
    std::vector<BenchResult> results;
    for (const BenchScene& scene : *scenes)
    {
        WriteMessage(scene.name + ": " + scene.what);
        results.push_back(RunBenchScene(programs, scene, options.rounds));
    }
    const Result<void> written =
        WriteOutput(options.json ? BenchJson(results) : BenchTable(results));
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace boxreel
