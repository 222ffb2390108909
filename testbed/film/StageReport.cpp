// SPDX-License-Identifier: MIT
#include "StageReport.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace boxreel
{
namespace
{

constexpr double kNotOneThread = std::numeric_limits<double>::quiet_NaN();

struct Row
{
    const char* stage;
    const char* thread;
    double cpu = 0.0;            // of the film [s]
    double wall = kNotOneThread; // of the film [s]
};

struct Known
{
    Stage stage;
    const char* name;
    const char* thread;
};

constexpr Known kKnown[] = {{Stage::Simulate, "simulating", "main"},
                            {Stage::Collect, "collecting", "main"},
                            {Stage::Draw, "drawing", "main"},
                            {Stage::Read, "reading pixels", "main"},
                            {Stage::Copy, "copying pixels", "main"},
                            {Stage::WaitForEncoder, "waiting for the encoder", "main"},
                            {Stage::WaitForFrame, "waiting for a frame", "encoder"},
                            {Stage::Convert, "converting colours", "encoder"},
                            {Stage::Encode, "encoding", "encoder"},
                            {Stage::Write, "writing", "encoder"}};

/// Returns the numbers after the name of a program or thread in a file of /proc. The name may
/// contain anything.
std::vector<double> NumbersOf(const std::string& stat)
{
    std::vector<double> numbers;
    std::istringstream words(stat.substr(std::min(stat.size(), stat.rfind(')') + 1)));
    std::string state;
    words >> state;
    for (double number = 0.0; words >> number;)
    {
        numbers.push_back(number);
    }
    return numbers;
}

std::string FirstLine(const std::filesystem::path& file)
{
    std::string line;
    std::getline(std::ifstream(file) >> std::ws, line);
    return line;
}

double Seconds(clockid_t clock)
{
    timespec time{};
    clock_gettime(clock, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double TicksPerSecond()
{
    return double(std::max(1L, sysconf(_SC_CLK_TCK)));
}

/// The stages in the order in which a frame goes through them, then the time that no stage
/// measures.
std::vector<Row> RowsOf(const StageTimes& stages, const FilmTimes& times)
{
    std::vector<Row> rows{{"starting", "main", times.before.cpu, times.before.wall}};
    double rest = times.end.cpu - times.before.cpu - times.raster;
    for (const Known& known : kKnown)
    {
        const StageTime time = stages.At(known.stage);
        rows.push_back({known.name, known.thread, time.cpu, time.wall});
        rest -= time.cpu;
        if (known.stage == Stage::Draw)
        {
            rows.push_back({"drawing", "raster", times.raster, kNotOneThread});
        }
    }
    rows.push_back({"encoding, and the rest", "codec", std::max(0.0, rest), kNotOneThread});
    return rows;
}

std::string Line(const char* stage, const char* thread, double cpu, double wall)
{
    char text[120], last[20] = "";
    if (std::isfinite(wall))
    {
        std::snprintf(last, sizeof last, "%10.3f", wall);
    }
    std::snprintf(text, sizeof text, "\n  %-24s  %-8s%10.3f%s", stage, thread, cpu, last);
    return text;
}

} // namespace

ProcessTime ProcessSoFar()
{
    constexpr std::size_t kStartTime = 18; // the 22nd field of a stat, counted after the third
    const std::vector<double> numbers = NumbersOf(FirstLine("/proc/self/stat"));
    const double start =
        numbers.size() > kStartTime ? numbers[kStartTime] / TicksPerSecond() : kNotOneThread;
    return {Seconds(CLOCK_PROCESS_CPUTIME_ID), Seconds(CLOCK_BOOTTIME) - start};
}

double RasterSeconds()
{
    constexpr std::size_t kUser = 10, kSystem = 11; // the 14th and 15th field, counted likewise
    double ticks = 0.0;
    std::error_code error;
    const std::filesystem::directory_iterator tasks("/proc/self/task", error);
    for (const auto& task : tasks)
    {
        if (FirstLine(task.path() / "comm").starts_with("llvmpipe"))
        {
            const std::vector<double> numbers = NumbersOf(FirstLine(task.path() / "stat"));
            ticks += numbers.size() > kSystem ? numbers[kUser] + numbers[kSystem] : 0.0;
        }
    }
    return ticks / TicksPerSecond();
}

std::string DescribeStages(const StageTimes& stages, const FilmTimes& times)
{
    const double perFrame = 1e3 / double(std::max<std::int64_t>(times.frames, 1));
    std::string text = "Time per frame [ms]:\n"
                       "  stage                     thread         CPU      wall";
    for (const Row& row : RowsOf(stages, times))
    {
        text += Line(row.stage, row.thread, row.cpu * perFrame, row.wall * perFrame);
    }
    return text + Line("all", "", times.end.cpu * perFrame, times.end.wall * perFrame);
}

std::string StageJson(const StageTimes& stages, const FilmTimes& times)
{
    std::string text =
        "{\"event\":\"stages\",\"frames\":" + std::to_string(times.frames) + ",\"stages\":[";
    const char* separator = "";
    for (const Row& row : RowsOf(stages, times))
    {
        char one[200];
        std::snprintf(one, sizeof one, "%s{\"stage\":\"%s\",\"thread\":\"%s\",\"cpuSeconds\":%.6f",
                      separator, row.stage, row.thread, row.cpu);
        text += one;
        if (std::isfinite(row.wall))
        {
            std::snprintf(one, sizeof one, ",\"wallSeconds\":%.6f", row.wall);
            text += one;
        }
        text += "}";
        separator = ",";
    }
    return text + "]}";
}

} // namespace boxreel
