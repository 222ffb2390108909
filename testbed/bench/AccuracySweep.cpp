// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"

#include "ChildProcess.h"
#include "JsonFields.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace boxreel
{
namespace
{

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
    json["error"] = std::isfinite(run.error) ? Json(run.error) : Json(nullptr);
    json["cpuSecondsOfAStep"] = run.cpu;
    json["cpuSecondsOfAFrame"] = run.CpuOfAFrame();
    json["held"] = run.held;
    Json remarks = Json::object();
    for (const auto& [name, value] : run.remarks)
    {
        remarks[name] = std::isfinite(value) ? Json(value) : Json(nullptr);
    }
    json["remarks"] = remarks;
    return json;
}

} // namespace

AccuracyCase ParseAccuracyCase(const std::string& line)
{
    AccuracyCase info;
    std::istringstream fields(line);
    std::getline(fields, info.name, '\t');
    std::getline(fields, info.what, '\t');
    for (std::string word; fields >> word;)
    {
        const std::size_t at = std::min(word.find('='), word.size());
        const std::string key = word.substr(0, at);
        const std::string value = word.substr(std::min(at + 1, word.size()));
        info.unit = key == "unit" ? value : info.unit;
        info.goal = key == "goal" ? std::strtod(value.c_str(), nullptr) : info.goal;
        info.mostSubSteps = key == "sub-steps" ? std::atoi(value.c_str()) : info.mostSubSteps;
    }
    return info;
}

Result<AccuracyFigures> ParseAccuracyFigures(const std::string& output)
{
    const std::size_t end = output.find_last_not_of('\n');
    const std::size_t start = output.rfind('\n', end);
    const std::string line = output.substr(start == std::string::npos ? 0 : start + 1);
    const Json json = Json::parse(line, nullptr, false);
    AccuracyFigures figures;
    figures.engine = Text(json, "engine");
    figures.cpu = Number(json, "cpu", 0.0);
    if (figures.engine.empty() || figures.cpu <= 0.0)
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no figures: '" + line + "'."};
    }
    figures.settings = {int(Number(json, "velocityIterations", 0.0)),
                        int(Number(json, "positionIterations", 0.0)), int(Number(json, "hz", 60.0)),
                        int(Number(json, "subSteps", 1.0))};
    figures.error = Number(json, "error", kNoValue); // it prints null for what is no number
    figures.held = json.contains("held") && json["held"] == true;
    if (json.contains("remarks") && json["remarks"].is_object())
    {
        for (const auto& [name, value] : json["remarks"].items())
        {
            figures.remarks.emplace_back(name, value.is_number() ? value.get<double>() : kNoValue);
        }
    }
    return figures;
}

Result<std::vector<AccuracyCase>> ListAccuracyCases(const std::filesystem::path& program)
{
    const Result<std::string> output = OutputOf(program, {"accuracy-list"});
    if (!output)
    {
        return output.GetError();
    }
    std::vector<AccuracyCase> cases;
    std::istringstream lines(*output);
    for (std::string line; std::getline(lines, line);)
    {
        cases.push_back(ParseAccuracyCase(line));
    }
    return cases;
}

std::vector<AccuracySettings> AccuracySweep(int mostSubSteps)
{
    constexpr std::pair<int, int> kIterations[] = {{4, 2}, {8, 3}, {20, 10}, {50, 20}};
    std::vector<AccuracySettings> sweep;
    for (const auto& [velocity, position] : kIterations)
    {
        for (const int hz : {60, 120, 240, 480})
        {
            for (int subSteps = 1; subSteps <= std::min(mostSubSteps, 16); subSteps *= 2)
            {
                sweep.push_back({velocity, position, hz, subSteps});
            }
        }
    }
    return sweep;
}

AccuracyFigures RunAccuracyCase(const std::filesystem::path& program, const std::string& name,
                                const AccuracySettings& settings)
{
    const Result<std::string> output =
        OutputOf(program, {"accuracy", name, std::to_string(settings.velocityIterations),
                           std::to_string(settings.positionIterations), std::to_string(settings.hz),
                           std::to_string(settings.subSteps)});
    const Result<AccuracyFigures> figures =
        output ? ParseAccuracyFigures(*output) : Result<AccuracyFigures>(output.GetError());
    if (figures)
    {
        return *figures;
    }
    AccuracyFigures failed;
    failed.engine = program.filename().string();
    failed.settings = settings;
    failed.failure = "failed";
    return failed;
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
        cases.push_back({{"case", result.info.name},
                         {"what", result.info.what},
                         {"unit", result.info.unit},
                         {"goal", result.info.goal},
                         {"runs", runs}});
    }
    return Json{{"cases", cases}}.dump(2) + "\n";
}

} // namespace boxreel
