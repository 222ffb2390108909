// SPDX-License-Identifier: MIT
// One engine's program: `list`, or `run SCENE [THREADS]`, which prints one line of JSON. `boxreel
// bench` runs the programs of all engines in turn.
#include "Scenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace bench
{
namespace
{

/// Of the whole process, so that workers count [s].
double CpuTime()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

double WallTime()
{
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

/// Resident memory at present [kB].
long ResidentMemory()
{
    std::ifstream file("/proc/self/statm");
    long total = 0, resident = 0;
    file >> total >> resident;
    return resident * 4;
}

/// What a run must have in common with those of the other engines.
struct Verdict
{
    bool finite = true;
    int escaped = 0;
    double meanHeight = 0.0;
    double highest = -1e30;
    double meanSpeed = 0.0;
};

Verdict Judge(const Sim& sim, const Bounds& bounds)
{
    Verdict verdict;
    int count = 0;
    for (BodyId body = 0; body < sim.BodyCount(); ++body)
    {
        const BodyState s = sim.State(body);
        if (!s.dynamic)
        {
            continue;
        }
        ++count;
        verdict.finite = verdict.finite && std::isfinite(s.x + s.y + s.angle + s.vx + s.vy + s.w);
        verdict.escaped += !(s.x >= bounds.left && s.x <= bounds.right && s.y >= bounds.bottom &&
                             s.y <= bounds.top);
        verdict.meanHeight += s.y;
        verdict.highest = std::max(verdict.highest, s.y);
        verdict.meanSpeed += std::hypot(s.vx, s.vy);
    }
    verdict.meanHeight /= std::max(1, count);
    verdict.meanSpeed /= std::max(1, count);
    return verdict;
}

struct Timing
{
    std::vector<double> calls; ///< wall time of each call, or the mean of its block [s]
    double cpu = 0.0;          ///< of a call, on average [s]
};

Timing Time(Sim& sim, const Scene& scene)
{
    const auto act = [&](int call) { scene.action ? scene.action(sim, call) : sim.Step(); };
    Timing timing;
    timing.calls.reserve(std::size_t(scene.steps / scene.block));
    const double cpu = CpuTime();
    for (int call = 0; call < scene.steps; call += scene.block)
    {
        const double start = WallTime();
        for (int i = 0; i < scene.block; ++i)
        {
            act(call + i);
        }
        timing.calls.push_back((WallTime() - start) / scene.block);
    }
    timing.cpu = (CpuTime() - cpu) / scene.steps;
    return timing;
}

double Mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
    {
        sum += value;
    }
    return sum / double(values.size());
}

/// `sorted` from small to large.
double Quantile(const std::vector<double>& sorted, double share)
{
    return sorted[std::size_t(share * double(sorted.size() - 1) + 0.5)];
}

int Run(const Scene& scene, int threads)
{
    const long before = ResidentMemory();
    SimSettings settings = scene.settings;
    settings.threads = threads;
    const std::unique_ptr<Sim> sim = CreateSim(settings);
    scene.build(*sim);
    for (int step = 0; scene.untilAsleep && !sim->AllAsleep() && step < 3000; ++step)
    {
        sim->Step();
    }
    for (int step = 0; step < scene.warmup; ++step)
    {
        sim->Step();
    }
    Timing timing = Time(*sim, scene);
    const long memory = ResidentMemory() - before;
    const Verdict verdict = Judge(*sim, scene.bounds);
    const double mean = Mean(timing.calls);
    std::sort(timing.calls.begin(), timing.calls.end());
    std::printf("{\"engine\":\"%s\",\"scene\":\"%s\",\"threads\":%d,\"calls\":%d,\"mean\":%.9g,"
                "\"median\":%.9g,\"p99\":%.9g,\"worst\":%.9g,\"cpu\":%.9g,\"contacts\":%d,"
                "\"memory\":%ld,\"finite\":%s,\"escaped\":%d,\"meanHeight\":%.9g,\"highest\":%.9g,"
                "\"meanSpeed\":%.9g,\"asleep\":%s}\n",
                EngineName().c_str(), scene.name.c_str(), threads, scene.steps, mean,
                Quantile(timing.calls, 0.5), Quantile(timing.calls, 0.99), timing.calls.back(),
                timing.cpu, sim->TouchingContacts(), memory, verdict.finite ? "true" : "false",
                verdict.escaped, verdict.meanHeight, verdict.highest, verdict.meanSpeed,
                sim->AllAsleep() ? "true" : "false");
    return 0;
}

int List()
{
    for (const Scene& scene : AllScenes())
    {
        std::printf("%s\t%s\n", scene.name.c_str(), scene.what.c_str());
    }
    return 0;
}

} // namespace
} // namespace bench

int main(int count, char** words)
{
    if (count == 2 && std::strcmp(words[1], "list") == 0)
    {
        return bench::List();
    }
    if (count >= 3 && std::strcmp(words[1], "run") == 0)
    {
        for (const bench::Scene& scene : bench::AllScenes())
        {
            if (scene.name == words[2])
            {
                return bench::Run(scene, count > 3 ? std::max(1, std::atoi(words[3])) : 1);
            }
        }
        std::fprintf(stderr, "No scene is called '%s'; `list` names them all.\n", words[2]);
        return 1;
    }
    std::fprintf(stderr, "Usage: %s list | run SCENE [THREADS]\n", words[0]);
    return 1;
}
