// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "Nearest.h"
#include "OutputPath.h"
#include "Terminal.h"

#include <bench/AccuracySweep.h>
#include <bench/Benchmark.h>
#include <debugdraw/AtomicFile.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// The cases that were asked for, in the order of their names; all when none was.
Result<std::vector<AccuracyCase>> Choose(const std::vector<AccuracyCase>& all,
                                         const BenchOptions& options)
{
    std::vector<std::string> known;
    for (const AccuracyCase& info : all)
    {
        known.push_back(info.name);
    }
    std::vector<AccuracyCase> chosen = options.scenes.empty() ? all : std::vector<AccuracyCase>();
    for (const std::string& name : options.scenes)
    {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end())
        {
            const int nearest = NearestWord(name, known);
            const std::string hint =
                nearest < 0 ? "" : " Did you mean '" + known[std::size_t(nearest)] + "'?";
            return Error{ErrorKind::Unusable,
                         "No accuracy case is called '" + name +
                             "'; `boxreel bench --accuracy --list` shows them." + hint};
        }
        chosen.push_back(all[std::size_t(found - known.begin())]);
    }
    return chosen;
}

/// error.svg becomes error-A-projectile.svg.
std::filesystem::path PathFor(const std::filesystem::path& chart, const AccuracyCase& info)
{
    std::filesystem::path path = chart;
    path.replace_filename(chart.stem().string() + "-" + info.name + chart.extension().string());
    return path;
}

/// Before minutes of work: whether each chart can be drawn and written.
Result<void> CheckCharts(const BenchOptions& options, const std::vector<AccuracyCase>& cases)
{
    for (const std::filesystem::path& chart : options.charts)
    {
        for (const AccuracyCase& info : cases)
        {
            const Result<void> usable = CheckChartPath(PathFor(chart, info), options.force);
            if (!usable)
            {
                return usable;
            }
        }
    }
    return options.charts.empty() ? Result<void>() : PrepareCharts();
}

Result<void> WriteCharts(const BenchOptions& options, const AccuracyResult& result)
{
    if (options.charts.empty())
    {
        return {};
    }
    const Result<LineChart> chart = AccuracyChart(result);
    if (!chart)
    {
        WriteMessage(chart.GetError().message); // the others can still be drawn
        return {};
    }
    for (const std::filesystem::path& file : options.charts)
    {
        const ChartFormat format = file.extension() == ".png" ? ChartFormat::Png : ChartFormat::Svg;
        const Result<std::vector<std::uint8_t>> bytes = EncodeChart(Chart(*chart), format);
        if (!bytes)
        {
            return bytes.GetError();
        }
        const Result<void> written = WriteWhole(PathFor(file, result.info), *bytes, options.force);
        if (!written)
        {
            return written;
        }
    }
    return {};
}

/// All settings of all engines. Every program knows all cases, but not the same sub-steps.
Result<AccuracyResult> RunCase(const std::vector<std::filesystem::path>& programs,
                               const AccuracyCase& info)
{
    AccuracyResult result{info, {}};
    for (const std::filesystem::path& program : programs)
    {
        const Result<std::vector<AccuracyCase>> cases = ListAccuracyCases(program);
        if (!cases || cases->empty())
        {
            return cases ? Error{ErrorKind::Failed,
                                 program.string() + " lists no accuracy case; build it again."}
                         : cases.GetError();
        }
        for (const AccuracySettings& settings : AccuracySweep(cases->front().mostSubSteps))
        {
            result.runs.push_back(RunAccuracyCase(program, info.name, settings));
        }
    }
    return result;
}

Result<int> PrintList(const std::vector<AccuracyCase>& cases)
{
    std::string text;
    for (const AccuracyCase& info : cases)
    {
        text += info.name + std::string(info.name.size() < 20 ? 20 - info.name.size() : 1, ' ') +
                info.what + "\n";
    }
    const Result<void> written = WriteOutput(text);
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

Result<int> RunCases(const BenchOptions& options,
                     const std::vector<std::filesystem::path>& programs,
                     const std::vector<AccuracyCase>& cases)
{
    std::vector<AccuracyResult> results;
    for (const AccuracyCase& info : cases)
    {
        WriteMessage(info.name + ": " + info.what);
        const Result<AccuracyResult> result = RunCase(programs, info);
        if (!result)
        {
            return result.GetError();
        }
        if (const Result<void> written = WriteCharts(options, *result); !written)
        {
            return written.GetError();
        }
        results.push_back(*result);
    }
    const Result<void> written =
        WriteOutput(options.json ? AccuracyJson(results) : AccuracyTable(results));
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace

Result<int> RunBenchAccuracy(const BenchOptions& options)
{
    const std::vector<std::filesystem::path> programs = FindBenchPrograms();
    if (programs.empty())
    {
        return Error{ErrorKind::Absent, "The benchmark programs are not beside this program; run "
                                        "`./boxreel bench` in a checkout, which builds them."};
    }
    const Result<std::vector<AccuracyCase>> all = ListAccuracyCases(programs.front());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintList(*all);
    }
    const Result<std::vector<AccuracyCase>> cases = Choose(*all, options);
    if (!cases)
    {
        return cases.GetError();
    }
    if (const Result<void> usable = CheckCharts(options, *cases); !usable)
    {
        return usable.GetError();
    }
    return RunCases(options, programs, *cases);
}

} // namespace boxreel
