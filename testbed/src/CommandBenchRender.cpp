// SPDX-License-Identifier: MIT
#include "BenchChoice.h"
#include "Commands.h"

#include <bench/RenderBench.h>
#include <render/FigureFrame.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// 720p: the charts' name for a size.
std::string SizeOf(const RenderCase& info)
{
    return std::to_string(info.height) + "p";
}

/// Each once, in the order of the cases.
std::vector<std::string> SizesOf(const std::vector<RenderCase>& cases)
{
    std::vector<std::string> sizes;
    for (const RenderCase& info : cases)
    {
        if (std::find(sizes.begin(), sizes.end(), SizeOf(info)) == sizes.end())
        {
            sizes.push_back(SizeOf(info));
        }
    }
    return sizes;
}

std::vector<RenderCase> CasesOf(const std::vector<RenderResult>& results)
{
    std::vector<RenderCase> cases;
    for (const RenderResult& result : results)
    {
        cases.push_back(result.info);
    }
    return cases;
}

Result<std::vector<RenderCase>> Choose(const std::vector<RenderCase>& all,
                                       const BenchOptions& options)
{
    const std::string list =
        "boxreel bench --render --list" +
        (options.from.empty() ? std::string() : " --from " + options.from.string());
    Result<std::vector<RenderCase>> cases =
        options.scenes.empty() ? all : ChooseByName(all, options.scenes, "case of drawing", list);
    if (!cases)
    {
        return cases;
    }
    const Result<void> usable = CheckCharts(options.charts, SizesOf(*cases), options.force);
    return usable ? std::move(cases) : Result<std::vector<RenderCase>>(usable.GetError());
}

Result<void> WriteCharts(const BenchOptions& options, const std::vector<RenderResult>& results)
{
    if (options.charts.empty())
    {
        return {};
    }
    for (const std::string& size : SizesOf(CasesOf(results)))
    {
        std::vector<RenderResult> ofSize;
        std::copy_if(results.begin(), results.end(), std::back_inserter(ofSize),
                     [&](const RenderResult& result) { return SizeOf(result.info) == size; });
        const Result<LineChart> chart = RenderChart(ofSize);
        if (!chart)
        {
            return chart.GetError();
        }
        for (const std::filesystem::path& path : options.charts)
        {
            const Result<void> written =
                WriteChart(Chart(*chart), ChartPathFor(path, size), options.force);
            if (!written)
            {
                return written;
            }
        }
    }
    return {};
}

Result<int> Show(const BenchOptions& options, const std::vector<RenderResult>& results)
{
    Result<void> done = WriteOutput(options.json ? RenderJson(results) : RenderTable(results));
    done = done ? WriteCharts(options, results) : done;
    return done ? Result<int>(0) : Result<int>(done.GetError());
}

/// What --from names, of the chosen cases.
Result<int> ShowEarlier(const BenchOptions& options)
{
    const Result<std::string> text = ReadFigures(options.from, "boxreel bench --render --json");
    const Result<std::vector<RenderResult>> all =
        text ? ParseRenderJson(*text, options.from.string())
             : Result<std::vector<RenderResult>>(text.GetError());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintNames(CasesOf(*all));
    }
    const Result<std::vector<RenderCase>> cases = Choose(CasesOf(*all), options);
    if (!cases)
    {
        return cases.GetError();
    }
    std::vector<RenderResult> results;
    for (const RenderCase& info : *cases)
    {
        results.push_back(*std::find_if(all->begin(), all->end(), [&](const auto& result) {
            return result.info.name == info.name;
        }));
    }
    return Show(options, results);
}

Result<int> RunCases(const BenchOptions& options,
                     const std::vector<std::filesystem::path>& programs,
                     const std::vector<RenderCase>& cases)
{
    if (programs.size() < 2)
    {
        WriteMessage("Cairo is not compared: it was not there when the benchmark was built; "
                     "install Debian's libcairo2-dev.");
    }
    std::vector<RenderResult> results;
    for (const RenderCase& info : cases)
    {
        WriteMessage(info.name + ": " + info.what);
        results.push_back(RunRenderCase(programs, info, options.rounds));
        if (!results.back().methods.front().failure.empty())
        {
            return Error{ErrorKind::Failed, "Drawing '" + info.name +
                                                "' failed, for the reason above; `boxreel shot` "
                                                "tells whether anything can be drawn here."};
        }
    }
    return Show(options, results);
}

} // namespace

Result<int> RunBenchRender(const BenchOptions& options)
{
    if (!options.from.empty())
    {
        return ShowEarlier(options);
    }
    const Result<std::vector<std::filesystem::path>> programs =
        PresentPrograms(FindRenderPrograms());
    if (!programs)
    {
        return programs.GetError();
    }
    const Result<std::vector<RenderCase>> all = ListRenderCases(programs->front());
    if (!all)
    {
        return all.GetError();
    }
    if (options.list)
    {
        return PrintNames(*all);
    }
    const Result<std::vector<RenderCase>> cases = Choose(*all, options);
    if (!cases)
    {
        return cases.GetError();
    }
    // The programs draw with what the environment says; what they lack is better said by us.
    const Result<void> draws = PrepareFrames(Backend::Auto);
    return draws ? RunCases(options, *programs, *cases) : Result<int>(draws.GetError());
}

} // namespace boxreel
