// SPDX-License-Identifier: MIT
#include "RenderBench.h"

#include "Benchmark.h"
#include "ChildProcess.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace boxreel
{
namespace
{

constexpr double RenderTimes::*kClocks[] = {&RenderTimes::cpu, &RenderTimes::wall,
                                            &RenderTimes::submit, &RenderTimes::read};

/// One program with one number of threads, and what each of its methods took in each round.
struct Entry
{
    std::filesystem::path program;
    std::string threads;
    std::vector<RenderFigures> errors;
    std::vector<std::vector<RenderFigures>> rounds;
    std::string failure;
};

/// What the program says to `words`, by method.
std::vector<RenderFigures> FiguresOf(Entry& entry, const std::vector<std::string>& words)
{
    const Result<std::string> output = OutputOf(entry.program, words);
    const Result<std::vector<RenderFigures>> methods =
        output ? ParseRenderLines(*output) : Result<std::vector<RenderFigures>>(output.GetError());
    entry.failure = methods ? entry.failure : methods.GetError().message;
    return methods ? *methods : std::vector<RenderFigures>();
}

/// The median of each time over the rounds, method by method; they come in the same order.
std::vector<RenderFigures> MedianOf(const Entry& entry)
{
    std::vector<RenderFigures> methods = entry.errors;
    for (std::size_t i = 0; i < methods.size(); ++i)
    {
        for (const std::vector<RenderFigures>& round : entry.rounds)
        {
            methods[i].by = round[i].by;
            methods[i].wrong = methods[i].wrong.empty() ? round[i].wrong : methods[i].wrong;
        }
        for (const RenderWork& work : RenderWorks())
        {
            for (double RenderTimes::*clock : kClocks)
            {
                std::vector<double> values;
                for (const std::vector<RenderFigures>& round : entry.rounds)
                {
                    const double value = (round[i].*work.times).*clock;
                    if (std::isfinite(value))
                    {
                        values.push_back(value);
                    }
                }
                (methods[i].*work.times).*clock =
                    values.empty() ? kNoValue : Median(std::move(values));
            }
        }
    }
    return methods;
}

bool HasSameMethods(const std::vector<RenderFigures>& a, const std::vector<RenderFigures>& b)
{
    bool same = a.size() == b.size() && !a.empty();
    for (std::size_t i = 0; same && i < a.size(); ++i)
    {
        same = a[i].method == b[i].method;
    }
    return same;
}

/// The methods of an entry, or one that says why there are none.
std::vector<RenderFigures> Summary(const Entry& entry)
{
    bool complete = entry.failure.empty();
    for (const std::vector<RenderFigures>& round : entry.rounds)
    {
        complete = complete && HasSameMethods(entry.errors, round);
    }
    if (complete)
    {
        return MedianOf(entry);
    }
    RenderFigures failed;
    failed.method = entry.program.filename().string();
    failed.failure = "failed";
    return {failed};
}

} // namespace

const std::vector<RenderWork>& RenderWorks()
{
    static const std::vector<RenderWork> works{{"full", "full", &RenderFigures::full},
                                               {"together", "together", &RenderFigures::together},
                                               {"apart", "apart", &RenderFigures::apart},
                                               {"none", "unchanged", &RenderFigures::none},
                                               {"empty", "empty", &RenderFigures::empty},
                                               {"floor", "clear+read", &RenderFigures::floor}};
    return works;
}

std::vector<std::filesystem::path> FindRenderPrograms()
{
    return FindPrograms({"boxreel_render_bench", "boxreel_render_bench_cairo"});
}

RenderCase ParseRenderCase(const std::string& line)
{
    RenderCase info;
    std::istringstream fields(line);
    std::getline(fields, info.name, '\t');
    std::getline(fields, info.what, '\t');
    for (std::string word; fields >> word;)
    {
        const std::size_t at = std::min(word.find('='), word.size());
        const std::string key = word.substr(0, at);
        const double number =
            std::strtod(word.substr(std::min(at + 1, word.size())).c_str(), nullptr);
        info.count = key == "count" ? int(number) : info.count;
        info.width = key == "width" ? int(number) : info.width;
        info.height = key == "height" ? int(number) : info.height;
        info.goalFull = key == "full" ? number : info.goalFull;
        info.goalChanged = key == "changed" ? number : info.goalChanged;
        info.goalNone = key == "none" ? number : info.goalNone;
        info.goalEmpty = key == "empty" ? number : info.goalEmpty;
        info.goalRms = key == "rms" ? number : info.goalRms;
    }
    return info;
}

Result<std::vector<RenderCase>> ListRenderCases(const std::filesystem::path& program)
{
    const Result<std::string> output = OutputOf(program, {"list"});
    if (!output)
    {
        return output.GetError();
    }
    std::vector<RenderCase> cases;
    std::istringstream lines(*output);
    for (std::string line; std::getline(lines, line);)
    {
        cases.push_back(ParseRenderCase(line));
    }
    return cases;
}

RenderResult RunRenderCase(const std::vector<std::filesystem::path>& programs,
                           const RenderCase& info, int rounds)
{
    std::vector<Entry> entries;
    for (const std::filesystem::path& program : programs)
    {
        Entry entry{program, "0", {}, {}, {}};
        entry.errors = FiguresOf(entry, {"error", info.name});
        entries.push_back(entry);
        if (entries.size() == 1)
        {
            if (!entry.failure.empty())
            {
                break; // without ours there is nothing to compare
            }
            entry.threads = "own"; // its bits, and so its errors, are the same
            entries.push_back(entry);
        }
    }
    for (int round = 0; round < rounds; ++round)
    {
        for (Entry& entry : entries)
        {
            if (entry.failure.empty()) // once is enough to be told why
            {
                entry.rounds.push_back(FiguresOf(entry, {"time", info.name, entry.threads}));
            }
        }
    }
    RenderResult result{info, {}};
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
        for (RenderFigures& figures : Summary(entries[i]))
        {
            figures.isOurs = i < 2;
            figures.threads = entries[i].threads;
            result.methods.push_back(std::move(figures));
        }
    }
    return result;
}

std::vector<RenderGoal> RenderGoals(const RenderResult& result)
{
    const RenderCase& info = result.info;
    std::vector<RenderGoal> goals;
    for (const RenderFigures& f : result.methods)
    {
        if (!f.isOurs || f.threads != "0" || !f.failure.empty())
        {
            continue;
        }
        goals = {{"full redraw", " ms", info.goalFull * 1e3, f.full.cpu * 1e3},
                 {"5 % changed together", " ms", info.goalChanged * 1e3, f.together.cpu * 1e3},
                 {"5 % changed apart", " ms", info.goalChanged * 1e3, f.apart.cpu * 1e3},
                 {"unchanged", " ms", info.goalNone * 1e3, f.none.cpu * 1e3},
                 {"empty over clear and read", "", info.goalEmpty, f.EmptyRatio()},
                 {"RMSE at edges", "", info.goalRms, f.rms}};
        break;
    }
    std::erase_if(goals, [](const RenderGoal& goal) { return goal.goal <= 0.0; });
    return goals;
}

} // namespace boxreel
