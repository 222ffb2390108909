// SPDX-License-Identifier: MIT
#pragma once

#include "Sim.h"

#include <functional>
#include <string>
#include <vector>

/// What is timed, the same for every engine. Sizes in metres; friction 0.6, density 1 and
/// restitution 0 unless said.
namespace bench
{

/// A box that everything which moves has to stay in.
struct Bounds
{
    double left = -1e4, bottom = -1e4, right = 1e4, top = 1e4;
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
    /// What one call does when it is not a step.
    std::function<void(Sim&, int call)> action;
    /// Steps until all sleep before anything is timed.
    bool untilAsleep = false;
};

const std::vector<Scene>& AllScenes();

} // namespace bench
