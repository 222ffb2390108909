// SPDX-License-Identifier: MIT
#include "FilmPlan.h"

namespace boxreel
{
namespace
{

constexpr Duration kDefaultLength{10'000'000'000};
constexpr Duration kLongestWait{600'000'000'000}; // of a film that ends when something holds
constexpr std::int64_t kMostFrames = 10'000'000;  // 46 hours at 60 frames a second

Result<std::int64_t> FrameCount(const RecordOptions& options)
{
    const Duration length = options.until.empty() ? kDefaultLength : kLongestWait;
    const std::int64_t frames = options.frames.value_or(
        FramesIn(options.seconds.value_or(length), options.film.framesPerSecond));
    if (frames > kMostFrames)
    {
        return Error{ErrorKind::Unusable, "The film would have " + std::to_string(frames) +
                                              " frames; make it shorter or lower --fps, " +
                                              std::to_string(kMostFrames) + " is the most."};
    }
    return frames;
}

} // namespace

Result<FilmPlan> PlanFilm(const RecordOptions& options)
{
    const Result<std::int64_t> frameCount = FrameCount(options);
    if (!frameCount)
    {
        return frameCount.GetError();
    }
    FilmPlan plan{.film = options.film,
                  .frameCount = *frameCount,
                  .frames = FrameRange(FrameRun{0, *frameCount - 1, 1})};
    if (options.range)
    {
        plan.frames = options.range->Below(*frameCount);
        if (plan.frames.Count() == 0)
        {
            return Error{ErrorKind::Unusable, "--frame-range " + options.range->Text() +
                                                  ": the film has the frames 0 to " +
                                                  std::to_string(*frameCount - 1) +
                                                  "; give some of these, or a longer film."};
        }
    }
    plan.film.width = options.look.width;
    plan.film.height = options.look.height;
    plan.film.frames = plan.frames;
    plan.groupFrames = PartLength(options.output, plan.film);
    const Result<void> usable = CheckVideoPath(options.output, plan.film);
    return usable ? Result<FilmPlan>(std::move(plan)) : usable.GetError();
}

bool HasPapers(const RecordOptions& options, const FilmPlan& plan)
{
    return plan.groupFrames > 0 && options.output != "-" && plan.frames.IsWhole();
}

} // namespace boxreel
