// SPDX-License-Identifier: MIT
#include "Benchmark.h"

#include "ChildProcess.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <unistd.h>

namespace boxreel
{
namespace
{

std::filesystem::path FolderOfThisProgram()
{
    std::error_code failure;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", failure);
    return failure ? std::filesystem::path() : self.parent_path();
}

double Median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// How far our contacts and heights may lie outside those of the peers: scenes are chaotic, and
/// engines keep different gaps.
constexpr double kContactsShare = 0.15;
constexpr double kHeightShare = 0.03;
constexpr double kHeightLeast = 0.1; // m

bool IsWithin(double value, const std::vector<double>& peers, double share, double least)
{
    const auto [low, high] = std::minmax_element(peers.begin(), peers.end());
    const double below = std::max(least, share * std::abs(*low));
    const double above = std::max(least, share * std::abs(*high));
    return value >= *low - below && value <= *high + above;
}

std::string JudgeAlone(const BenchFigures& figures)
{
    if (!figures.failure.empty())
    {
        return figures.failure;
    }
    if (!figures.finite)
    {
        return "not finite";
    }
    if (figures.escaped > 0.0)
    {
        return std::to_string(std::lround(figures.escaped)) + " escaped";
    }
    return "sound";
}

} // namespace

std::vector<std::filesystem::path> FindBenchPrograms()
{
    const std::filesystem::path folder = FolderOfThisProgram() / "tests" / "benchmark";
    std::vector<std::filesystem::path> programs;
    for (const char* name : {"boxreel_bench", "boxreel_bench_box2d", "boxreel_bench_chipmunk"})
    {
        const std::filesystem::path program = folder / name;
        if (access(program.c_str(), X_OK) == 0)
        {
            programs.push_back(program);
        }
        else if (programs.empty())
        {
            return {}; // without ours there is nothing to compare
        }
    }
    return programs;
}

Result<std::vector<BenchScene>> ListBenchScenes(const std::filesystem::path& program)
{
    const Result<std::string> output = OutputOf(program, {"list"});
    if (!output)
    {
        return output.GetError();
    }
    std::vector<BenchScene> scenes;
    std::istringstream lines(*output);
    for (std::string line; std::getline(lines, line);)
    {
        const std::size_t tab = line.find('\t');
        scenes.push_back(
            {line.substr(0, tab), tab == std::string::npos ? "" : line.substr(tab + 1)});
    }
    return scenes;
}

BenchFigures MedianOf(const std::vector<BenchFigures>& rounds)
{
    BenchFigures result = rounds.front();
    for (double BenchFigures::*number :
         {&BenchFigures::mean, &BenchFigures::median, &BenchFigures::p99, &BenchFigures::cpu,
          &BenchFigures::contacts, &BenchFigures::memory, &BenchFigures::escaped,
          &BenchFigures::meanHeight})
    {
        std::vector<double> values;
        for (const BenchFigures& round : rounds)
        {
            values.push_back(round.*number);
        }
        result.*number = Median(std::move(values));
    }
    for (const BenchFigures& round : rounds)
    {
        result.finite = result.finite && round.finite;
        result.failure = result.failure.empty() ? round.failure : result.failure;
    }
    return result;
}

BenchResult RunBenchScene(const std::vector<std::filesystem::path>& programs,
                          const BenchScene& scene, int rounds)
{
    std::vector<std::vector<BenchFigures>> measured(programs.size());
    for (int round = 0; round < rounds; ++round)
    {
        for (std::size_t i = 0; i < programs.size(); ++i)
        {
            const Result<std::string> output = OutputOf(programs[i], {"run", scene.name});
            Result<BenchFigures> figures =
                output ? ParseFigures(*output) : Result<BenchFigures>(output.GetError());
            if (!figures)
            {
                BenchFigures failed;
                failed.engine = programs[i].filename().string();
                failed.failure = "failed";
                figures = failed;
            }
            measured[i].push_back(*figures);
        }
    }
    BenchResult result{scene, {}};
    for (const std::vector<BenchFigures>& engine : measured)
    {
        result.engines.push_back(MedianOf(engine));
    }
    Judge(result.engines);
    return result;
}

void Judge(std::vector<BenchFigures>& engines)
{
    std::vector<double> contacts, heights;
    for (BenchFigures& engine : engines)
    {
        engine.verdict = JudgeAlone(engine);
        if (&engine != &engines.front() && engine.verdict == "sound")
        {
            contacts.push_back(engine.contacts);
            heights.push_back(engine.meanHeight);
        }
    }
    BenchFigures& ours = engines.front();
    if (ours.verdict != "sound" || contacts.empty())
    {
        return;
    }
    if (!IsWithin(ours.contacts, contacts, kContactsShare, 10.0))
    {
        ours.verdict = "other contacts";
    }
    else if (!IsWithin(ours.meanHeight, heights, kHeightShare, kHeightLeast))
    {
        ours.verdict = "other heights";
    }
}

double RatioTo(const BenchFigures& ours, const BenchFigures& other)
{
    const bool known = ours.failure.empty() && other.failure.empty() && ours.cpu > 0.0;
    return known ? other.cpu / ours.cpu : 0.0;
}

} // namespace boxreel
