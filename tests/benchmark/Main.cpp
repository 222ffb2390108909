// SPDX-License-Identifier: MIT
// One engine's program. `list` prints the scenes, `run SCENE [THREADS [SUBSTEPS]]` the figures of
// one, and the same for accuracy: `accuracy-list`, `accuracy CASE VELOCITY_ITERATIONS
// POSITION_ITERATIONS HZ SUBSTEPS [STEPS]`, with the last only to time. Output is JSON, one object
// per line. The runner (bench.py) runs the programs of all engines in turn.
#include "AccuracyRun.h"
#include "Scenes.h"

#include <algorithm>
#include <bit>
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

/// Returns the CPU time of the whole process, so workers count [s].
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

bool IsInside(const BodyState& s, const Bounds& bounds)
{
    return s.x >= bounds.left && s.x <= bounds.right && s.y >= bounds.bottom && s.y <= bounds.top;
}

bool IsFinite(const BodyState& s)
{
    return std::isfinite(s.x + s.y + s.angle + s.vx + s.vy + s.w);
}

/// The state at the end: what must be sound, and the same at every thread count.
struct EndState
{
    bool finite = true;
    int escaped = 0;
    int asleep = 0;
    double highest = -1e30;
    std::uint64_t bits = 14695981039346656037u; ///< FNV-1a of all numbers of all bodies
};

void AddBits(std::uint64_t& hash, double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 0; shift < 64; shift += 8)
    {
        hash = (hash ^ (bits >> shift & 0xffu)) * 1099511628211u;
    }
}

EndState Look(const Sim& sim, const Bounds& bounds)
{
    EndState end;
    for (BodyId body = 0; body < sim.BodyCount(); ++body)
    {
        const BodyState s = sim.State(body);
        if (!s.dynamic)
        {
            continue;
        }
        end.finite = end.finite && IsFinite(s);
        end.escaped += !IsInside(s, bounds);
        end.asleep += sim.IsAsleep(body);
        end.highest = std::max(end.highest, s.y);
        for (const double value : {s.x, s.y, s.angle, s.vx, s.vy, s.w})
        {
            AddBits(end.bits, value);
        }
    }
    return end;
}

/// Values compared with the runs of the other engines. Each is the mean of several samples in the
/// second half of a run, because a stirred stack varies from one moment to the next.
struct Likenesses
{
    int looks = 0;
    double contacts = 0.0;
    double overlap = 0.0; ///< root mean square of the points that overlap [m]
    double height = 0.0;  ///< of the dynamic bodies [m]
    double speed = 0.0;   ///< of the dynamic bodies [m/s]

    void Look(Sim& sim)
    {
        ++looks;
        const Touching touching = sim.LookAtContacts();
        Add(contacts, touching.pairs);
        Add(overlap, touching.Overlap());
        double heights = 0.0, speeds = 0.0;
        int count = 0;
        for (BodyId body = 0; body < sim.BodyCount(); ++body)
        {
            const BodyState s = sim.State(body);
            count += s.dynamic;
            heights += s.dynamic ? s.y : 0.0;
            speeds += s.dynamic ? std::hypot(s.vx, s.vy) : 0.0;
        }
        Add(height, heights / std::max(1, count));
        Add(speed, speeds / std::max(1, count));
    }

private:
    void Add(double& mean, double value) const { mean += (value - mean) / looks; }
};

constexpr int kLooks = 6; ///< at most, over half a run: each costs the next step its warm cache

/// JSON has no other numbers.
double Finite(double value)
{
    return std::isfinite(value) ? value : 0.0;
}

/// Not measured (not zero) if the simulation failed before.
std::string ContactsText(const Likenesses& like)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", Finite(like.contacts));
    return like.looks > 0 ? text : "null";
}

std::vector<BodyId> AwakeBodies(const Sim& sim)
{
    std::vector<BodyId> awake;
    for (BodyId body = 0; body < sim.BodyCount(); ++body)
    {
        if (sim.State(body).dynamic && !sim.IsAsleep(body))
        {
            awake.push_back(body);
        }
    }
    return awake;
}

struct Timing
{
    std::vector<double> calls; ///< wall time of each call, or the mean of its block [s]
    double cpu = 0.0;          ///< of a call, on average [s]
    int count = 0;             ///< calls made: fewer than the scene's when it broke
    Likenesses likenesses;
    Found found;
};

/// A world that has diverged need not run for minutes. Twice per simulated second, outside the
/// timed part, the bodies are checked that were awake at the start.
Timing Time(Sim& sim, const Scene& scene)
{
    const std::vector<BodyId> watched = AwakeBodies(sim);
    const auto isSound = [&](BodyId body) {
        const BodyState s = sim.State(body);
        return IsFinite(s) && IsInside(s, scene.bounds);
    };
    Timing timing;
    const auto act = [&](int call) {
        scene.action ? timing.found.Add(scene.action(sim, call)) : sim.Step();
    };
    timing.calls.reserve(std::size_t(scene.steps / scene.block));
    const int between = std::max(30, scene.block);
    int nextLook = scene.steps / 2;
    while (timing.count < scene.steps && std::all_of(watched.begin(), watched.end(), isSound))
    {
        const double cpu = CpuTime();
        for (const int end = std::min(timing.count + between, scene.steps); timing.count < end;)
        {
            const double start = WallTime();
            for (int i = 0; i < scene.block; ++i)
            {
                act(timing.count + i);
            }
            timing.calls.push_back((WallTime() - start) / scene.block);
            timing.count += scene.block;
        }
        timing.cpu += CpuTime() - cpu;
        if (timing.count > nextLook || timing.count == scene.steps)
        {
            timing.likenesses.Look(sim);
            nextLook += scene.steps / (2 * kLooks);
        }
    }
    timing.cpu /= std::max(1, timing.count);
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
    return sorted[std::size_t(std::lround(share * double(sorted.size() - 1)))];
}

bool AllAsleep(const Sim& sim)
{
    return AwakeBodies(sim).empty();
}

void Prepare(Sim& sim, const Scene& scene)
{
    scene.build(sim);
    for (int step = 0; scene.untilAsleep && !AllAsleep(sim) && step < 3000; ++step)
    {
        sim.Step();
    }
    for (int step = 0; step < scene.warmup; ++step)
    {
        sim.Step();
    }
}

/// Adds the results of the calls and of the checks afterwards. The bits count with those at the
/// end.
Found AllFound(Sim& sim, const Scene& scene, Found found, EndState& end)
{
    if (scene.afterwards)
    {
        found.Add(scene.afterwards(sim));
    }
    if (!scene.found.empty())
    {
        AddBits(end.bits, found.count);
        AddBits(end.bits, found.sum);
    }
    return found;
}

/// `subSteps`: 0 for those of the scene.
int Run(const Scene& scene, int threads, int subSteps)
{
    const long before = ResidentMemory();
    SimSettings settings = scene.settings;
    settings.threads = threads;
    settings.subSteps = subSteps > 0 ? std::min(subSteps, MostSubSteps()) : settings.subSteps;
    const std::unique_ptr<Sim> sim = CreateSim(settings);
    Prepare(*sim, scene);
    Timing timing = Time(*sim, scene);
    if (timing.calls.empty())
    {
        std::fprintf(stderr, "'%s' broke before anything was timed.\n", scene.name.c_str());
        return 1;
    }
    const long memory = ResidentMemory() - before;
    EndState end = Look(*sim, scene.bounds);
    const int bodies = sim->BodyCount();
    const Found found = AllFound(*sim, scene, timing.found, end);
    const Likenesses& like = timing.likenesses;
    const double mean = Mean(timing.calls);
    std::sort(timing.calls.begin(), timing.calls.end());
    std::printf("{\"engine\":\"%s\",\"scene\":\"%s\",\"threads\":%d,\"calls\":%d,\"mean\":%.9g,"
                "\"median\":%.9g,\"p99\":%.9g,\"worst\":%.9g,\"cpu\":%.9g,",
                EngineName().c_str(), scene.name.c_str(), sim->Threads(), timing.count, mean,
                Quantile(timing.calls, 0.5), Quantile(timing.calls, 0.99), timing.calls.back(),
                timing.cpu);
    std::printf("\"contacts\":%s,\"memory\":%ld,\"finite\":%s,\"escaped\":%d,\"awake\":%d,"
                "\"overlap\":%.9g,\"meanHeight\":%.9g,\"highest\":%.9g,\"meanSpeed\":%.9g,"
                "\"bodies\":%d,\"found\":%.9g,\"foundSum\":%.9g,\"bits\":\"%016llx\"}\n",
                ContactsText(like).c_str(), memory, end.finite ? "true" : "false", end.escaped,
                std::max(0, scene.sleepers - end.asleep), Finite(like.overlap), Finite(like.height),
                Finite(end.highest), Finite(like.speed), bodies, found.count, Finite(found.sum),
                static_cast<unsigned long long>(end.bits));
    return 0;
}

const char* Text(bool value)
{
    return value ? "true" : "false";
}

/// Prints the data of each scene that the runner needs.
int List()
{
    for (const Scene& scene : AllScenes())
    {
        std::printf("{\"case\":\"%s\",\"what\":\"%s\",\"curve\":\"%s\",\"count\":%d,"
                    "\"onlyNamed\":%s,\"found\":\"%s\",\"comparesSpeeds\":%s}\n",
                    scene.name.c_str(), scene.what.c_str(), scene.curve.c_str(), scene.count,
                    Text(scene.onlyForCurve), scene.found.c_str(),
                    Text(scene.likeness == Likeness::Speeds));
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
                return bench::Run(scene, count > 3 ? std::clamp(std::atoi(words[3]), 1, 64) : 1,
                                  count > 4 ? std::clamp(std::atoi(words[4]), 1, 64) : 0);
            }
        }
        std::fprintf(stderr, "No scene is called '%s'; `list` names them all.\n", words[2]);
        return 1;
    }
    if (count == 2 && std::strcmp(words[1], "accuracy-list") == 0)
    {
        return bench::ListAccuracy();
    }
    if ((count == 7 || count == 8) && std::strcmp(words[1], "accuracy") == 0)
    {
        return bench::RunAccuracy(words[2], {words + 3, words + count});
    }
    std::fprintf(stderr,
                 "Usage: %s list | run SCENE [THREADS [SUBSTEPS]] | accuracy-list | accuracy CASE "
                 "VELOCITY_ITERATIONS POSITION_ITERATIONS HZ SUBSTEPS [STEPS]\n",
                 words[0]);
    return 1;
}
