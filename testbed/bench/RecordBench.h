// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <debugdraw/Result.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Makes films in several ways, each in processes of their own from a cold start to a closed file,
/// and shows what they cost: `boxreel record`; ffmpeg encoding the same frames from a file of bare
/// pixels; and drawing the classic way with the pixels piped to ffmpeg (tests/benchmark). The
/// programs are executed, never linked.
namespace boxreel
{

/// What is filmed, and what ours is held against; goals of 0 are none.
struct RecordCase
{
    std::string name;
    std::string what;  ///< in a few words
    std::string scene; ///< as `boxreel record` knows it
    std::int64_t frames = 600;
    int width = 1280;               ///< [px]
    int height = 720;               ///< [px]
    double from = 0.0;              ///< simulated before the first frame [s]
    bool isPictures = false;        ///< PNG files instead of an MP4
    bool isOptional = false;        ///< made only when it is named
    std::int64_t movingFrames = 0;  ///< of a film of the same scene from its start; 0: not made
    std::int64_t longFrames = 0;    ///< of a longer film of the same; 0: not made
    double goalOverEncoding = 0.0;  ///< wall time, over that of encoding raw frames
    double goalOverImmediate = 0.0; ///< wall time, over that of immediate mode; less than
    double goalRate = 0.0;          ///< at least [frames/s]
    double goalTimesFaster = 0.0;   ///< at least, a frame of ours than a moving one
    double goalMemory = 0.0;        ///< over that of the encoder's own process [bytes]
    double goalGrowth = 0.0;        ///< memory of the long film over that of the short [bytes]
    friend bool operator==(const RecordCase&, const RecordCase&) = default;
};

/// The films of a case. Those with one frame tell what starting and closing costs.
enum class RecordRole
{
    Ours,
    Start, ///< one frame of ours
    Moving,
    MovingStart, ///< one frame of Moving
    Long,
    Encoding,  ///< ffmpeg, from a file of raw frames
    Immediate, ///< drawn by immediate mode, read, piped to ffmpeg
};

/// One way of making the film; kNoValue: not measured.
struct RecordFigures
{
    RecordRole role = RecordRole::Ours;
    std::string method;
    std::int64_t frames = 0;
    double wall = kNoValue;   ///< from the start of the process to its end [s]
    double cpu = kNoValue;    ///< of all its threads and of the processes it started [s]
    double memory = kNoValue; ///< most that was resident, of all processes [bytes]
    double bytes = kNoValue;  ///< of the film
    std::string verdict;      ///< "sound", or what is wrong with the film
    std::string failure;      ///< why there are no figures; empty: there are
};

/// What `boxreel record --stats` says of ours, for a frame.
struct RecordStage
{
    std::string stage;
    std::string thread;
    double cpu = 0.0;       ///< [s]
    double wall = kNoValue; ///< [s]
};

struct RecordResult
{
    RecordCase info;
    double cached = kNoValue; ///< share of the raw frames in the page cache; none: no peer
    std::vector<RecordFigures> methods; ///< ours first
    std::vector<RecordStage> stages;
};

/// A goal, and what was reached.
struct RecordGoal
{
    RecordRole role;  ///< whose figure it is
    std::string what; ///< "wall time over encoding alone"
    std::string unit; ///< " MB", or empty
    double goal = 0.0;
    double reached = kNoValue; ///< kNoValue where a film is broken: it cannot win
    bool isAtLeast = false;    ///< else at most
    bool IsMet() const { return isAtLeast ? reached >= goal : reached <= goal; }
};

/// What a film shows, as `check` of the helper prints it.
struct FilmCheck
{
    std::int64_t frames = 0;
    int width = 0;  ///< [px]
    int height = 0; ///< [px]
    /// Mean difference from the raw frames, of squares of pixels where something is drawn …
    double drawnError = 0.0;
    double groundError = 0.0; ///< … and where nothing is, of 255
};

struct RecordPrograms
{
    std::filesystem::path boxreel; ///< this program
    std::filesystem::path helper;  ///< draws raw frames and in immediate mode, checks films
    std::string encoder;           ///< "ffmpeg 5.1.9"; empty: not installed
};

/// Of other films than the cases have: goals are for theirs, so there are none then.
struct RecordSize
{
    std::int64_t frames = 0; ///< 0: as the case has it
    int width = 0;           ///< likewise [px]
    int height = 0;          ///< [px]
};

/// All that there are, in the order of the list.
std::vector<RecordCase> AllRecordCases();
RecordCase Resized(RecordCase info, const RecordSize& size);

/// Absent when the helper was not built; the encoder may be missing.
Result<RecordPrograms> FindRecordPrograms();

/// Each film `rounds` times in turn; figures are medians. Films and raw frames lie in `folder`
/// meanwhile. `isStopped` is asked between films. An Error when there is no room for them, when
/// ours cannot be made, or when it is stopped.
Result<RecordResult> RunRecordCase(const RecordPrograms& programs, const RecordCase& info,
                                   int rounds, const std::filesystem::path& folder,
                                   const std::function<bool()>& isStopped);

/// "boxreel", "start", …: as files name them.
const char* RoleName(RecordRole role);

/// The words after `boxreel` and after `ffmpeg`: the same encoder with the same settings.
std::vector<std::string> OursWords(const RecordCase& info, std::int64_t frames, double from,
                                   const std::filesystem::path& film);
std::vector<std::string> EncoderWords(const RecordCase& info, const std::string& input,
                                      bool isUpsideDown, const std::filesystem::path& film);

/// "sound", or what is wrong with the film that was to have so many frames.
std::string JudgeFilm(const RecordCase& info, const RecordFigures& figures, const FilmCheck& check);

/// The film's figures; null when it was not made, or its making failed.
const RecordFigures* FindRole(const RecordResult& result, RecordRole role);

/// Those of the case that could be measured.
std::vector<RecordGoal> RecordGoals(const RecordResult& result);

Result<FilmCheck> ParseFilmCheck(const std::string& output);
/// The stages among the lines that `boxreel record --progress json --stats` printed.
Result<std::vector<RecordStage>> ParseStages(const std::string& output);

/// A row a film, goals met and missed, where the time of a frame goes, and a summary.
std::string RecordTable(const std::vector<RecordResult>& results);
/// All figures for programs.
std::string RecordJson(const std::vector<RecordResult>& results);
/// What RecordJson wrote. `name` is for the error's sentence.
Result<std::vector<RecordResult>> ParseRecordJson(const std::string& text, const std::string& name);

/// How many times faster ours is. An Error when there is nothing to compare with.
Result<BarChart> RecordSpeedChart(const std::vector<RecordResult>& results);
/// CPU time of the stages of a frame. An Error when there are no stages.
Result<BarChart> RecordStageChart(const std::vector<RecordResult>& results);

} // namespace boxreel
