// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/StageTimes.h>

#include <cstdint>
#include <string>

/// The timing breakdown of --stats: the time per frame of each stage of a film.
namespace boxreel
{

struct ProcessTime
{
    double cpu = 0.0;  ///< of all threads [s]
    double wall = 0.0; ///< since the process was started [s]
};

/// Returns the time of this process since it was started.
ProcessTime ProcessSoFar();

/// CPU time of Mesa's raster threads, as far as they are still there [s], in steps of 1/100 s.
double RasterSeconds();

struct FilmTimes
{
    std::int64_t frames = 0; ///< that were made
    ProcessTime before;      ///< when the first frame was begun
    ProcessTime end;         ///< when the film was closed
    double raster = 0.0;     ///< CPU time of raster threads [s]
};

/// A table for people, without a newline at the end: CPU and wall time of a frame [ms].
std::string DescribeStages(const StageTimes& stages, const FilmTimes& times);

/// One line for programs: {"event":"stages","frames":…,"stages":[{"stage":…,"thread":…,
/// "cpuSeconds":…,"wallSeconds":…},…]}; seconds are those of the whole film.
std::string StageJson(const StageTimes& stages, const FilmTimes& times);

} // namespace boxreel
