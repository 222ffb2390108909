// SPDX-License-Identifier: MIT
#pragma once

#include <render/Renderer.h>

#include <cstdint>
#include <string>

/// The rendering statistics of --stats: how much of a film or a picture was simulated and drawn.
namespace boxreel
{

/// Returns a few lines for people, without a newline at the end. They describe all frames of a
/// renderer.
std::string DescribeDrawing(const RenderTotals& totals);

struct SimulationTotals
{
    std::int64_t firstStep = 0; ///< those before it were there already
    std::int64_t steps = 0;     ///< that were simulated
};

/// A line for people, without a newline at the end.
std::string DescribeSimulation(const SimulationTotals& totals);

} // namespace boxreel
