// SPDX-License-Identifier: MIT
#include "FilmPlan.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>

namespace boxreel
{
namespace
{

constexpr Duration kDefaultLength{10'000'000'000};
constexpr Duration kLongestWait{600'000'000'000}; // of a film that ends when something holds
constexpr std::int64_t kMaxFrames = 10'000'000;   // 46 hours at 60 frames a second

Result<std::int64_t> FrameCount(const RecordOptions& options)
{
    const Duration length = options.length.until.empty() ? kDefaultLength : kLongestWait;
    const std::int64_t frames = options.length.frames.value_or(
        FramesIn(options.length.seconds.value_or(length), options.film.framesPerSecond));
    if (frames > kMaxFrames)
    {
        return Error{ErrorKind::Unusable, "film",
                     "would have " + std::to_string(frames) + " frames; the limit is " +
                         std::to_string(kMaxFrames),
                     "make it shorter or lower --fps"};
    }
    return frames;
}

std::string FramesOf(const Manifest& manifest)
{
    return "it has the frames " + std::to_string(manifest.first) + " to " +
           std::to_string(manifest.end - 1);
}

bool IsThere(const std::filesystem::path& path)
{
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

/// Why the manifest of `film` may not be replaced; an empty problem: it may.
Error WhyManifestStays(const std::filesystem::path& film, const RecordOptions& options,
                       const FilmPlan& plan)
{
    const auto because = [&film](const std::string& problem, const std::string& remedy) {
        return Error{ErrorKind::Unusable, ManifestPath(film).string(), problem, remedy};
    };
    const std::string remedy = "delete it, choose another name, or start again with --force";
    const std::string writer = WriterOfManifest(film);
    if (writer.empty())
    {
        return because("is not a manifest of boxreel",
                       "move it, choose another name, or overwrite it with --force");
    }
    if (writer != BOXREEL_VERSION)
    {
        return because("was written by version " + writer + "; this is " + BOXREEL_VERSION, remedy);
    }
    const Result<Manifest> manifest = ReadManifest(film, "");
    if (!manifest)
    {
        return because("was written by another build and cannot be read", remedy);
    }
    const std::string difference = DifferenceFromAsked(*manifest, options, plan);
    if (difference.empty())
    {
        return because("", "");
    }
    const bool isStopped = film == PartPath(FileOfFrame(options.output, plan.frames.First()));
    return because("belongs to another film (" + difference + ")",
                   isStopped ? "continue that film with its own command and --resume, choose "
                               "another name, or start again with --force"
                             : remedy);
}

/// Says why `film`, which has no manifest of its own, cannot be skipped. False: its part was
/// stopped and is to be continued.
Result<bool> WithoutManifest(const std::filesystem::path& film, const RecordOptions& options,
                             const FilmPlan& plan)
{
    if (!IsThere(ManifestPath(PartPath(film))))
    {
        return Error{ErrorKind::Unusable, film.string(),
                     "already exists, but is not the beginning of a part: it has no manifest " +
                         ManifestPath(film).filename().string(),
                     "choose another name, or overwrite it with --force"};
    }
    RETURN_IF_ERROR(CheckManifestPaths(options, plan));
    if (!options.film.resume)
    {
        return Error{ErrorKind::Unusable, film.string(), "belongs to a part that was stopped",
                     "continue it with --resume, or start again with --force"};
    }
    return false;
}

} // namespace

std::string DifferenceFromAsked(const Manifest& there, const RecordOptions& options,
                                const FilmPlan& plan)
{
    Manifest asked;
    asked.version = BOXREEL_VERSION;
    asked.command = CommandOfFilm(options.arguments);
    const std::string difference = DifferenceOf(there, asked);
    const FrameRange& frames = plan.frames;
    const bool areSame =
        frames.IsWhole() && there.first == frames.First() && there.end == frames.Last() + 1;
    return difference.empty() && !areSame ? FramesOf(there) : difference;
}

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
            return Error{ErrorKind::Unusable, "--frame-range " + options.length.range->Text(),
                         "must be within the film's frames 0 to " + std::to_string(frameCount - 1)};
        }
    }
    plan.film.width = options.look.width;
    plan.film.height = options.look.height;
    plan.film.frames = plan.frames;
    const bool hasParts = options.length.range || options.film.resume;
    if (hasParts && plan.film.groupFrames == 0)
    {
        plan.film.groupFrames = kPartFrames;
    }
    plan.groupFrames = PartLength(options.output, plan.film);
    return plan;
}

Result<bool> IsPartDone(const RecordOptions& options, const FilmPlan& plan)
{
    std::error_code ignored;
    const std::filesystem::path first = FileOfFrame(options.output, plan.frames.First());
    if (!HasManifest(options, plan) || !std::filesystem::is_regular_file(first, ignored))
    {
        return false;
    }
    if (!IsThere(ManifestPath(first)))
    {
        return WithoutManifest(first, options, plan);
    }
    const std::string remedy = "record that part again with --force, or choose another name";
    ASSIGN_OR_RETURN(const Manifest there, ReadManifest(first, remedy));
    std::string difference = DifferenceFromAsked(there, options, plan);
    if (difference.empty() &&
        ChecksumOfFrames(options.output, there.first, there.end) != there.checksum)
    {
        difference = "it is truncated or modified";
    }
    if (!difference.empty())
    {
        return Error{ErrorKind::Unusable, options.output.string(),
                     "exists but does not match the command (" + difference + ")", remedy};
    }
    return true;
}

Result<void> CheckManifestPaths(const RecordOptions& options, const FilmPlan& plan)
{
    if (!HasManifest(options, plan) || options.film.overwrite)
    {
        return {};
    }
    const std::filesystem::path first = FileOfFrame(options.output, plan.frames.First());
    std::vector<std::filesystem::path> films{PartPath(first)};
    if (options.length.range)
    {
        films.push_back(first); // a whole film has none
    }
    for (const std::filesystem::path& film : films)
    {
        Error why = IsThere(ManifestPath(film)) ? WhyManifestStays(film, options, plan) : Error{};
        if (!why.problem.empty())
        {
            return why;
        }
    }
    return {};
}

bool HasManifest(const RecordOptions& options, const FilmPlan& plan)
{
    return plan.groupFrames > 0 && options.output != "-" && plan.frames.IsWhole();
}

} // namespace boxreel
