// SPDX-License-Identifier: MIT
#pragma once

#include <recorder/Recording.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

/// Progress of a film on standard error: a bar for a terminal, lines for a log, JSON objects for a
/// program. Only the progress of Open Job Description goes to standard output.
namespace boxreel
{

enum class ProgressMode
{
    Auto, ///< Bar on a terminal, Lines elsewhere
    Bar,
    Lines,
    Json,
    OpenJD, ///< for Open Job Description's agents, on standard output
    None,
};

/// The result of a recording, for the last line.
struct FilmReport
{
    std::filesystem::path file;
    std::int64_t frames = 0;       ///< in the file
    std::int64_t framesFilmed = 0; ///< more than those when the format cannot show so many a second
    int width = 0;                 ///< [px]
    int height = 0;                ///< [px]
    double framesPerSecond = 60.0;
    double seconds = 0.0;    ///< that making it took
    std::int64_t bytes = -1; ///< of the file; -1: not one file
    std::optional<std::int64_t>
        stored; ///< frames in the file where identical ones may be left out; none: all
};

/// The texts, without line ends. `seconds`: since the first frame was begun.
std::string ProgressBarText(const RecordingProgress& progress, double seconds, int columns);
std::string ProgressLineText(const RecordingProgress& progress, double seconds);
std::string ProgressJsonText(const RecordingProgress& progress, double seconds);
std::string ProgressOpenJdText(const RecordingProgress& progress, double seconds);
/// Progress of the simulation before the first frame can be drawn.
struct SimulationProgress
{
    std::int64_t step = 0; ///< has been simulated
    std::int64_t first = 0;
    std::int64_t last = 0;
};
std::string SimulationText(const SimulationProgress& progress);
std::string SimulationJsonText(const SimulationProgress& progress);
/// Why a command ends without its result; in one line, as agents read it.
std::string FailOpenJdText(const std::string& sentence);
std::string ReportText(const FilmReport& report);
std::string ReportJsonText(const FilmReport& report);

class Progress
{
public:
    explicit Progress(ProgressMode mode);

    /// Writes when there is news: a few times a second, or once every tenth of the film.
    void Update(const RecordingProgress& progress);

    /// Reports each tenth of a long simulation before a frame.
    void Simulate(const SimulationProgress& progress);

    /// Clears what a line feed has not ended yet, so that a message starts in a column of its own.
    void Clear();

    /// The last line.
    void Finish(const FilmReport& report);

    /// The last line of a film that is not finished, in every mode.
    void Stop(const std::string& sentence);

    double Seconds() const; ///< since construction

private:
    void ShowBar(const std::string& bar);

    using Clock = std::chrono::steady_clock;

    ProgressMode m_mode;
    Clock::time_point m_start = Clock::now();
    double m_lastWritten = -1.0;   // seconds since the start
    std::int64_t m_lastTenth = 0;  // of the film, in lines
    std::size_t m_shownLength = 0; // of the bar that stands in the terminal's last line
};

} // namespace boxreel
