// SPDX-License-Identifier: MIT
#pragma once

#include "Progress.h"

#include <options/Values.h>
#include <recorder/VideoWriter.h>
#include <render/Backend.h>
#include <session/Condition.h>
#include <session/SceneSession.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// The options of a recording, as plain data.
namespace boxreel
{

/// The frames of a film.
struct FilmLength
{
    std::optional<Duration> seconds;    ///< length of the film
    std::optional<std::int64_t> frames; ///< number of frames; neither: 10 s
    std::optional<Duration> from;       ///< simulated time before the first frame
    std::vector<Condition> until;       ///< the film ends when one becomes true; at most 10 min
    std::optional<FrameRange> range;    ///< only these frames are made
};

/// The relation of simulated time to film time.
struct FilmPace
{
    Rational speed{1, 1};     ///< simulated seconds per second of film
    bool interpolate = false; ///< show poses between steps
};

/// A picture of one frame beside the film.
struct ThumbnailOptions
{
    std::filesystem::path file; ///< empty: none
    std::optional<Duration> at; ///< time in the film; none: its middle
};

/// Saved states of the simulation, so a part need not simulate the steps before it.
struct SnapshotOptions
{
    std::filesystem::path folder;      ///< empty: none
    std::optional<std::int64_t> every; ///< [steps]; none: as IsSnapshotDue says
};

/// The messages of a recording to the terminal.
struct FilmMessages
{
    bool stats = false; ///< rendering statistics and a timing breakdown when done
    ProgressMode progress = ProgressMode::Auto;
};

struct RecordOptions
{
    std::string scene; ///< a name or a file
    std::filesystem::path output;
    SceneLook look;
    VideoSettings film;        ///< without its size, which is the look's
    bool constantRate = false; ///< --constant-rate and --variable-rate set the film's timing
    bool variableRate = false;
    FilmLength length;
    FilmPace pace;
    ThumbnailOptions thumbnail;
    SnapshotOptions snapshots;
    FilmMessages messages;
    bool skipDone = false; ///< a part that is complete is not made again
    Backend backend = Backend::Auto;
    std::vector<std::string> arguments; ///< of the command line, for the manifest
};

} // namespace boxreel
