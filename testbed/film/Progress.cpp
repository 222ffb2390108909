// SPDX-License-Identifier: MIT
#include "Progress.h"

#include <base/Counting.h>
#include <base/Terminal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace boxreel
{
namespace
{

// Often enough to look alive, seldom enough to cost nothing.
constexpr double kSecondsBetweenBars = 0.1;
constexpr double kSecondsBetweenObjects = 0.5;

// Steps between two frames from which on progress is reported: a second of computing a pyramid.
constexpr std::int64_t kLongWay = 1000;

template <class... Values>
std::string Format(const char* format, Values... values)
{
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

long long Printable(std::int64_t value)
{
    return value;
}

double Share(const RecordingProgress& progress)
{
    return double(progress.framesDone) / double(std::max<std::int64_t>(1, progress.framesTotal));
}

int Percent(const RecordingProgress& progress)
{
    return static_cast<int>(100 * progress.framesDone /
                            std::max<std::int64_t>(1, progress.framesTotal));
}

/// Frames that existed before took none of the time.
std::int64_t MadeNow(const RecordingProgress& progress)
{
    return progress.framesDone - progress.framesKept;
}

double FramesPerSecond(const RecordingProgress& progress, double seconds)
{
    return seconds > 0.0 ? double(MadeNow(progress)) / seconds : 0.0;
}

/// "0:07", "12:34", "1:02:03".
std::string TimeText(double seconds)
{
    const long long whole = std::llround(seconds);
    if (whole >= 3600)
    {
        return Format("%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
    }
    return Format("%lld:%02lld", whole / 60, whole % 60);
}

std::string Remaining(const RecordingProgress& progress, double seconds)
{
    if (MadeNow(progress) == 0)
    {
        return "-:--";
    }
    const double perFrame = seconds / double(MadeNow(progress));
    return TimeText(perFrame * double(progress.framesTotal - progress.framesDone));
}

std::string Counts(const RecordingProgress& progress, double seconds)
{
    return Format("%lld/%lld frames, %.0f fps, %s left", Printable(progress.framesDone),
                  Printable(progress.framesTotal), FramesPerSecond(progress, seconds),
                  Remaining(progress, seconds).c_str());
}

std::string BytesText(std::int64_t bytes)
{
    if (bytes >= 1'000'000)
    {
        return Format("%.1f MB", double(bytes) / 1e6);
    }
    return bytes >= 1000 ? Format("%.0f kB", double(bytes) / 1e3)
                         : Format("%lld bytes", Printable(bytes));
}

/// Returns a JSON string with its quotes. Bytes that are not UTF-8 are replaced.
std::string JsonString(const std::string& text)
{
    using nlohmann::json;
    return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace

std::string ProgressBarText(const RecordingProgress& progress, double seconds, int columns)
{
    const std::string percent = Format("%3d%% ", Percent(progress));
    const std::string counts = Counts(progress, seconds);
    // The last column stays free: a terminal that wraps there would leave the bar behind.
    const int room = columns - 1 - static_cast<int>(percent.size() + counts.size()) - 3;
    if (room < 8)
    {
        return (percent + counts).substr(0, static_cast<std::size_t>(std::max(1, columns - 1)));
    }
    const int length = std::min(room, 40);
    const int filled = static_cast<int>(Share(progress) * length);
    return percent + "[" + std::string(static_cast<std::size_t>(filled), '#') +
           std::string(static_cast<std::size_t>(length - filled), '.') + "] " + counts;
}

std::string ProgressLineText(const RecordingProgress& progress, double seconds)
{
    return Format("%3d%%  ", Percent(progress)) + Counts(progress, seconds);
}

std::string ProgressJsonText(const RecordingProgress& progress, double seconds)
{
    return Format("{\"event\":\"progress\",\"frames\":%lld,\"total\":%lld,\"seconds\":%.3f}",
                  Printable(progress.framesDone), Printable(progress.framesTotal), seconds);
}

std::string ProgressOpenJdText(const RecordingProgress& progress, double seconds)
{
    return Format("openjd_progress: %.1f\nopenjd_status: ", 100.0 * Share(progress)) +
           Counts(progress, seconds);
}

std::string SimulationText(const SimulationProgress& progress)
{
    return Format("simulating up to the next frame, step %lld of %lld", Printable(progress.step),
                  Printable(progress.last));
}

std::string SimulationJsonText(const SimulationProgress& progress)
{
    return Format("{\"event\":\"simulating\",\"step\":%lld,\"last\":%lld}",
                  Printable(progress.step), Printable(progress.last));
}

std::string FailOpenJdText(const std::string& sentence)
{
    std::string line = "openjd_fail: " + sentence;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

std::string ReportText(const FilmReport& report)
{
    std::string text =
        report.file.string() + ": " + Counted(report.frames, "frame") +
        Format(" of %dx%d at %g fps", report.width, report.height, report.framesPerSecond);
    if (report.framesFilmed > report.frames)
    {
        text += Format(" (kept of %lld: a GIF shows at most 50 a second)",
                       Printable(report.framesFilmed));
    }
    if (report.stored && *report.stored != report.frames)
    {
        text += Format(", %lld of them stored", Printable(*report.stored));
    }
    if (report.bytes >= 0)
    {
        text += ", " + BytesText(report.bytes);
    }
    return text + Format(", made in %.1f s", report.seconds);
}

std::string ReportJsonText(const FilmReport& report)
{
    std::string text = "{\"event\":\"done\",\"file\":" + JsonString(report.file.string());
    text += Format(",\"frames\":%lld,\"width\":%d,\"height\":%d,\"fps\":%g",
                   Printable(report.frames), report.width, report.height, report.framesPerSecond);
    if (report.stored)
    {
        text += Format(",\"stored\":%lld", Printable(*report.stored));
    }
    if (report.bytes >= 0)
    {
        text += Format(",\"bytes\":%lld", Printable(report.bytes));
    }
    return text + Format(",\"seconds\":%.3f}", report.seconds);
}

Progress::Progress(ProgressMode mode) : m_mode(mode)
{
    if (mode == ProgressMode::Auto)
    {
        m_mode = IsTerminal(stderr) ? ProgressMode::Bar : ProgressMode::Lines;
    }
}

double Progress::Seconds() const
{
    return std::chrono::duration<double>(Clock::now() - m_start).count();
}

void Progress::Update(const RecordingProgress& progress)
{
    const double now = Seconds();
    const bool isLast = progress.framesDone >= progress.framesTotal;
    const double since = m_lastWritten < 0.0 ? 1e9 : now - m_lastWritten;
    const std::int64_t tenth =
        10 * progress.framesDone / std::max<std::int64_t>(1, progress.framesTotal);
    if (m_mode == ProgressMode::Bar && (isLast || since >= kSecondsBetweenBars))
    {
        ShowBar(ProgressBarText(progress, now, TerminalColumns(stderr)));
        m_lastWritten = now;
    }
    else if (m_mode == ProgressMode::Lines && tenth > m_lastTenth)
    {
        WriteMessage(ProgressLineText(progress, now));
        m_lastTenth = tenth;
    }
    else if (m_mode == ProgressMode::Json && (isLast || since >= kSecondsBetweenObjects))
    {
        WriteMessage(ProgressJsonText(progress, now));
        m_lastWritten = now;
    }
    else if (m_mode == ProgressMode::OpenJD && (isLast || since >= kSecondsBetweenObjects))
    {
        std::printf("%s\n", ProgressOpenJdText(progress, now).c_str());
        std::fflush(stdout);
        m_lastWritten = now;
    }
}

void Progress::ShowBar(const std::string& bar)
{
    const std::string rest(m_shownLength > bar.size() ? m_shownLength - bar.size() : 0, ' ');
    std::fprintf(stderr, "\r%s%s", bar.c_str(), rest.c_str());
    m_shownLength = bar.size();
}

void Progress::Simulate(const SimulationProgress& progress)
{
    const std::int64_t way = progress.last - progress.first;
    const std::int64_t done = progress.step - progress.first;
    if (way < kLongWay || 10 * done / way == 10 * (done - 1) / way)
    {
        return;
    }
    if (m_mode == ProgressMode::Bar)
    {
        const std::size_t room = static_cast<std::size_t>(std::max(1, TerminalColumns(stderr) - 1));
        ShowBar(SimulationText(progress).substr(0, room));
    }
    else if (m_mode == ProgressMode::Lines)
    {
        WriteMessage(SimulationText(progress));
    }
    else if (m_mode == ProgressMode::Json)
    {
        WriteMessage(SimulationJsonText(progress));
    }
    else if (m_mode == ProgressMode::OpenJD)
    {
        (void)WriteOutput("openjd_status: " + SimulationText(progress) + "\n");
    }
}

void Progress::Clear()
{
    if (m_shownLength > 0)
    {
        std::fprintf(stderr, "\r%s\r", std::string(m_shownLength, ' ').c_str());
        m_shownLength = 0;
    }
}

void Progress::Finish(const FilmReport& report)
{
    Clear();
    if (m_mode == ProgressMode::Json)
    {
        WriteMessage(ReportJsonText(report));
    }
    else if (m_mode != ProgressMode::None)
    {
        WriteMessage(ReportText(report));
    }
}

void Progress::Stop(const std::string& sentence)
{
    Clear();
    WriteMessage("boxreel: " + sentence);
    if (m_mode == ProgressMode::OpenJD)
    {
        (void)WriteOutput(FailOpenJdText(sentence) + "\n"); // the agent may have gone
    }
}

} // namespace boxreel
