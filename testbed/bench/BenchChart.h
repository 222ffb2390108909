// SPDX-License-Identifier: MIT
#pragma once

#include "Benchmark.h"
#include "Chart.h"

/// What the benchmarks measured, as charts.
namespace boxreel
{

/// How many times faster our engine is than each peer, scene by scene, in CPU time, with the goals.
/// An Error when no peer was run.
Result<BarChart> RatioChart(const std::vector<BenchResult>& results);

/// The CPU time of a step against the number of bodies that do nothing, a line an engine and kind.
/// An Error when no scene is part of a curve.
Result<LineChart> CurveChart(const std::vector<BenchResult>& results);

} // namespace boxreel
