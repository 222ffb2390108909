// SPDX-License-Identifier: MIT
#include "BenchChoice.h"
#include "Commands.h"
#include "OutputPath.h"

#include <bench/BenchChart.h>

namespace boxreel
{
namespace
{

/// The scenes that were asked for, in the order of the list.
Result<std::vector<BenchScene>> Choose(const std::vector<BenchScene>& all,
                                       const BenchOptions& options)
{
    if (!options.scenes.empty())
    {
        return ChooseByName(all, options.scenes, "benchmark", "boxreel bench --list");
    }
    std::vector<BenchScene> chosen;
    for (const BenchScene& scene : all)
    {
        if (options.curve ? !scene.curve.empty() : !scene.onlyForCurve)
        {
            chosen.push_back(scene);
        }
    }
    return chosen;
}

/// Before minutes of work: whether each chart can be drawn and written.
Result<void> CheckCharts(const BenchOptions& options)
{
    if (const Result<void> once = CheckNoneTwice(options.charts, "--chart"); !once)
    {
        return once;
    }
    for (const std::filesystem::path& chart : options.charts)
    {
        if (const Result<void> usable = CheckChartPath(chart, options.force); !usable)
        {
            return usable;
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
        if (const Result<void> written = WriteChart(*chart, path, options.force); !written)
        {
            return written;
        }
    }
    return {};
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
    for (const std::filesystem::path& chart : options.charts)
    {
        if (const Result<void> named = CheckChartName(chart); !named)
        {
            return named.GetError();
        }
    }
    if (options.golden)
    {
        return RunBenchGolden(options);
    }
    if (options.accuracy)
    {
        return RunBenchAccuracy(options);
    }
    if (options.render)
    {
        return RunBenchRender(options);
    }
    if (options.record)
    {
        return RunBenchRecord(options);
    }
    if (const Result<void> usable = CheckCharts(options); !usable)
    {
        return usable.GetError();
    }
    if (!options.from.empty())
    {
        const Result<std::string> text = ReadFigures(options.from, "boxreel bench --json");
        const Result<std::vector<BenchResult>> results =
            text ? ParseBenchJson(*text, options.from.string())
                 : Result<std::vector<BenchResult>>(text.GetError());
        return results ? Show(options, *results) : Result<int>(results.GetError());
    }
    const Result<std::vector<std::filesystem::path>> programs =
        PresentPrograms(FindBenchPrograms());
    if (!programs)
    {
        return programs.GetError();
    }
    const Result<std::vector<BenchScene>> all = ListBenchScenes(programs->front());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintNames(*all);
    }
    const Result<std::vector<BenchScene>> scenes = Choose(*all, options);
    if (!scenes)
    {
        return scenes.GetError();
    }
    const Result<std::vector<BenchResult>> results = RunScenes(*programs, *scenes, options);
    return results ? Show(options, *results) : Result<int>(results.GetError());
}

} // namespace boxreel
