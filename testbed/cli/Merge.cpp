// SPDX-License-Identifier: MIT
#include "Merge.h"
#include "Declare.h"
#include "OutputPath.h"

#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>
#include <base/Terminal.h>
#include <base/Words.h>
#include <film/Manifest.h>
#include <film/PageRun.h>
#include <film/StopSignals.h>
#include <recorder/JoinFilms.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// A part and what its manifest says.
struct NamedPart
{
    std::filesystem::path path;
    Manifest manifest;
};

Result<std::vector<NamedPart>> ReadParts(const std::vector<std::filesystem::path>& paths)
{
    std::vector<NamedPart> parts;
    for (const std::filesystem::path& path : paths)
    {
        if (Lower(path.extension().string()) == ".png")
        {
            return Error{ErrorKind::Unusable, path.string(), "is a picture",
                         "leave it where it is: parts of numbered pictures need no joining"};
        }
        std::error_code ignored;
        const std::filesystem::file_status status = std::filesystem::status(path, ignored);
        if (!std::filesystem::exists(status))
        {
            return FileNotFound(path);
        }
        if (!std::filesystem::is_regular_file(status))
        {
            return Error{ErrorKind::Unusable, path.string(), "is not a film",
                         "name parts made with `boxreel record --frame-range`"};
        }
        ASSIGN_OR_RETURN(Manifest manifest,
                         ReadManifest(path, "copy it beside the part, or record that part again"));
        if (manifest.checksum.empty() ||
            ChecksumOfFrames(path, manifest.first, manifest.end) != manifest.checksum)
        {
            return Error{ErrorKind::Unusable, path.string(),
                         "does not match its manifest " + ManifestPath(path).string(),
                         "record that part again"};
        }
        parts.push_back({path, std::move(manifest)});
    }
    std::sort(parts.begin(), parts.end(), [](const NamedPart& a, const NamedPart& b) {
        return a.manifest.first < b.manifest.first;
    });
    return parts;
}

/// Checks that `after` starts where `before` ends.
Result<void> CheckSeam(const NamedPart& before, const NamedPart& after)
{
    const auto refused = [&](const std::string& why) {
        return Error{ErrorKind::Unusable, after.path.string(),
                     "cannot be joined to " + before.path.string() + ": " + why};
    };
    const std::string difference = DifferenceOf(before.manifest, after.manifest);
    if (!difference.empty())
    {
        return refused(difference);
    }
    const std::int64_t end = before.manifest.end;
    const std::int64_t next = after.manifest.first;
    if (next != end)
    {
        return refused(next < end ? "frame " + std::to_string(next) + " is in both"
                                  : "frames " + std::to_string(end) + " to " +
                                        std::to_string(next - 1) + " are missing");
    }
    if (end % before.manifest.groupFrames != 0)
    {
        return refused("they meet at frame " + std::to_string(end) +
                       ", within a group of frames; record parts that begin at multiples of " +
                       std::to_string(before.manifest.groupFrames));
    }
    const auto left = before.manifest.states.find(end);
    const auto right = after.manifest.states.find(end);
    if (left == before.manifest.states.end() || right == after.manifest.states.end() ||
        left->second != right->second)
    {
        return refused("the states of the world differ at frame " + std::to_string(end) +
                       "; record both with the same build of boxreel");
    }
    return {};
}

std::string FramesText(std::int64_t first, std::int64_t last)
{
    return std::to_string(first) + (last > first ? " to " + std::to_string(last) : "");
}

/// Checks that the first and the last part are those of the film.
Result<void> CheckWhole(const std::vector<NamedPart>& parts)
{
    const std::int64_t first = parts.front().manifest.first;
    const std::int64_t end = parts.back().manifest.end;
    const std::int64_t count = parts.back().manifest.frameCount;
    std::string missing = first > 0 ? FramesText(0, first - 1) : "";
    if (end < count)
    {
        missing += (missing.empty() ? "" : " and ") + FramesText(end, count - 1);
    }
    if (missing.empty())
    {
        return {};
    }
    return Error{ErrorKind::Unusable, "frames " + missing,
                 "missing from the parts; the film has " + std::to_string(count) + " frames",
                 "add the parts with these frames, or use --partial"};
}

/// The output must not be one of the parts, because it would replace a file that is still read.
Result<void> CheckOutput(const MergeOptions& options)
{
    for (const std::filesystem::path& part : options.parts)
    {
        std::error_code ignored;
        if (std::filesystem::equivalent(part, options.output, ignored))
        {
            return Error{ErrorKind::Unusable, "-o " + options.output.string(),
                         "is one of the parts", "choose another name"};
        }
    }
    return {};
}

/// Returns the number of stored frames that a film encodes together. A group of a GIF contains more
/// frames than it stores.
int GroupOf(const Manifest& manifest, const std::filesystem::path& film)
{
    const VideoSettings ofOne{.framesPerSecond = manifest.framesPerSecond, .groupFrames = 1};
    const std::int64_t length = PartLength(film, ofOne);
    return static_cast<int>(length > 0 ? manifest.groupFrames / length : manifest.groupFrames);
}

} // namespace

Result<int> Run(const MergeOptions& options)
{
    RETURN_IF_ERROR(CheckOutput(options));
    ASSIGN_OR_RETURN(const std::vector<NamedPart> parts, ReadParts(options.parts));
    std::vector<FilmPart> films;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        if (i > 0)
        {
            RETURN_IF_ERROR(CheckSeam(parts[i - 1], parts[i]));
        }
        const Manifest& manifest = parts[i].manifest;
        films.push_back({parts[i].path, manifest.first, manifest.end - manifest.first});
    }
    RETURN_IF_ERROR(options.partial ? Result<void>() : CheckWhole(parts));
    const Manifest& first = parts.front().manifest;
    VideoSettings settings;
    settings.framesPerSecond = first.framesPerSecond;
    settings.overwrite = options.force;
    settings.plays = first.plays;
    settings.groupFrames = GroupOf(first, options.output);
    const StopSignals stopSignals;
    ASSIGN_OR_RETURN(const JoinedFilm joined, JoinFilms(films, options.output, settings,
                                                        [] { return StopSignals::Caught() != 0; }));
    if (!joined.isWhole)
    {
        WriteMessage("Stopped; nothing of " + options.output.string() + " is left.");
        return StopSignals::kExitCode;
    }
    const std::int64_t frames = parts.back().manifest.end - first.first;
    std::string text = options.output.string() + ": " + Counted(frames, "frame") + " of " +
                       Counted(films.size(), "part");
    if (joined.stored && *joined.stored != frames)
    {
        text += ", " + std::to_string(*joined.stored) + " of the frames stored";
    }
    WriteMessage(text);
    return 0;
}

Command& Declare(Command& program, MergeOptions& merge)
{
    Command& command =
        AddCommand(program, "merge", "Join parts of a film without encoding them again");
    AddPaths(command, "PARTS", merge.parts,
             "Join these films of --frame-range, in any order, each with its .json")
        .Completes({Completion::Kind::Files, FilmExtensions()});
    AddPath(command, "-o,--output", "FILE", merge.output,
            "Write the film here, with the extension of the parts", FilmExtensions());
    AddForce(command, merge.force);
    AddFlag(command, "--partial", merge.partial, "Accept missing frames at the start or end");
    command.notes = {
        {"The parts must come from the same command and be unmodified. Together they must cover\n"
         "the film without gaps. Where two parts meet, the world must have the same state. If a\n"
         "signal stops it, it leaves no file and exits with code 75."}};
    command.examples = {"boxreel record pyramid -o a.mkv --frames 400 --frame-range 0-199",
                        "boxreel record pyramid -o b.mkv --frames 400 --frame-range 200-399",
                        "boxreel merge a.mkv b.mkv -o pyramid.mkv"};
    return command;
}

Result<void> Check(MergeOptions& options)
{
    if (options.parts.empty())
    {
        return Missing("merge", "PARTS", "boxreel merge a.mkv b.mkv -o film.mkv");
    }
    if (options.output.empty())
    {
        return Missing("merge", "-o FILE", "boxreel merge a.mkv b.mkv -o film.mkv");
    }
    if (options.output == "-")
    {
        return Error{ErrorKind::Unusable, "-o -", "merge writes to a file only",
                     "name a file, such as -o film.mkv"};
    }
    const bool isPage = IsPage(options.output);
    if (isPage || Lower(options.output.extension().string()) == ".png")
    {
        return Error{ErrorKind::Unusable, "-o " + options.output.string(),
                     std::string("films cannot be joined to ") + (isPage ? "a page" : "pictures"),
                     "name a film with the extension of the parts, such as -o film.mp4"};
    }
    RETURN_IF_ERROR(CheckFilmName(options.output));
    return CheckVideoPath(options.output, {});
}

} // namespace boxreel
