// SPDX-License-Identifier: MIT
#pragma once

#include "Sim.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

/// The accuracy benchmark, the same for every engine. Each case builds a small world, measures it
/// after each step, and returns its error in its own unit. Does not measure time; AccuracyRun times
/// the steps.
namespace bench
{

/// A second number of a run, beside the error.
struct Figure
{
    std::string name; ///< with its unit: "gap_mm"
    double value = 0.0;
};

struct Outcome
{
    double error = 0.0; ///< in the unit of the case; smaller is better
    std::vector<Figure> figures;
    std::string ending{}; ///< "falls", "bursts": what no error tells; empty: as it should
};

/// One run of a case: made, built, stepped and judged once.
class Experiment
{
public:
    virtual ~Experiment() = default;

    virtual void Build(Sim& sim) = 0;
    /// After each step; `time` since the start [s].
    virtual void Look(Sim& sim, double time) = 0;
    /// After the last step.
    virtual Outcome Judge(Sim& sim) = 0;
};

struct AccuracyCase
{
    std::string name; ///< the letter of its group first
    std::string what;
    std::string unit;     ///< of the error
    double seconds = 0.0; ///< that are simulated
    double gravity = -10.0;
    std::function<std::unique_ptr<Experiment>()> make;
};

using AccuracyCases = std::vector<AccuracyCase>;

/// Free flight, sliding, bouncing, slow motion far away: AccuracyMotion.cpp.
void AppendMotionCases(AccuracyCases& cases);
/// Pendulums, chains, a pair that spins: AccuracyJoints.cpp.
void AppendJointCases(AccuracyCases& cases);
/// Stacks and the card house: AccuracyStacks.cpp.
void AppendPileCases(AccuracyCases& cases);
/// The cradle, and bodies too fast for its walls: AccuracyImpacts.cpp.
void AppendImpactCases(AccuracyCases& cases);

/// Group by group, A to K and then X, which is continuous collision.
const AccuracyCases& AllAccuracyCases();

} // namespace bench
