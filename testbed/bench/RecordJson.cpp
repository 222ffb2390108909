// SPDX-License-Identifier: MIT
#include "FieldRange.h"
#include "RecordBench.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace boxreel
{
namespace
{

/// Fields by name.
constexpr std::pair<const char*, double RecordFigures::*> kFigures[] = {
    {"wallSeconds", &RecordFigures::wall},
    {"cpuSeconds", &RecordFigures::cpu},
    {"memoryBytes", &RecordFigures::memory},
    {"filmBytes", &RecordFigures::bytes}};

constexpr std::pair<const char*, double RecordCase::*> kGoals[] = {
    {"goalOverEncoding", &RecordCase::goalOverEncoding},
    {"goalOverImmediate", &RecordCase::goalOverImmediate},
    {"goalFramesPerSecond", &RecordCase::goalRate},
    {"goalTimesFaster", &RecordCase::goalTimesFaster},
    {"goalMemoryBytes", &RecordCase::goalMemory},
    {"goalGrowthBytes", &RecordCase::goalGrowth}};

constexpr FieldRange kRanges[] = {{"wallSeconds", kSmallest, kLongest},
                                  {"cpuSeconds", kSmallest, kLongest},
                                  {"fromSeconds", kSmallest, kLongest},
                                  {"memoryBytes", 1.0, kLargest},
                                  {"filmBytes", 1.0, kLargest},
                                  {"cached", kSmallest, kLargest},
                                  {"frames", 1.0, kMostOf},
                                  {"width", 1.0, kMostOf},
                                  {"height", 1.0, kMostOf},
                                  {"goalOverEncoding", kSmallest, kLargest},
                                  {"goalOverImmediate", kSmallest, kLargest},
                                  {"goalFramesPerSecond", kSmallest, kLargest},
                                  {"goalTimesFaster", kSmallest, kLargest},
                                  {"goalMemoryBytes", kSmallest, kLargest},
                                  {"goalGrowthBytes", kSmallest, kLargest}};

constexpr const char* kDefinition =
    "processes from a cold start to a closed film, medians; memory: most that was resident at "
    "once; stages: of a frame of boxreel's film";

constexpr RecordRole kRoles[] = {RecordRole::Ours,        RecordRole::Start, RecordRole::Moving,
                                 RecordRole::MovingStart, RecordRole::Long,  RecordRole::Encoding,
                                 RecordRole::Immediate};

std::optional<RecordRole> RoleOf(const std::string& name)
{
    const auto found = std::find_if(std::begin(kRoles), std::end(kRoles),
                                    [&](RecordRole role) { return name == RoleName(role); });
    return found != std::end(kRoles) ? std::optional<RecordRole>(*found) : std::nullopt;
}

const Json& Member(const Json& json, const char* name)
{
    static const Json kNothing;
    return json.is_object() && json.contains(name) ? json[name] : kNothing;
}

const Json& Array(const Json& json, const char* name)
{
    static const Json kEmpty = Json::array();
    const Json& member = Member(json, name);
    return member.is_array() ? member : kEmpty;
}

Json FiguresJson(const RecordFigures& figures)
{
    Json json{
        {"role", RoleName(figures.role)}, {"method", figures.method}, {"frames", figures.frames}};
    if (!figures.failure.empty())
    {
        json["failure"] = figures.failure;
        return json;
    }
    json["verdict"] = figures.verdict;
    for (const auto& [name, field] : kFigures)
    {
        if (std::isfinite(figures.*field))
        {
            json[name] = figures.*field;
        }
    }
    return json;
}

/// None when it is not of a film.
std::optional<RecordFigures> FiguresFrom(const Json& json)
{
    const std::optional<RecordRole> role = RoleOf(Text(json, "role"));
    if (!role)
    {
        return std::nullopt;
    }
    RecordFigures figures;
    figures.role = *role;
    figures.method = Text(json, "method");
    figures.frames = Integer(json, "frames", 0);
    figures.verdict = Text(json, "verdict");
    figures.failure = Text(json, "failure");
    for (const auto& [name, field] : kFigures)
    {
        figures.*field = Number(json, name, kNoValue);
    }
    const bool isComplete =
        figures.frames > 0 && !figures.method.empty() &&
        (!figures.failure.empty() || (figures.wall > 0.0 && figures.cpu >= 0.0 &&
                                      figures.bytes >= 0.0 && !figures.verdict.empty()));
    return isComplete ? std::optional<RecordFigures>(figures) : std::nullopt;
}

Json StageJson(const RecordStage& stage)
{
    Json json{{"stage", stage.stage}, {"thread", stage.thread}, {"cpuSeconds", stage.cpu}};
    if (std::isfinite(stage.wall))
    {
        json["wallSeconds"] = stage.wall;
    }
    return json;
}

/// `share`: of the numbers, such as one frame's of a whole film's.
std::optional<RecordStage> StageFrom(const Json& json, double share)
{
    const double cpu = Number(json, "cpuSeconds", kNoValue);
    const RecordStage stage{Text(json, "stage"), Text(json, "thread"), cpu * share,
                            Number(json, "wallSeconds", kNoValue) * share};
    return cpu >= 0.0 && !stage.stage.empty() ? std::optional<RecordStage>(stage) : std::nullopt;
}

/// None when it is not a case.
std::optional<RecordResult> ResultFrom(const Json& json)
{
    RecordResult result;
    RecordCase& info = result.info;
    info.name = Text(json, "case");
    info.what = Text(json, "what");
    info.scene = Text(json, "scene");
    info.frames = Integer(json, "frames", 0);
    info.width = Integer(json, "width", 0);
    info.height = Integer(json, "height", 0);
    info.from = Number(json, "fromSeconds", 0.0);
    info.isPictures = Member(json, "pictures") == true;
    result.cached = Number(json, "cached", kNoValue);
    for (const auto& [name, field] : kGoals)
    {
        info.*field = Number(json, name, 0.0);
    }
    for (const Json& entry : Array(json, "methods"))
    {
        const std::optional<RecordFigures> figures = FiguresFrom(entry);
        if (!figures)
        {
            return std::nullopt;
        }
        result.methods.push_back(*figures);
    }
    for (const Json& entry : Array(json, "stages"))
    {
        const std::optional<RecordStage> stage = StageFrom(entry, 1.0);
        if (!stage)
        {
            return std::nullopt;
        }
        result.stages.push_back(*stage);
    }
    const bool isComplete = !info.name.empty() && info.frames > 0 && info.width > 0 &&
                            info.height > 0 && !result.methods.empty();
    return isComplete ? std::optional<RecordResult>(std::move(result)) : std::nullopt;
}

Json ResultJson(const RecordResult& result)
{
    const RecordCase& info = result.info;
    Json json{{"case", info.name},        {"what", info.what},          {"scene", info.scene},
              {"frames", info.frames},    {"width", info.width},        {"height", info.height},
              {"fromSeconds", info.from}, {"pictures", info.isPictures}};
    for (const auto& [name, field] : kGoals)
    {
        if (info.*field > 0.0)
        {
            json[name] = info.*field;
        }
    }
    if (std::isfinite(result.cached))
    {
        json["cached"] = result.cached;
    }
    json["methods"] = Json::array();
    for (const RecordFigures& figures : result.methods)
    {
        json["methods"].push_back(FiguresJson(figures));
    }
    json["stages"] = Json::array();
    for (const RecordStage& stage : result.stages)
    {
        json["stages"].push_back(StageJson(stage));
    }
    for (const RecordGoal& goal : RecordGoals(result))
    {
        json["goalsMet"][goal.what] = goal.IsMet();
    }
    return json;
}

} // namespace

Result<FilmCheck> ParseFilmCheck(const std::string& output)
{
    const Json json = ParseJson(output);
    const FilmCheck check{Integer(json, "frames", -1), Integer(json, "width", 0),
                          Integer(json, "height", 0), Number(json, "drawnError", kNoValue),
                          Number(json, "groundError", kNoValue)};
    if (check.frames < 0 || check.width < 1 || check.height < 1)
    {
        return Error{ErrorKind::Failed, "The film was not checked: '" + output + "'."};
    }
    return check;
}

Result<std::vector<RecordStage>> ParseStages(const std::string& output)
{
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
    {
        const Json json = ParseJson(line);
        const double frames = Number(json, "frames", 0.0);
        if (Text(json, "event") != "stages" || !(frames > 0.0))
        {
            continue;
        }
        std::vector<RecordStage> stages;
        for (const Json& entry : Array(json, "stages"))
        {
            if (const std::optional<RecordStage> stage = StageFrom(entry, 1.0 / frames))
            {
                stages.push_back(*stage);
            }
        }
        if (!stages.empty())
        {
            return stages;
        }
    }
    return Error{ErrorKind::Failed, "`boxreel record --stats` did not say where its time went."};
}

std::string RecordJson(const std::vector<RecordResult>& results)
{
    Json cases = Json::array();
    for (const RecordResult& result : results)
    {
        cases.push_back(ResultJson(result));
    }
    return LinesOf(Json{{"recording", kDefinition}, {"cases", cases}});
}

Result<std::vector<RecordResult>> ParseRecordJson(const std::string& text, const std::string& name)
{
    const Json json = ParseJson(text);
    if (const Result<void> sound =
            CheckFields(json, kRanges, name, "boxreel bench --record --json");
        !sound)
    {
        return sound.GetError();
    }
    std::vector<RecordResult> results;
    bool isGood = true;
    for (const Json& entry : Array(json, "cases"))
    {
        std::optional<RecordResult> result = ResultFrom(entry);
        isGood = isGood && result.has_value();
        if (result)
        {
            results.push_back(std::move(*result));
        }
    }
    if (!isGood || results.empty())
    {
        return Error{ErrorKind::Unusable,
                     "'" + name +
                         "' is not what `boxreel bench --record --json` prints; make it again."};
    }
    return results;
}

} // namespace boxreel
