// SPDX-License-Identifier: MIT
#include "AccuracyRun.h"

#include "Accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

namespace bench
{
namespace
{

constexpr double kMinTimed = 0.02; ///< each time that the sweep comes round [s]
constexpr int kMaxNumber = 100000;

double CpuTime()
{
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

bool IsFinite(const Sim& sim)
{
    for (BodyId body = 0; body < sim.BodyCount(); ++body)
    {
        const BodyState s = sim.State(body);
        if (!std::isfinite(s.x + s.y + s.angle + s.vx + s.vy + s.w))
        {
            return false;
        }
    }
    return true;
}

struct Run
{
    Outcome outcome;
    int steps = 0;    ///< that it took: fewer than asked for when it broke
    bool held = true; ///< all numbers finite to the end
};

Run LookAtRun(const AccuracyCase& one, const SimSettings& settings)
{
    const std::unique_ptr<Sim> sim = CreateSim(settings);
    const std::unique_ptr<Experiment> experiment = one.make();
    experiment->Build(*sim);
    Run run;
    const int count = int(std::lround(one.seconds * settings.hz));
    while (run.held && run.steps < count)
    {
        sim->Step();
        ++run.steps;
        experiment->Look(*sim, double(run.steps) / settings.hz);
        run.held = IsFinite(*sim);
    }
    run.outcome = experiment->Judge(*sim);
    run.held = run.held && std::isfinite(run.outcome.error);
    return run;
}

/// Returns the duration of one run from its start [s].
double TimeRun(const AccuracyCase& one, const SimSettings& settings, int count)
{
    const std::unique_ptr<Sim> sim = CreateSim(settings);
    one.make()->Build(*sim);
    const double start = CpuTime();
    for (int i = 0; i < count; ++i)
    {
        sim->Step();
    }
    return CpuTime() - start;
}

/// Returns the mean duration of a step over the fastest of many runs [s]. All runs take the same
/// steps, so a slower one is slowed down by the machine.
double TimeSteps(const AccuracyCase& one, const SimSettings& settings, int count)
{
    double fastest = std::numeric_limits<double>::infinity();
    for (double spent = 0.0; spent < kMinTimed;)
    {
        const double run = TimeRun(one, settings, count);
        fastest = std::min(fastest, run);
        spent += run;
    }
    return fastest / count;
}

/// JSON has no other numbers.
std::string Number(double value)
{
    if (!std::isfinite(value))
    {
        return "null";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

/// Returns the number, from 1 on, or 0 for any other text.
int ParseNumber(const std::string& word)
{
    char* end = nullptr;
    const long number = std::strtol(word.c_str(), &end, 10);
    const bool isNumber = !word.empty() && *end == '\0' && number >= 1 && number <= kMaxNumber;
    return isNumber ? int(number) : 0;
}

void Print(const AccuracyCase& one, const SimSettings& settings, const Run& run, double cpu)
{
    std::printf("{\"engine\":\"%s\",\"case\":\"%s\",\"velocityIterations\":%d,"
                "\"positionIterations\":%d,\"hz\":%d,\"subSteps\":%d,",
                EngineName().c_str(), one.name.c_str(), settings.velocityIterations,
                settings.positionIterations, settings.hz, settings.subSteps);
    const Iterations each = IterationsOfASubStep(settings);
    std::printf("\"velocityIterationsOfASubStep\":%d,\"positionIterationsOfASubStep\":%d,",
                each.velocity, each.position);
    std::printf("\"error\":%s,\"unit\":\"%s\",\"steps\":%d,\"cpu\":%s,\"held\":%s,"
                "\"ending\":\"%s\",\"remarks\":{",
                Number(run.outcome.error).c_str(), one.unit.c_str(), run.steps, Number(cpu).c_str(),
                run.held ? "true" : "false",
                run.held ? run.outcome.ending.c_str() : "is no longer finite");
    const char* comma = "";
    for (const Figure& figure : run.outcome.figures)
    {
        std::printf("%s\"%s\":%s", comma, figure.name.c_str(), Number(figure.value).c_str());
        comma = ",";
    }
    std::printf("}}\n");
}

} // namespace

int ListAccuracy()
{
    for (const AccuracyCase& one : AllAccuracyCases())
    {
        std::printf("{\"case\":\"%s\",\"what\":\"%s\",\"unit\":\"%s\",\"maxSubSteps\":%d}\n",
                    one.name.c_str(), one.what.c_str(), one.unit.c_str(), MostSubSteps());
    }
    return 0;
}

int RunAccuracy(const std::string& name, const std::vector<std::string>& numbers)
{
    SimSettings settings;
    int steps = 0;
    int* const fields[] = {&settings.velocityIterations, &settings.positionIterations, &settings.hz,
                           &settings.subSteps, &steps};
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
        *fields[i] = ParseNumber(numbers[i]);
        if (*fields[i] == 0)
        {
            std::fprintf(stderr, "'%s' is not an integer from 1 to %d.\n", numbers[i].c_str(),
                         kMaxNumber);
            return 1;
        }
    }
    if (settings.subSteps > MostSubSteps())
    {
        std::fprintf(stderr, "%s takes at most %d sub-steps, not %d.\n", EngineName().c_str(),
                     MostSubSteps(), settings.subSteps);
        return 1;
    }
    for (const AccuracyCase& one : AllAccuracyCases())
    {
        if (one.name == name)
        {
            settings.gravity = one.gravity;
            if (steps > 0)
            {
                std::printf("{\"cpu\":%s}\n", Number(TimeSteps(one, settings, steps)).c_str());
                return 0;
            }
            const Run run = LookAtRun(one, settings);
            Print(one, settings, run, TimeSteps(one, settings, run.steps));
            return 0;
        }
    }
    std::fprintf(stderr, "No accuracy case is called '%s'; `accuracy-list` names them all.\n",
                 name.c_str());
    return 1;
}

} // namespace bench
