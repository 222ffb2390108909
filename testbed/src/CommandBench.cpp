// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "Nearest.h"
#include "OutputPath.h"
#include "Terminal.h"

#include <bench/BenchChart.h>
#include <bench/Benchmark.h>
#include <debugdraw/AtomicFile.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace boxreel
{
namespace
{

/// The scenes that were asked for, in the order of the list.
Result<std::vector<BenchScene>> Choose(const std::vector<BenchScene>& all,
                                       const BenchOptions& options)
{
    std::vector<BenchScene> chosen;
    std::vector<std::string> known;
    for (const BenchScene& scene : all)
    {
        known.push_back(scene.name);
        if (options.scenes.empty() && (options.curve ? !scene.curve.empty() : !scene.onlyForCurve))
        {
            chosen.push_back(scene);
        }
    }
    for (const std::string& name : options.scenes)
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
    return chosen;
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

/// Before minutes of work: whether each chart can be drawn and written.
Result<void> CheckCharts(const BenchOptions& options)
{
    for (auto chart = options.charts.begin(); chart != options.charts.end(); ++chart)
    {
        if (const Result<void> usable = CheckChartPath(*chart, options.force); !usable)
        {
            return usable;
        }
        if (std::find(options.charts.begin(), chart, *chart) != chart)
        {
            return Error{ErrorKind::Unusable,
                         "--chart names '" + chart->string() + "' twice; give it once."};
        }
    }
    return options.charts.empty() ? Result<void>() : PrepareCharts();
}

Result<Chart> ChartOf(const std::vector<BenchResult>& results, bool curve)
{
    if (curve)
    {
        Result<LineChart> chart = CurveChart(results);
        return chart ? Result<Chart>(std::move(*chart)) : Result<Chart>(chart.GetError());
    }
    Result<BarChart> chart = RatioChart(results);
    return chart ? Result<Chart>(std::move(*chart)) : Result<Chart>(chart.GetError());
}

Result<void> WriteCharts(const BenchOptions& options, const std::vector<BenchResult>& results)
{
    if (options.charts.empty())
    {
        return {};
    }
    const Result<Chart> chart = ChartOf(results, options.curve);
    if (!chart)
    {
        return chart.GetError();
    }
    for (const std::filesystem::path& path : options.charts)
    {
        const bool isPng = path.extension() == ".png";
        const Result<std::vector<std::uint8_t>> bytes =
            EncodeChart(*chart, isPng ? ChartFormat::Png : ChartFormat::Svg);
        if (!bytes)
        {
            return bytes.GetError();
        }
        if (const Result<void> written = WriteWhole(path, *bytes, options.force); !written)
        {
            return written;
        }
    }
    return {};
}

Result<std::vector<BenchResult>> ReadResults(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf()))
    {
        return Error{ErrorKind::Unusable, "Cannot read '" + path.string() +
                                              "'; name a file that `boxreel bench --json` made."};
    }
    return ParseBenchJson(text.str(), path.string());
}

Result<std::vector<BenchResult>> RunScenes(const std::vector<std::filesystem::path>& programs,
                                           const std::vector<BenchScene>& scenes,
                                           const BenchOptions& options)
{
    if (!options.charts.empty() && !options.curve && programs.size() < 2)
    {
        return RatioChart({}).GetError(); // said before anything is run
    }
    std::vector<BenchResult> results;
    for (const BenchScene& scene : scenes)
    {
        WriteMessage(scene.name + ": " + scene.what);
        results.push_back(RunBenchScene(programs, scene, {options.rounds, options.threads}));
    }
    return results;
}

Result<int> Show(const BenchOptions& options, const std::vector<BenchResult>& results)
{
    Result<void> done = WriteOutput(options.json ? BenchJson(results) : BenchTable(results));
    if (done)
    {
        done = WriteCharts(options, results);
    }
    return done ? Result<int>(0) : Result<int>(done.GetError());
}

} // namespace

Result<int> RunBench(const BenchOptions& options)
{
    if (options.accuracy)
    {
        return RunBenchAccuracy(options);
    }
    if (const Result<void> usable = CheckCharts(options); !usable)
    {
        return usable.GetError();
    }
    if (!options.from.empty())
    {
        const Result<std::vector<BenchResult>> results = ReadResults(options.from);
        return results ? Show(options, *results) : Result<int>(results.GetError());
    }
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
    const Result<std::vector<BenchScene>> scenes = Choose(*all, options);
    if (!scenes)
    {
        return scenes.GetError();
    }
    const Result<std::vector<BenchResult>> results = RunScenes(programs, *scenes, options);
    return results ? Show(options, *results) : Result<int>(results.GetError());
}

} // namespace boxreel
