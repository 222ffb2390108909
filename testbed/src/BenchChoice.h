// SPDX-License-Identifier: MIT
#pragma once

#include "OutputPath.h"
#include "Terminal.h"

#include <bench/Benchmark.h>
#include <bench/Chart.h>
#include <debugdraw/AtomicFile.h>
#include <debugdraw/Nearest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

/// What the ways to run the benchmark, engines by time and by error and drawing, have in common:
/// programs, lists and choices by name, and chart files. Entries have a `name` and a `what`.
namespace boxreel
{

/// What was found, ours first; an error when nothing was.
inline Result<std::vector<std::filesystem::path>>
PresentPrograms(std::vector<std::filesystem::path> programs)
{
    if (programs.empty())
    {
        return Error{ErrorKind::Absent, "The benchmark programs are not beside this program; run "
                                        "`./boxreel bench` in a checkout, which builds them."};
    }
    return programs;
}

/// The entries of these names, in their order. `kind` and `list` are for the error: what they are,
/// and the command that shows them.
template <class Entry>
Result<std::vector<Entry>> ChooseByName(const std::vector<Entry>& all,
                                        const std::vector<std::string>& names,
                                        const std::string& kind, const std::string& list)
{
    std::vector<std::string> known;
    for (const Entry& entry : all)
    {
        known.push_back(entry.name);
    }
    std::vector<Entry> chosen;
    for (const std::string& name : names)
    {
        const auto found = std::find(known.begin(), known.end(), name);
        if (found == known.end())
        {
            const int nearest = NearestWord(name, known);
            const std::string hint =
                nearest < 0 ? "" : " Did you mean '" + known[std::size_t(nearest)] + "'?";
            return Error{ErrorKind::Unusable, "No " + kind + " is called '" + name + "'; `" + list +
                                                  "` shows them." + hint};
        }
        if (std::count(names.begin(), names.end(), name) > 1)
        {
            return Error{ErrorKind::Unusable, "'" + name + "' is named twice; give it once."};
        }
        chosen.push_back(all[std::size_t(found - known.begin())]);
    }
    return chosen;
}

template <class Entry>
Result<int> PrintNames(const std::vector<Entry>& entries)
{
    std::size_t width = 0;
    for (const Entry& entry : entries)
    {
        width = std::max(width, entry.name.size());
    }
    std::string text;
    for (const Entry& entry : entries)
    {
        text += entry.name + std::string(width + 2 - entry.name.size(), ' ') + entry.what + "\n";
    }
    const Result<void> written = WriteOutput(text);
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

/// The text of a file; `maker` is the command that makes such files, for the error.
inline Result<std::string> ReadFigures(const std::filesystem::path& path, const std::string& maker)
{
    const std::string name = std::string("'").append(path.string()).append("'");
    const std::string remedy = "; name a file that `" + maker + "` made.";
    std::error_code ignored;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, ignored))
    {
        return Error{ErrorKind::Unusable, "Cannot read " + name + remedy};
    }
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad() || text.empty())
    {
        return Error{ErrorKind::Unusable,
                     file.bad() ? "Cannot read " + name + remedy : name + " is empty" + remedy};
    }
    return text;
}

/// The file of one chart of several: error.svg becomes error-A-projectile.svg.
inline std::filesystem::path ChartPathFor(const std::filesystem::path& chart,
                                          const std::string& name)
{
    std::filesystem::path path = chart;
    path.replace_filename(chart.stem().string() + "-" + name + chart.extension().string());
    return path;
}

/// Before minutes of work: whether each of these charts can be drawn and written.
inline Result<void> CheckCharts(const std::vector<std::filesystem::path>& charts,
                                const std::vector<std::string>& names, bool force)
{
    if (const Result<void> once = CheckNoneTwice(charts, "--chart"); !once)
    {
        return once;
    }
    for (const std::filesystem::path& chart : charts)
    {
        for (const std::string& name : names)
        {
            const Result<void> usable = CheckChartPath(ChartPathFor(chart, name), force);
            if (!usable)
            {
                return usable;
            }
        }
    }
    return charts.empty() ? Result<void>() : PrepareCharts();
}

/// PNG or SVG, as the file's name says.
inline Result<void> WriteChart(const Chart& chart, const std::filesystem::path& path, bool force)
{
    const ChartFormat format = path.extension() == ".png" ? ChartFormat::Png : ChartFormat::Svg;
    const Result<std::vector<std::uint8_t>> bytes = EncodeChart(chart, format);
    return bytes ? WriteWhole(path, *bytes, force) : Result<void>(bytes.GetError());
}

} // namespace boxreel
