// SPDX-License-Identifier: MIT
#include "BenchChoice.h"
#include "Commands.h"

#include <bench/AccuracySweep.h>

#include <algorithm>

namespace boxreel
{
namespace
{

std::vector<std::string> NamesOf(const std::vector<AccuracyCase>& cases)
{
    std::vector<std::string> names;
    for (const AccuracyCase& info : cases)
    {
        names.push_back(info.name);
    }
    return names;
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
        const Result<void> written =
            WriteChart(Chart(*chart), ChartPathFor(file, result.info.name), options.force);
        if (!written)
        {
            return written;
        }
    }
    return {};
}

Result<int> Show(const BenchOptions& options, const std::vector<AccuracyResult>& results)
{
    const Result<void> written =
        WriteOutput(options.json ? AccuracyJson(results) : AccuracyTable(results));
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

Result<std::vector<AccuracyCase>> Choose(const std::vector<AccuracyCase>& all,
                                         const std::vector<std::string>& names,
                                         const std::string& list)
{
    return names.empty() ? all : ChooseByName(all, names, "accuracy case", list);
}

/// The charts of each case as soon as it is done: all of them take a while.
Result<int> RunCases(const BenchOptions& options,
                     const std::vector<std::filesystem::path>& programs,
                     const std::vector<AccuracyCase>& cases)
{
    std::vector<AccuracyResult> results;
    for (const AccuracyCase& info : cases)
    {
        WriteMessage(info.name + ": " + info.what);
        const Result<AccuracyResult> result = RunAccuracySweep(programs, info, options.rounds);
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
    return Show(options, results);
}

/// What --from names, of the chosen cases.
Result<int> ShowEarlier(const BenchOptions& options)
{
    const Result<std::string> text = ReadFigures(options.from, "boxreel bench --accuracy --json");
    const Result<std::vector<AccuracyResult>> all =
        text ? ParseAccuracyJson(*text, options.from.string())
             : Result<std::vector<AccuracyResult>>(text.GetError());
    if (!all)
    {
        return all.GetError();
    }
    std::vector<AccuracyCase> known;
    for (const AccuracyResult& result : *all)
    {
        known.push_back(result.info);
    }
    if (options.list)
    {
        return PrintNames(known);
    }
    const Result<std::vector<AccuracyCase>> cases = Choose(
        known, options.scenes, "boxreel bench --accuracy --list --from " + options.from.string());
    if (!cases)
    {
        return cases.GetError();
    }
    if (const Result<void> usable = CheckCharts(options.charts, NamesOf(*cases), options.force);
        !usable)
    {
        return usable.GetError();
    }
    std::vector<AccuracyResult> results;
    for (const AccuracyCase& info : *cases)
    {
        results.push_back(*std::find_if(all->begin(), all->end(), [&](const auto& result) {
            return result.info.name == info.name;
        }));
        if (const Result<void> written = WriteCharts(options, results.back()); !written)
        {
            return written.GetError();
        }
    }
    return Show(options, results);
}

} // namespace

Result<int> RunBenchAccuracy(const BenchOptions& options)
{
    if (!options.from.empty())
    {
        return ShowEarlier(options);
    }
    const Result<std::vector<std::filesystem::path>> programs =
        PresentPrograms(FindBenchPrograms());
    if (!programs)
    {
        return programs.GetError();
    }
    const Result<std::vector<AccuracyCase>> all = ListAccuracyCases(programs->front());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintNames(*all);
    }
    const Result<std::vector<AccuracyCase>> cases =
        Choose(*all, options.scenes, "boxreel bench --accuracy --list");
    if (!cases)
    {
        return cases.GetError();
    }
    if (const Result<void> usable = CheckCharts(options.charts, NamesOf(*cases), options.force);
        !usable)
    {
        return usable.GetError();
    }
    return RunCases(options, *programs, *cases);
}

} // namespace boxreel
