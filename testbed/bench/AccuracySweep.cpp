// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"

#include "ChildProcess.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace boxreel
{

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
        if (!key.empty() && (key.back() == '<' || key.back() == '>'))
        {
            info.remarkGoals.push_back({key.substr(0, key.size() - 1),
                                        std::strtod(value.c_str(), nullptr), key.back() == '>'});
        }
    }
    return info;
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

} // namespace boxreel
