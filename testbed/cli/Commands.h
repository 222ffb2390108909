// SPDX-License-Identifier: MIT
#pragma once

#include "CompareChoice.h"

#include <film/RecordOptions.h>
#include <options/MotionChoice.h>
#include <options/Values.h>
#include <render/Backend.h>
#include <session/GoldenScenes.h>
#include <session/SceneSession.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The commands of the program, one file each: what they take, and what they do. They write to the
/// terminal and to the files they are given, and return the exit code or what went wrong.
namespace boxreel
{

struct ListOptions
{
    bool namesOnly = false;
};

/// Parts of a film become the whole.
struct MergeOptions
{
    std::vector<std::filesystem::path> parts;
    std::filesystem::path output;
    bool force = false;
    bool partial = false; ///< a piece of the film will do
};

struct ShotOptions
{
    std::string scene; ///< a name or a file
    std::filesystem::path output;
    SceneLook look;
    std::vector<Duration> at;        ///< simulated times …
    std::vector<std::int64_t> steps; ///< … or numbers of steps; several make a grid of pictures
    MotionLook motion;
    Backend backend = Backend::Auto;
    bool bothThemes = false; ///< a light and a dark picture instead of the look's theme
    bool force = false;
    bool stats = false; ///< say what was drawn; of pixels only
};

struct DiffOptions
{
    std::filesystem::path expected;
    std::filesystem::path actual;
    std::filesystem::path output; ///< of the difference image; empty: none
    CompareChoice compare;
    bool force = false;
};

struct GoldenOptions
{
    bool accept = false; ///< else verify
    GoldenAcceptance acceptance;
    std::filesystem::path against;  ///< verify with the states of this program; empty: references
    std::vector<std::string> names; ///< "pyramid" or "pyramid/2s"; empty: all; a film's name
    std::filesystem::path film;     ///< instead of scenes
    ContactSheetSettings sheet;     ///< of the film
    std::filesystem::path
        references; ///< empty: golden/references of the checkout around the current folder
    std::filesystem::path output; ///< of what failed; empty: beside the references' checkout
    std::filesystem::path report; ///< a page of what was verified; empty: none
    CompareChoice compare;        ///< of the pixels
    Backend backend = Backend::Auto;
};

/// A page of what golden tests found.
struct GoldenReportOptions
{
    std::vector<std::filesystem::path> folders; ///< that they wrote to; empty: as of verify
    std::filesystem::path output;               ///< empty: report.html in the first of them
    std::filesystem::path against; ///< a program whose steps are shown beside ours; empty: none
    Backend backend = Backend::Auto;
    bool force = false; ///< replace what is no report
};

/// A scene's state at a step as text, or each step's hashes up to it.
struct GoldenStateOptions
{
    std::string scene;
    std::int64_t step = 300;
    bool trace = false;
};

/// A script's expectations are checked, and what it makes is made.
struct PlayOptions
{
    std::filesystem::path script;
    std::filesystem::path into; ///< a folder for what is made; empty: the current one
    bool check = false;         ///< only whether it can be played
    bool test = false;          ///< only what it expects and what was approved
    bool accept = false;        ///< pictures become the references that they would be compared with
    bool forThisRenderer = false; ///< and the pictures for the renderer that draws them alone
    bool force = false;
    bool resume = false; ///< films that were stopped are gone on with
    Backend backend = Backend::Auto;
};

/// A scene in a window.
struct UiOptions
{
    std::string scene;             ///< a name or a file; empty: the last one
    std::optional<PixelSize> size; ///< of the window; none: as it was
    std::string theme;             ///< its name; empty: as it was
    std::uint32_t seed = 1;
    std::optional<Rational> stepsPerSecond;
    std::filesystem::path into;      ///< a folder for what buttons write; empty: the current one
    bool isPaused = false;           ///< to begin with
    bool fresh = false;              ///< as if it were the first time; nothing is kept
    Backend backend = Backend::Auto; ///< of films and figures
};

/// What works on this machine.
struct DoctorOptions
{};

/// What a scene file would be as a scene.
struct CheckOptions
{
    std::filesystem::path file;
};

/// A scene becomes a scene file.
struct ExportOptions
{
    std::string scene; ///< a name or a file
    std::filesystem::path output;
    SceneLook look;             ///< seed and rate
    std::optional<Duration> at; ///< simulated time …
    std::int64_t step = 0;      ///< … or number of steps
    bool force = false;
};

/// What would refuse it, asked before anything is simulated; makes nothing.
Result<void> Prepare(const RecordOptions& options);
Result<void> Prepare(const ShotOptions& options);

/// The files that it makes; of a numbered film its pattern.
std::vector<std::filesystem::path> FilesOf(const RecordOptions& options);
std::vector<std::filesystem::path> FilesOf(const ShotOptions& options);

Result<int> RunList(const ListOptions& options);
Result<int> RunRecord(const RecordOptions& options);
Result<int> RunMerge(const MergeOptions& options);
Result<int> RunShot(const ShotOptions& options);
Result<int> RunDiff(const DiffOptions& options);
Result<int> RunGolden(const GoldenOptions& options);
Result<int> RunGoldenReport(const GoldenReportOptions& options);
Result<int> RunGoldenState(const GoldenStateOptions& options);
Result<int> RunUi(const UiOptions& options);
Result<int> RunDoctor(const DoctorOptions& options);
Result<int> RunCheck(const CheckOptions& options);
Result<int> RunExport(const ExportOptions& options);
Result<int> RunPlay(const PlayOptions& options);

} // namespace boxreel
