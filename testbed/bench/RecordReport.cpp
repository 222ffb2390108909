// SPDX-License-Identifier: MIT
#include "Format.h"
#include "RecordBench.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kLeastShown = 0.0005; // of a stage's CPU and wall time [ms]

/// Three digits, or as many places as there is use for.
std::string Digits(double value)
{
    const int places = value >= 100.0 ? 0 : value >= 10.0 ? 1 : value >= 1.0 ? 2 : 3;
    return std::isfinite(value) ? Format("%.*f", places, value) : "-";
}

std::string Cell(double value, bool isMissed, int width = 9)
{
    return Format(" %*s%s", width, Digits(value).c_str(), isMissed ? "!" : " ");
}

/// Does a goal whose name begins so, and that is this film's, stand and fail?
bool IsMissed(const std::vector<RecordGoal>& goals, RecordRole role, const std::string& beginning)
{
    return std::any_of(goals.begin(), goals.end(), [&](const RecordGoal& goal) {
        return goal.role == role && goal.what.starts_with(beginning) && !goal.IsMet();
    });
}

std::string Trimmed(const std::string& row)
{
    return row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
}

std::string Head()
{
    return Format("%-26s%7s %9s  %9s  %9s  %9s  %9s   %s\n", "method", "frames", "wall s", "CPU s",
                  "frames/s", "film MB", "memory MB", "film");
}

std::string Row(const RecordFigures& figures, const std::vector<RecordGoal>& goals)
{
    std::string row =
        Format("%-26s%7lld", figures.method.c_str(), static_cast<long long>(figures.frames));
    if (!figures.failure.empty())
    {
        return row + "  failed: " + figures.failure + "\n";
    }
    const auto missed = [&](const char* what) { return IsMissed(goals, figures.role, what); };
    row += Cell(figures.wall, missed("wall time") || missed("times faster"));
    row += Cell(figures.cpu, false);
    row += Cell(double(figures.frames) / figures.wall, missed("frames a second"));
    row += Cell(figures.bytes / 1e6, false);
    row += Cell(figures.memory / 1e6, missed("memory"));
    return Trimmed(row + "  " + figures.verdict);
}

std::string GoalLines(const std::vector<RecordGoal>& goals)
{
    std::string lines;
    for (const RecordGoal& goal : goals)
    {
        const std::string reached = std::isfinite(goal.reached)
                                        ? Format("%.3g%s", goal.reached, goal.unit.c_str())
                                        : "not measured";
        lines +=
            Format("%-13s%-29s %s, %s %.3g%s\n",
                   goal.IsMet() ? "goal met:" : "goal MISSED:", goal.what.c_str(), reached.c_str(),
                   goal.isAtLeast ? "at least" : "at most", goal.goal, goal.unit.c_str());
    }
    return lines;
}

std::string StageLines(const std::vector<RecordStage>& stages)
{
    if (stages.empty())
    {
        return "";
    }
    std::string lines =
        Format("%-26s%-9s %9s %9s\n", "where a frame's time goes", "thread", "CPU ms", "wall ms");
    double cpu = 0.0;
    for (const RecordStage& stage : stages)
    {
        cpu += stage.cpu;
        const double most = std::isfinite(stage.wall) ? std::max(stage.cpu, stage.wall) : stage.cpu;
        if (most * 1e3 >= kLeastShown)
        {
            lines += Trimmed(Format(
                "%-26s%-9s %9.3f %9s", stage.stage.c_str(), stage.thread.c_str(), stage.cpu * 1e3,
                std::isfinite(stage.wall) ? Format("%.3f", stage.wall * 1e3).c_str() : "-"));
        }
    }
    return lines + Format("%-26s%-9s %9.3f\n", "all", "", cpu * 1e3);
}

std::string Title(const RecordResult& result)
{
    const RecordCase& info = result.info;
    std::string title =
        Format("%s: %s, %d x %d", info.name.c_str(), info.what.c_str(), info.width, info.height);
    if (info.from > 0.0)
    {
        title += Format(", from %g s on", info.from);
    }
    if (std::isfinite(result.cached))
    {
        title += Format("; %.0f %% of the raw frames in the page cache", result.cached * 100.0);
    }
    return title + "\n";
}

/// Of the peer over ours; kNoValue where one of them is not there or not sound.
double Times(const RecordResult& result, RecordRole role, double RecordFigures::*field)
{
    const RecordFigures* const ours = FindRole(result, RecordRole::Ours);
    const RecordFigures* const peer = FindRole(result, role);
    const bool isGood =
        ours != nullptr && peer != nullptr && ours->verdict == "sound" && peer->verdict == "sound";
    return isGood ? peer->*field / ours->*field : kNoValue;
}

std::string Summary(const std::vector<RecordResult>& results)
{
    std::string text = "How many times more the others take than boxreel record:\n" +
                       Format("%-12s%32s%32s\n", "", "encoding raw frames only",
                              "immediate mode, pipe, encoding") +
                       Format("%-12s%12s%10s%10s%12s%10s%10s\n", "case", "wall", "CPU", "bytes",
                              "wall", "CPU", "bytes");
    for (const RecordResult& result : results)
    {
        text += Format("%-12s", result.info.name.c_str());
        for (const RecordRole role : {RecordRole::Encoding, RecordRole::Immediate})
        {
            text +=
                Format("%12s%10s%10s", Digits(Times(result, role, &RecordFigures::wall)).c_str(),
                       Digits(Times(result, role, &RecordFigures::cpu)).c_str(),
                       Digits(Times(result, role, &RecordFigures::bytes)).c_str());
        }
        text += "\n";
    }
    return text;
}

constexpr const char* kFootnote =
    R"(Each film is made by processes of their own, from a cold start to a closed file, and is decoded
and compared with the raw frames afterwards; figures are medians. CPU time and memory are those of
all processes together. All films are encoded by libx264, veryfast, crf 20, two threads; pictures
as PNG, level 1. ffmpeg alone is given frames that somebody else has drawn. Of the stages, waiting
is wall time only, and `codec` is what was done in threads of the codec's own, and whatever nobody
timed. A sign (!) stands where a goal is missed; goals compare wall times.
)";

} // namespace

std::string RecordTable(const std::vector<RecordResult>& results)
{
    std::string table;
    for (const RecordResult& result : results)
    {
        const std::vector<RecordGoal> goals = RecordGoals(result);
        table += Title(result) + Head();
        for (const RecordFigures& figures : result.methods)
        {
            table += Row(figures, goals);
        }
        table += GoalLines(goals) + StageLines(result.stages) + "\n";
    }
    return table + Summary(results) + "\n" + kFootnote;
}

} // namespace boxreel
