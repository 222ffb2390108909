// SPDX-License-Identifier: MIT
#pragma once

#include <render/Renderer.h>

#include <cstdint>
#include <string>

/// What --stats prints: how much of a film or a picture was really simulated and drawn.
namespace boxreel
{

/// A few lines for people, without a newline at the end. Of all the frames that a renderer was
/// given.
std::string DescribeDrawing(const RenderTotals& totals);

struct SimulationTotals
{
    std::int64_t firstStep = 0; ///< those before it were there already
    std::int64_t steps = 0;     ///< that were simulated
};

/// A line for people, without a newline at the end.
std::string DescribeSimulation(const SimulationTotals& totals);

} // namespace boxreel
