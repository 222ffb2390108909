// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"
#include "FieldRange.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace boxreel
{
namespace
{

constexpr double kMostSettings = 1e6; // iterations, steps: what Integer tells apart

/// The errors of what bursts are large, those of what is exact small.
constexpr FieldRange kRanges[] = {{"velocityIterations", 1.0, kMostSettings},
                                  {"positionIterations", 1.0, kMostSettings},
                                  {"hz", 1.0, kMostSettings},
                                  {"subSteps", 1.0, kMostSettings},
                                  {"velocityIterationsOfASubStep", 1.0, kMostSettings},
                                  {"positionIterationsOfASubStep", 1.0, kMostSettings},
                                  {"cpuSecondsOfAStep", kSmallest, kLongest},
                                  {"error", 1e-100, 1e100},
                                  {"goal", 1e-100, 1e100},
                                  {"least", 1e-100, 1e100},
                                  {"most", 1e-100, 1e100}};

Json NumberOrNull(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json RunJson(const AccuracyFigures& run)
{
    Json json{{"engine", run.engine},
              {"velocityIterations", run.settings.velocityIterations},
              {"positionIterations", run.settings.positionIterations},
              {"hz", run.settings.hz},
              {"subSteps", run.settings.subSteps}};
    if (!run.failure.empty())
    {
        json["failure"] = run.failure;
        return json;
    }
    json["velocityIterationsOfASubStep"] = run.each.velocity;
    json["positionIterationsOfASubStep"] = run.each.position;
    json["error"] = NumberOrNull(run.error);
    json["cpuSecondsOfAStep"] = run.cpu;
    json["cpuSecondsOfAFrame"] = run.CpuOfAFrame();
    json["held"] = run.held;
    json["ending"] = run.ending;
    Json remarks = Json::object();
    for (const auto& [name, value] : run.remarks)
    {
        remarks[name] = NumberOrNull(value);
    }
    json["remarks"] = remarks;
    return json;
}

/// What both a program's line and a file's entry say of a run.
AccuracyFigures RunFrom(const Json& json, const char* cpu)
{
    AccuracyFigures run;
    run.engine = Text(json, "engine");
    run.failure = Text(json, "failure");
    run.cpu = Number(json, cpu, 0.0);
    run.steps = Integer(json, "steps", 0);
    run.settings = {Integer(json, "velocityIterations", 0), Integer(json, "positionIterations", 0),
                    Integer(json, "hz", 60), Integer(json, "subSteps", 1)};
    run.each = {Integer(json, "velocityIterationsOfASubStep", 0),
                Integer(json, "positionIterationsOfASubStep", 0)};
    run.error = Number(json, "error", kNoValue); // null is what is no number
    run.held = json.is_object() && json.contains("held") && json["held"] == true;
    run.ending = Text(json, "ending");
    if (json.is_object() && json.contains("remarks") && json["remarks"].is_object())
    {
        for (const auto& [name, value] : json["remarks"].items())
        {
            run.remarks.emplace_back(name, value.is_number() ? value.get<double>() : kNoValue);
        }
    }
    return run;
}

bool IsRun(const AccuracyFigures& run)
{
    return !run.engine.empty() && (run.cpu > 0.0 || !run.failure.empty()) && run.settings.hz > 0 &&
           run.settings.subSteps > 0;
}

Json GoalsOf(const Json& json)
{
    const bool has = json.is_object() && json.contains("goals") && json["goals"].is_array();
    return has ? json["goals"] : Json::array();
}

/// The first of a run's numbers that is there and is something else; the error may be null.
std::string NoNumberOf(const Json& run)
{
    for (const auto& item : run.items())
    {
        const std::string& name = item.key();
        const Json& value = item.value();
        const bool isRanged =
            std::any_of(std::begin(kRanges), std::end(kRanges),
                        [&](const FieldRange& known) { return name == known.name; });
        if (isRanged && !value.is_number() && !(name == "error" && value.is_null()))
        {
            return name;
        }
    }
    return "";
}

/// What is wrong with the numbers of a case, to be put behind the name of its file; empty: nothing.
std::string WrongNumberOf(const Json& json, const AccuracyResult& result)
{
    const auto isGoal = [](double goal) { return std::isfinite(goal) && goal >= 0.0; };
    bool goalsAreNumbers = isGoal(Number(json, "goal", kNoValue));
    for (const RemarkGoal& goal : result.info.remarkGoals)
    {
        goalsAreNumbers = goalsAreNumbers && !goal.name.empty() && isGoal(goal.bound);
    }
    if (!goalsAreNumbers)
    {
        return " has a goal for '" + result.info.name + "' that is no number from 0 on";
    }
    for (const Json& run : json["runs"])
    {
        const std::string name = NoNumberOf(run);
        if (!name.empty())
        {
            return " has '" + name + "' in '" + result.info.name + "' that is no number";
        }
    }
    return "";
}

/// A library may talk before.
std::string LastLine(const std::string& output)
{
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t start = output.rfind('\n', end);
    return output.substr(start == std::string::npos ? 0 : start + 1);
}

/// No name, or no runs: it is not a case.
AccuracyResult CaseFrom(const Json& json)
{
    AccuracyResult result;
    result.info.name = Text(json, "case");
    result.info.what = Text(json, "what");
    result.info.unit = Text(json, "unit");
    result.info.goal = Number(json, "goal", 0.0);
    for (const Json& goal : GoalsOf(json))
    {
        const bool isLeast = goal.is_object() && goal.contains("least");
        result.info.remarkGoals.push_back(
            {Text(goal, "remark"), Number(goal, isLeast ? "least" : "most", kNoValue), isLeast});
    }
    const bool hasRuns = json.is_object() && json.contains("runs") && json["runs"].is_array();
    for (const Json& entry : hasRuns ? json["runs"] : Json::array())
    {
        result.runs.push_back(RunFrom(entry, "cpuSecondsOfAStep"));
        if (!IsRun(result.runs.back()))
        {
            return {};
        }
    }
    return result;
}

} // namespace

Result<AccuracyFigures> ParseAccuracyFigures(const std::string& output)
{
    const std::string line = LastLine(output);
    AccuracyFigures figures = RunFrom(ParseJson(line), "cpu");
    if (!IsRun(figures) || !figures.failure.empty())
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no figures: '" + line + "'."};
    }
    return figures;
}

Result<double> ParseAccuracyTime(const std::string& output)
{
    const std::string line = LastLine(output);
    const double cpu = Number(ParseJson(line), "cpu", 0.0);
    if (!(cpu > 0.0))
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no time: '" + line + "'."};
    }
    return cpu;
}

std::string AccuracyJson(const std::vector<AccuracyResult>& results)
{
    Json cases = Json::array();
    for (const AccuracyResult& result : results)
    {
        Json runs = Json::array();
        for (const AccuracyFigures& run : result.runs)
        {
            runs.push_back(RunJson(run));
        }
        Json goals = Json::array();
        for (const RemarkGoal& goal : result.info.remarkGoals)
        {
            goals.push_back({{"remark", goal.name}, {goal.isLeast ? "least" : "most", goal.bound}});
        }
        cases.push_back({{"case", result.info.name},
                         {"what", result.info.what},
                         {"unit", result.info.unit},
                         {"goal", result.info.goal},
                         {"goals", goals},
                         {"runs", runs}});
    }
    return LinesOf(Json{{"cases", cases}});
}

Result<std::vector<AccuracyResult>> ParseAccuracyJson(const std::string& text,
                                                      const std::string& name)
{
    const Json json = ParseJson(text);
    if (const Result<void> sound =
            CheckFields(json, kRanges, name, "boxreel bench --accuracy --json");
        !sound)
    {
        return sound.GetError();
    }
    const bool isOurs = json.is_object() && json.contains("cases") && json["cases"].is_array();
    std::vector<AccuracyResult> results;
    for (const Json& entry : isOurs ? json["cases"] : Json::array())
    {
        results.push_back(CaseFrom(entry));
        if (results.back().info.name.empty() || results.back().runs.empty())
        {
            results.clear();
            break;
        }
        const std::string wrong = WrongNumberOf(entry, results.back());
        if (!wrong.empty())
        {
            return Error{ErrorKind::Unusable, "'" + name + "'" + wrong + "; make it again with " +
                                                  "`boxreel bench --accuracy --json`."};
        }
    }
    if (results.empty())
    {
        return Error{ErrorKind::Unusable,
                     "'" + name +
                         "' is not what `boxreel bench --accuracy --json` prints; make it again."};
    }
    return results;
}

} // namespace boxreel
