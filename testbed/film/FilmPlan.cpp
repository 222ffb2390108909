// SPDX-License-Identifier: MIT
#include "FilmPlan.h"
#include "FilmPapers.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

namespace boxreel
{
namespace
{

constexpr Duration kDefaultLength{10'000'000'000};
constexpr Duration kLongestWait{600'000'000'000}; // of a film that ends when something holds
constexpr std::int64_t kMostFrames = 10'000'000;  // 46 hours at 60 frames a second

Result<std::int64_t> FrameCount(const RecordOptions& options)
{
    const Duration length = options.length.until.empty() ? kDefaultLength : kLongestWait;
    const std::int64_t frames = options.length.frames.value_or(
        FramesIn(options.length.seconds.value_or(length), options.film.framesPerSecond));
    if (frames > kMostFrames)
    {
        return Error{ErrorKind::Unusable, "The film would have " + std::to_string(frames) +
                                              " frames; make it shorter or lower --fps, " +
                                              std::to_string(kMostFrames) + " is the most."};
    }
    return frames;
}

std::string FramesOf(const FilmPapers& papers)
{
    return "it has the frames " + std::to_string(papers.first) + " to " +
           std::to_string(papers.end - 1);
}

/// What tells the film of these papers from the one that is asked for, as a clause; nothing where
/// it is the same, or another length of it.
std::string DifferenceFromAsked(const FilmPapers& there, const RecordOptions& options,
                                const FilmPlan& plan)
{
    FilmPapers asked;
    asked.version = BOXREEL_VERSION;
    asked.command = CommandOfFilm(options.arguments);
    return there.first != plan.frames.First() ? FramesOf(there) : DifferenceOf(there, asked);
}

/// Why the papers of `film` may not be replaced, with the remedy; empty: they may.
std::string WhyPapersStay(const std::filesystem::path& film, const RecordOptions& options,
                          const FilmPlan& plan)
{
    const std::string writer = WriterOfPapers(film);
    const std::string remedy = "; delete it, choose another name, or begin anew with --force.";
    if (writer.empty())
    {
        return "what is known of the film goes there, and this file is something else; move it, "
               "choose another name, or allow overwriting (--force).";
    }
    if (writer != BOXREEL_VERSION)
    {
        return "version " + writer + " of this program left it there, and this is version " +
               BOXREEL_VERSION + remedy;
    }
    const Result<FilmPapers> papers = ReadPapers(film, "");
    if (!papers)
    {
        return "another build of this program left it there, and this one cannot read it" + remedy;
    }
    const std::string difference = DifferenceFromAsked(*papers, options, plan);
    return difference.empty() ? "" : "it is left of another film (" + difference + ")" + remedy;
}

} // namespace

Result<FilmPlan> PlanFilm(const RecordOptions& options)
{
    ASSIGN_OR_RETURN(const std::int64_t frameCount, FrameCount(options));
    FilmPlan plan{.film = options.film,
                  .frameCount = frameCount,
                  .frames = FrameRange(FrameRun{0, frameCount - 1, 1})};
    if (options.length.range)
    {
        plan.frames = options.length.range->Below(frameCount);
        if (plan.frames.Count() == 0)
        {
            return Error{ErrorKind::Unusable, "--frame-range " + options.length.range->Text() +
                                                  ": the film has the frames 0 to " +
                                                  std::to_string(frameCount - 1) +
                                                  "; give some of these, or a longer film."};
        }
    }
    plan.film.width = options.look.width;
    plan.film.height = options.look.height;
    plan.film.frames = plan.frames;
    plan.groupFrames = PartLength(options.output, plan.film);
    return plan;
}

Result<bool> IsPartDone(const RecordOptions& options, const FilmPlan& plan)
{
    std::error_code ignored;
    if (!HasPapers(options, plan) || !std::filesystem::is_regular_file(options.output, ignored))
    {
        return false;
    }
    const std::string remedy = "make that part anew with --force, or choose another place";
    ASSIGN_OR_RETURN(const FilmPapers there, ReadPapers(options.output, remedy));
    std::string difference = DifferenceFromAsked(there, options, plan);
    if (difference.empty() && there.end != plan.frames.Last() + 1)
    {
        difference = FramesOf(there);
    }
    if (difference.empty() && ChecksumOfFilm(options.output) != there.checksum)
    {
        difference = "it is cut off or was altered";
    }
    if (!difference.empty())
    {
        return Error{ErrorKind::Unusable, options.output.string() +
                                              " is there, but is not what is asked for (" +
                                              difference + "); " + remedy + "."};
    }
    return true;
}

Result<void> CheckPapersPaths(const RecordOptions& options, const FilmPlan& plan)
{
    if (!HasPapers(options, plan) || options.film.overwrite)
    {
        return {};
    }
    std::vector<std::filesystem::path> films{PartPath(options.output)};
    if (options.length.range)
    {
        films.push_back(options.output); // a whole film has none
    }
    for (const std::filesystem::path& film : films)
    {
        std::error_code ignored;
        const std::filesystem::path papers = PapersPath(film);
        const bool isThere =
            std::filesystem::exists(std::filesystem::symlink_status(papers, ignored));
        const std::string why = isThere ? WhyPapersStay(film, options, plan) : "";
        if (!why.empty())
        {
            return Error{ErrorKind::Unusable, papers.string() + " is in the way: " + why};
        }
    }
    return {};
}

bool HasPapers(const RecordOptions& options, const FilmPlan& plan)
{
    return plan.groupFrames > 0 && options.output != "-" && plan.frames.IsWhole();
}

} // namespace boxreel
