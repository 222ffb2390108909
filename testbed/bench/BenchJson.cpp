// SPDX-License-Identifier: MIT
#include "Benchmark.h"
#include "FieldRange.h"

#include <cmath>

namespace boxreel
{
namespace
{

/// Of a world that burst overlap, height and speed may be anything.
constexpr FieldRange kRanges[] = {{"meanSeconds", kSmallest, kLongest},
                                  {"medianSeconds", kSmallest, kLongest},
                                  {"p99Seconds", kSmallest, kLongest},
                                  {"cpuSeconds", kSmallest, kLongest},
                                  {"threads", 1.0, 1e6},
                                  {"contacts", kSmallest, kMostOf},
                                  {"memoryKilobytes", -kLargest, kLargest},
                                  {"escaped", kSmallest, kMostOf},
                                  {"awake", kSmallest, kMostOf},
                                  {"bodies", kSmallest, kMostOf},
                                  {"found", kSmallest, kLargest},
                                  {"count", 1.0, kMostOf},
                                  {"goalTimesFaster", kSmallest, kLargest},
                                  {"goalSeconds", kSmallest, kLongest},
                                  {"goalSpeedUpOfTwoThreads", kSmallest, kLargest},
                                  {"goalMemoryKilobytes", kSmallest, kLargest}};

bool Flag(const Json& json, const char* name)
{
    return json.is_object() && json.contains(name) && json[name] == true;
}

/// The speed-up, and whether the goals that this row has are met.
void AddGoals(Json& json, const BenchResult& result, const BenchFigures& e)
{
    const double speedUp = SpeedUp(result, e);
    const double speedUpGoal = SpeedUpGoal(result.scene, e);
    const double memoryGoal = MemoryGoal(result.scene, e);
    if (speedUp > 0.0)
    {
        json["speedUp"] = speedUp;
    }
    if (speedUp > 0.0 && speedUpGoal > 0.0)
    {
        json["speedUpGoalMet"] = speedUp >= speedUpGoal;
    }
    if (memoryGoal > 0.0)
    {
        json["memoryGoalMet"] = e.memory <= memoryGoal;
    }
}

Json EngineJson(const BenchResult& result, const BenchFigures& e)
{
    const BenchFigures& first = result.engines.front();
    Json json{
        {"engine", e.engine}, {"ours", e.isOurs}, {"threads", e.threads}, {"verdict", e.verdict}};
    if (!e.failure.empty())
    {
        json["failure"] = e.failure;
        return json;
    }
    json.update({{"meanSeconds", e.mean},
                 {"medianSeconds", e.median},
                 {"p99Seconds", e.p99},
                 {"cpuSeconds", e.cpu},
                 {"contacts", std::isfinite(e.contacts) ? Json(e.contacts) : Json(nullptr)},
                 {"memoryKilobytes", e.memory},
                 {"finite", e.finite},
                 {"escaped", e.escaped},
                 {"awake", e.awake},
                 {"overlapMetres", e.overlap},
                 {"meanHeightMetres", e.meanHeight},
                 {"meanSpeedMetresPerSecond", e.meanSpeed},
                 {"bodies", e.bodies},
                 {"found", e.found},
                 {"foundSum", e.foundSum},
                 {"bits", e.bits}});
    json[IsLikePeers(first) ? "wallRatio" : "wallRatioNotComparable"] = WallRatio(first, e);
    json[IsLikePeers(first) ? "cpuRatio" : "cpuRatioNotComparable"] = CpuRatio(first, e);
    AddGoals(json, result, e);
    return json;
}

BenchFigures EngineFrom(const Json& json)
{
    BenchFigures e;
    e.engine = Text(json, "engine");
    e.isOurs = Flag(json, "ours");
    e.threads = int(Number(json, "threads", 1.0));
    e.failure = Text(json, "failure");
    e.mean = Number(json, "meanSeconds", 0.0);
    e.median = Number(json, "medianSeconds", 0.0);
    e.p99 = Number(json, "p99Seconds", 0.0);
    e.cpu = Number(json, "cpuSeconds", 0.0);
    e.contacts = Number(json, "contacts", std::nan(""));
    e.memory = Number(json, "memoryKilobytes", 0.0);
    e.finite = Flag(json, "finite");
    e.escaped = Number(json, "escaped", 0.0);
    e.awake = Number(json, "awake", 0.0);
    e.overlap = Number(json, "overlapMetres", 0.0);
    e.meanHeight = Number(json, "meanHeightMetres", 0.0);
    e.meanSpeed = Number(json, "meanSpeedMetresPerSecond", 0.0);
    e.bodies = Number(json, "bodies", 0.0);
    e.found = Number(json, "found", 0.0);
    e.foundSum = Number(json, "foundSum", 0.0);
    e.bits = Text(json, "bits");
    return e;
}

Json SceneJson(const BenchScene& scene)
{
    Json json{{"scene", scene.name}, {"what", scene.what}};
    if (scene.goalTimesFaster > 0.0)
    {
        json["goalTimesFaster"] = scene.goalTimesFaster;
    }
    if (scene.goalSeconds > 0.0)
    {
        json["goalSeconds"] = scene.goalSeconds;
    }
    if (scene.goalSpeedUp > 0.0)
    {
        json["goalSpeedUpOfTwoThreads"] = scene.goalSpeedUp;
    }
    if (scene.goalMemory > 0.0)
    {
        json["goalMemoryKilobytes"] = scene.goalMemory;
    }
    if (!scene.curve.empty())
    {
        json.update({{"curve", scene.curve}, {"count", scene.count}});
    }
    if (!scene.found.empty())
    {
        json["found"] = scene.found;
    }
    json["comparesSpeeds"] = scene.comparesSpeeds;
    return json;
}

BenchScene SceneFrom(const Json& json)
{
    BenchScene scene;
    scene.name = Text(json, "scene");
    scene.what = Text(json, "what");
    scene.goalTimesFaster = Number(json, "goalTimesFaster", 0.0);
    scene.goalSeconds = Number(json, "goalSeconds", 0.0);
    scene.goalSpeedUp = Number(json, "goalSpeedUpOfTwoThreads", 0.0);
    scene.goalMemory = Number(json, "goalMemoryKilobytes", 0.0);
    scene.curve = Text(json, "curve");
    scene.count = Number(json, "count", 0.0);
    scene.found = Text(json, "found");
    scene.comparesSpeeds = Flag(json, "comparesSpeeds");
    return scene;
}

} // namespace

Result<BenchFigures> ParseFigures(const std::string& output)
{
    // A library may talk before; the figures are the last line.
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t start = output.rfind('\n', end);
    const std::string line = output.substr(start == std::string::npos ? 0 : start + 1);
    const Json json = ParseJson(line);
    BenchFigures figures;
    bool complete = true;
    const std::pair<const char*, double BenchFigures::*> numbers[] = {
        {"mean", &BenchFigures::mean},     {"median", &BenchFigures::median},
        {"p99", &BenchFigures::p99},       {"cpu", &BenchFigures::cpu},
        {"memory", &BenchFigures::memory}, {"escaped", &BenchFigures::escaped},
        {"awake", &BenchFigures::awake},
    };
    for (const auto& [name, number] : numbers)
    {
        figures.*number = Number(json, name, std::nan(""));
        complete = complete && std::isfinite(figures.*number);
    }
    figures.engine = Text(json, "engine");
    if (!complete || figures.engine.empty())
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no figures: '" + line + "'."};
    }
    // Of a world that burst these may not be numbers.
    figures.contacts = Number(json, "contacts", std::nan(""));
    figures.overlap = Number(json, "overlap", 0.0);
    figures.meanHeight = Number(json, "meanHeight", 0.0);
    figures.meanSpeed = Number(json, "meanSpeed", 0.0);
    figures.bodies = Number(json, "bodies", 0.0);
    figures.found = Number(json, "found", 0.0);
    figures.foundSum = Number(json, "foundSum", 0.0);
    figures.threads = int(Number(json, "threads", 1.0));
    figures.finite = Flag(json, "finite");
    figures.bits = Text(json, "bits");
    return figures;
}

std::string BenchJson(const std::vector<BenchResult>& results)
{
    Json scenes = Json::array();
    for (const BenchResult& result : results)
    {
        Json scene = SceneJson(result.scene);
        scene["engines"] = Json::array();
        for (const BenchFigures& engine : result.engines)
        {
            scene["engines"].push_back(EngineJson(result, engine));
        }
        scenes.push_back(std::move(scene));
    }
    return LinesOf(Json{{"scenes", scenes}});
}

Result<std::vector<BenchResult>> ParseBenchJson(const std::string& text, const std::string& name)
{
    const Json json = ParseJson(text);
    if (const Result<void> sound = CheckFields(json, kRanges, name, "boxreel bench --json"); !sound)
    {
        return sound.GetError();
    }
    const bool isOurs = json.is_object() && json.contains("scenes") && json["scenes"].is_array();
    std::vector<BenchResult> results;
    for (const Json& scene : isOurs ? json["scenes"] : Json::array())
    {
        BenchResult result{SceneFrom(scene), {}};
        if (scene.is_object() && scene.contains("engines") && scene["engines"].is_array())
        {
            for (const Json& engine : scene["engines"])
            {
                result.engines.push_back(EngineFrom(engine));
            }
        }
        if (result.scene.name.empty() || result.engines.empty() || !result.engines.front().isOurs)
        {
            results.clear();
            break;
        }
        Judge(result);
        results.push_back(std::move(result));
    }
    if (results.empty())
    {
        return Error{ErrorKind::Unusable,
                     "'" + name + "' is not what `boxreel bench --json` prints; make it again."};
    }
    return results;
}

} // namespace boxreel
