// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <debugdraw/Result.h>

#include <filesystem>
#include <string>
#include <vector>

/// Runs the programs that draw (tests/benchmark, our renderer's and Cairo's) and shows what a frame
/// takes against how exact its edges are: as a table, as JSON, and as a chart a picture size. The
/// programs are executed, never linked.
namespace boxreel
{

/// A picture to draw, and what ours is held against, in CPU time with one raster thread; 0:
/// nothing.
struct RenderCase
{
    std::string name;
    std::string what;         ///< in a few words
    int count = 0;            ///< of shapes
    int width = 0;            ///< [px]
    int height = 0;           ///< [px]
    double goalFull = 0.0;    ///< a frame in which all shapes have changed [s]
    double goalChanged = 0.0; ///< a frame in which one in twenty has [s]
    double goalNone = 0.0;    ///< a frame in which nothing has [s]
    double goalEmpty = 0.0;   ///< a frame without shapes over clearing and reading
    double goalRms = 0.0;     ///< error at edges, of 255
    friend bool operator==(const RenderCase&, const RenderCase&) = default;
};

/// Of a frame [s]; kNoValue: not measured.
struct RenderTimes
{
    double cpu = kNoValue; ///< of the whole process
    double wall = kNoValue;
    double submit = kNoValue; ///< share of `wall` until the picture is handed over
    double read = kNoValue;   ///< share of `wall` until its pixels are there
};

/// One renderer, with one number of raster threads.
struct RenderFigures
{
    std::string method; ///< name and version
    std::string by;     ///< the library that draws
    bool isOurs = false;
    std::string threads;    ///< "0": the rasteriser has none of its own; "own": as the user has it
    RenderTimes full;       ///< all shapes changed
    RenderTimes together;   ///< one in twenty changed, around one place
    RenderTimes apart;      ///< one in twenty changed, all over the picture
    RenderTimes none;       ///< nothing changed
    RenderTimes empty;      ///< no shapes
    RenderTimes floor;      ///< the library told to clear and to hand over the pixels
    double rms = kNoValue;  ///< error of the pixels at edges, of 255
    double most = kNoValue; ///< of any pixel, of 255
    double edgePixels = 0.0;
    std::string wrong;   ///< the frames that differed from one drawn from scratch; empty: none
    std::string failure; ///< why there are no figures; empty: there are

    /// A frame without shapes over clearing and reading, in CPU time.
    double EmptyRatio() const { return empty.cpu / floor.cpu; }
};

struct RenderResult
{
    RenderCase info;
    std::vector<RenderFigures> methods; ///< ours first
};

/// A goal, and what was reached.
struct RenderGoal
{
    std::string what; ///< "full redraw"
    std::string unit; ///< " ms", or empty
    double goal = 0.0;
    double reached = kNoValue;
    bool IsMet() const { return reached <= goal; }
};

/// The kinds of frames, by the names that programs and files give them.
struct RenderWork
{
    const char* name;
    const char* title; ///< of a column
    RenderTimes RenderFigures::*times;
};
const std::vector<RenderWork>& RenderWorks();

/// The programs found beside this one, ours first, Cairo's if it was built; empty when ours was
/// not.
std::vector<std::filesystem::path> FindRenderPrograms();

/// One line of a program's list.
RenderCase ParseRenderCase(const std::string& line);
Result<std::vector<RenderCase>> ListRenderCases(const std::filesystem::path& program);

/// What `error` or `time` printed, a line of JSON a method. An Error when a line holds no figures,
/// or there is none.
Result<std::vector<RenderFigures>> ParseRenderLines(const std::string& output);

/// Errors once; times `rounds` times in turn, each the median of the rounds. Ours with one raster
/// thread and with as many as the user has.
RenderResult RunRenderCase(const std::vector<std::filesystem::path>& programs,
                           const RenderCase& info, int rounds);

/// Those of the case, for ours with one raster thread; empty when there are none or it did not run.
std::vector<RenderGoal> RenderGoals(const RenderResult& result);

/// A row a method and clock, goals met and missed, and the summary.
std::string RenderTable(const std::vector<RenderResult>& results);
/// A row a case: CPU times with one raster thread, and errors.
std::string RenderSummary(const std::vector<RenderResult>& results);
/// All figures for programs.
std::string RenderJson(const std::vector<RenderResult>& results);
/// What RenderJson wrote. `name` is for the error's sentence.
Result<std::vector<RenderResult>> ParseRenderJson(const std::string& text, const std::string& name);

/// The results of one picture size, CPU time against error. An Error when there is nothing to draw.
Result<LineChart> RenderChart(const std::vector<RenderResult>& results);

} // namespace boxreel
