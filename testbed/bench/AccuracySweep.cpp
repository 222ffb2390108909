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

namespace
{

constexpr double kLongRun = 0.3; ///< is not timed again: a sweep takes minutes [s]

struct AccuracyJob
{
    std::filesystem::path program;
    AccuracyFigures figures;
};

std::vector<std::string> WordsOf(const std::string& name, const AccuracySettings& settings)
{
    return {"accuracy",
            name,
            std::to_string(settings.velocityIterations),
            std::to_string(settings.positionIterations),
            std::to_string(settings.hz),
            std::to_string(settings.subSteps)};
}

/// Without figures.
AccuracyFigures Failed(const std::filesystem::path& program, const AccuracySettings& settings)
{
    AccuracyFigures failed;
    failed.engine = program.filename().string();
    failed.settings = settings;
    failed.failure = "failed";
    return failed;
}

void RunFirst(AccuracyJob& job, const std::string& name)
{
    const AccuracySettings settings = job.figures.settings;
    const Result<std::string> output = OutputOf(job.program, WordsOf(name, settings));
    const Result<AccuracyFigures> figures =
        output ? ParseAccuracyFigures(*output) : Result<AccuracyFigures>(output.GetError());
    job.figures = figures ? *figures : Failed(job.program, settings);
}

void TimeAgain(AccuracyJob& job, const std::string& name)
{
    AccuracyFigures& figures = job.figures;
    if (!figures.failure.empty() || figures.steps < 1 || figures.cpu * figures.steps >= kLongRun)
    {
        return;
    }
    std::vector<std::string> words = WordsOf(name, figures.settings);
    words.push_back(std::to_string(figures.steps));
    const Result<std::string> output = OutputOf(job.program, words);
    const Result<double> cpu =
        output ? ParseAccuracyTime(*output) : Result<double>(output.GetError());
    figures.cpu = std::min(figures.cpu, cpu ? *cpu : figures.cpu);
    figures.failure = cpu ? "" : "failed";
}

/// Every program's next setting in turn.
std::vector<AccuracyJob*> InTurn(std::vector<std::vector<AccuracyJob>>& jobs)
{
    std::vector<AccuracyJob*> turn;
    std::size_t left = 1;
    for (std::size_t i = 0; left > 0; ++i)
    {
        left = 0;
        for (std::vector<AccuracyJob>& ofProgram : jobs)
        {
            if (i < ofProgram.size())
            {
                turn.push_back(&ofProgram[i]);
                ++left;
            }
        }
    }
    return turn;
}

} // namespace

Result<AccuracyResult> RunAccuracySweep(const std::vector<std::filesystem::path>& programs,
                                        const AccuracyCase& info, int rounds)
{
    std::vector<std::vector<AccuracyJob>> jobs;
    for (const std::filesystem::path& program : programs)
    {
        // Every program knows all cases, but not the same sub-steps.
        const Result<std::vector<AccuracyCase>> cases = ListAccuracyCases(program);
        if (!cases || cases->empty())
        {
            return cases ? Error{ErrorKind::Failed,
                                 program.string() + " lists no accuracy case; build it again."}
                         : cases.GetError();
        }
        jobs.emplace_back();
        for (const AccuracySettings& settings : AccuracySweep(cases->front().mostSubSteps))
        {
            jobs.back().push_back({program, Failed(program, settings)});
        }
    }
    const std::vector<AccuracyJob*> turn = InTurn(jobs);
    for (int round = 0; round < rounds; ++round)
    {
        for (AccuracyJob* job : turn)
        {
            round == 0 ? RunFirst(*job, info.name) : TimeAgain(*job, info.name);
        }
    }
    AccuracyResult result{info, {}};
    for (const std::vector<AccuracyJob>& ofProgram : jobs)
    {
        for (const AccuracyJob& job : ofProgram)
        {
            result.runs.push_back(job.figures);
        }
    }
    return result;
}

} // namespace boxreel
