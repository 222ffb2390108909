// SPDX-License-Identifier: MIT
#pragma once

#include "Sim.h"

#include <functional>
#include <string>
#include <vector>

/// The scenes that are timed, the same for every engine. Sizes in metres; friction 0.6, density 1
/// and restitution 0 unless stated otherwise.
namespace bench
{

/// A box that everything which moves has to stay in.
struct Bounds
{
    double left = -1e4, bottom = -1e4, right = 1e4, top = 1e4;
};

/// Totals of the results of calls. They show that the calls had an effect, and the same effect in
/// every engine.
struct Found
{
    double count = 0.0;
    double sum = 0.0;

    void Add(const Found& more)
    {
        count += more.count;
        sum += more.sum;
    }
};

/// The property that must agree with the runs of the peers, beside the contacts.
enum class Likeness
{
    Heights, ///< of the bodies on average, and how deep they overlap
    Speeds,  ///< of the bodies on average: energy kept where nothing comes to rest
};

struct Scene
{
    std::string name;
    std::string what;
    SimSettings settings;
    /// Fills the world.
    std::function<void(Sim&)> build;
    int warmup = 0; ///< steps that are not timed
    int steps = 0;  ///< timed steps; each alone when it takes long, in blocks when `block` is set
    int block = 1;  ///< calls between two looks at the clock
    Bounds bounds;
    /// Performs one call if that is not a step.
    std::function<Found(Sim&, int call)> action;
    /// Once after all that is timed: shows that a world that nothing was seen of is a working one.
    std::function<Found(Sim&)> afterwards;
    std::string found; ///< what the counts of these are of, one word
    /// Steps until all sleep before anything is timed.
    bool untilAsleep = false;
    int sleepers = 0; ///< bodies that must be asleep all the time that is measured
    Likeness likeness = Likeness::Heights;

    /// Scenes of one curve differ only in `count`, what the cost of a step must not grow with.
    std::string curve;
    int count = 0;
    bool onlyForCurve = false; ///< not run unless named, or for the curve
};

const std::vector<Scene>& AllScenes();

} // namespace bench
