// SPDX-License-Identifier: MIT
#include "BenchChoice.h"
#include "Commands.h"
#include "StopSignals.h"
#include "WorkFolder.h"

#include <bench/RecordBench.h>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

const std::vector<std::string> kCharts{"speed", "stages"};

std::vector<RecordCase> CasesOf(const std::vector<RecordResult>& results)
{
    std::vector<RecordCase> cases;
    for (const RecordResult& result : results)
    {
        cases.push_back(result.info);
    }
    return cases;
}

Result<std::vector<RecordCase>> Choose(const std::vector<RecordCase>& all,
                                       const BenchOptions& options)
{
    if (const Result<void> usable = CheckCharts(options.charts, kCharts, options.force); !usable)
    {
        return usable.GetError();
    }
    if (!options.scenes.empty())
    {
        const std::string list =
            "boxreel bench --record --list" +
            (options.from.empty() ? std::string() : " --from " + options.from.string());
        return ChooseByName(all, options.scenes, "case of recording", list);
    }
    std::vector<RecordCase> cases;
    std::copy_if(all.begin(), all.end(), std::back_inserter(cases),
                 [](const RecordCase& info) { return !info.isOptional; });
    return cases;
}

Result<void> WriteCharts(const BenchOptions& options, const std::vector<RecordResult>& results)
{
    for (const std::filesystem::path& path : options.charts)
    {
        for (const std::string& name : kCharts)
        {
            const Result<BarChart> chart =
                name == "speed" ? RecordSpeedChart(results) : RecordStageChart(results);
            const Result<void> written =
                chart ? WriteChart(Chart(*chart), ChartPathFor(path, name), options.force)
                      : Result<void>(chart.GetError());
            if (!written)
            {
                return written;
            }
        }
    }
    return {};
}

Result<int> Show(const BenchOptions& options, const std::vector<RecordResult>& results)
{
    Result<void> done = WriteOutput(options.json ? RecordJson(results) : RecordTable(results));
    done = done ? WriteCharts(options, results) : done;
    return done ? Result<int>(0) : Result<int>(done.GetError());
}

/// What --from names, of the chosen cases.
Result<int> ShowEarlier(const BenchOptions& options)
{
    const Result<std::string> text = ReadFigures(options.from, "boxreel bench --record --json");
    const Result<std::vector<RecordResult>> all =
        text ? ParseRecordJson(*text, options.from.string())
             : Result<std::vector<RecordResult>>(text.GetError());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintNames(CasesOf(*all));
    }
    const Result<std::vector<RecordCase>> cases = Choose(CasesOf(*all), options);
    if (!cases)
    {
        return cases.GetError();
    }
    std::vector<RecordResult> results;
    for (const RecordCase& info : *cases)
    {
        results.push_back(*std::find_if(all->begin(), all->end(), [&](const auto& result) {
            return result.info.name == info.name;
        }));
    }
    return Show(options, results);
}

RecordSize FilmedSize(const BenchOptions& options)
{
    const PixelSize size = options.size.value_or(PixelSize{0, 0});
    return {options.frames, size.width, size.height};
}

Result<int> RunCases(const BenchOptions& options, const RecordPrograms& programs,
                     const std::vector<RecordCase>& cases)
{
    const Result<WorkFolder> folder = WorkFolder::Create();
    if (!folder)
    {
        return folder.GetError();
    }
    if (programs.encoder.empty())
    {
        WriteMessage("Films are made by boxreel only and compared with nothing: ffmpeg does not "
                     "run here; install Debian's ffmpeg.");
    }
    const StopSignals stopSignals; // frames and films are removed, whatever comes
    std::vector<RecordResult> results;
    for (const RecordCase& one : cases)
    {
        const RecordCase info = Resized(one, FilmedSize(options));
        WriteMessage(info.name + ": " + info.what);
        Result<RecordResult> result = RunRecordCase(programs, info, options.rounds, folder->Path(),
                                                    [] { return StopSignals::Caught() != 0; });
        if (StopSignals::Caught() != 0)
        {
            break; // the cases before are shown
        }
        if (!result)
        {
            return result.GetError();
        }
        for (const RecordFigures& figures : result->methods)
        {
            if (!figures.failure.empty())
            {
                WriteMessage(figures.failure);
            }
        }
        results.push_back(std::move(*result));
    }
    return results.empty()
               ? Result<int>(Error{ErrorKind::Failed, "Stopped before the first case was done."})
               : Show(options, results);
}

} // namespace

Result<int> RunBenchRecord(const BenchOptions& options)
{
    if (!options.from.empty())
    {
        return ShowEarlier(options);
    }
    if (options.list)
    {
        return PrintNames(AllRecordCases());
    }
    const Result<std::vector<RecordCase>> cases = Choose(AllRecordCases(), options);
    if (!cases)
    {
        return cases.GetError();
    }
    const Result<RecordPrograms> programs = FindRecordPrograms();
    return programs ? RunCases(options, *programs, *cases) : Result<int>(programs.GetError());
}

} // namespace boxreel
