// SPDX-License-Identifier: MIT
#include "Record.h"
#include "Declare.h"
#include "OutputPath.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <film/FilmRun.h>
#include <film/PageRun.h>
#include <film/StopSignals.h>

#include <malloc.h>

namespace boxreel
{
namespace
{

/// Pictures and the planes of encoders get pages of their own, which go back when they are freed.
/// glibc would soon keep such blocks in its heaps, where one encoder after the other leaves holes
/// behind, and a film's memory would grow with its length.
void GiveLargeBlocksBack()
{
#ifdef M_MMAP_THRESHOLD
    mallopt(M_MMAP_THRESHOLD, 1 << 20); // said once, it no longer adapts itself
#endif
}

/// Checks that the thumbnail can be written, is within the film, and is not one of its frames.
Result<void> CheckThumbnail(const RecordOptions& options, const FilmPlan& plan)
{
    if (IsFrameOf(options.thumbnail.file, options.output))
    {
        return Error{ErrorKind::Unusable, "--thumbnail " + options.thumbnail.file.string(),
                     "is also the name of a frame of the film", "choose another name"};
    }
    const std::int64_t count = plan.frames.Count();
    if (options.thumbnail.at && options.length.until.empty() &&
        StepAt(*options.thumbnail.at, plan.film.framesPerSecond) > count)
    {
        return Error{ErrorKind::Unusable, "--thumbnail-at",
                     "is after the end of the recording, " + std::to_string(count) + " frames",
                     "give an earlier time"};
    }
    return CheckPicturePath(options.thumbnail.file, options.film.overwrite);
}

/// Asked before anything is simulated.
Result<void> CheckFilm(const RecordOptions& options, const FilmPlan& plan)
{
    if (IsPage(options.output))
    {
        return CheckPage(options);
    }
    RETURN_IF_ERROR(CheckRecordExtension(options.output));
    RETURN_IF_ERROR(CheckVideoPath(options.output, plan.film));
    RETURN_IF_ERROR(CheckManifestPaths(options, plan));
    return options.thumbnail.file.empty() ? Result<void>() : CheckThumbnail(options, plan);
}

/// Said before the work of a part that nothing can be joined to; pictures need no joining.
void TellLooseParts(const RecordOptions& options, const FilmPlan& plan)
{
    const std::int64_t first = plan.frames.First();
    const bool arePictures = options.output.extension() == ".png";
    if (options.length.range && !arePictures && HasManifest(options, plan) &&
        first % plan.groupFrames != 0)
    {
        WriteMessage("boxreel: --frame-range " + options.length.range->Text() +
                     ": begins inside a group of " + std::to_string(plan.groupFrames) +
                     " frames, so no part can be joined before it; begin at a multiple of that or "
                     "change --group");
    }
}

} // namespace

std::vector<std::filesystem::path> FilesOf(const RecordOptions& options)
{
    std::vector<std::filesystem::path> files{options.output};
    if (!options.thumbnail.file.empty())
    {
        files.push_back(options.thumbnail.file);
    }
    return files;
}

Result<void> Prepare(const RecordOptions& options)
{
    ASSIGN_OR_RETURN(const FilmPlan plan, PlanFilm(options));
    const Result<void> usable = CheckFilm(options, plan);
    return usable ? CheckFolderOf(options.output) : usable;
}

Result<int> Run(const RecordOptions& options)
{
    GiveLargeBlocksBack();
    ASSIGN_OR_RETURN(FilmPlan plan, PlanFilm(options));
    if (options.skipDone)
    {
        ASSIGN_OR_RETURN(const bool isDone, IsPartDone(options, plan));
        if (isDone)
        {
            WriteMessage(options.output.string() + ": already complete");
            return 0;
        }
    }
    RETURN_IF_ERROR(CheckFilm(options, plan));
    TellLooseParts(options, plan);
    std::optional<SnapshotFolder> snapshots;
    if (!options.snapshots.folder.empty())
    {
        ASSIGN_OR_RETURN(SnapshotFolder folder,
                         SnapshotFolder::Open(options.snapshots.folder, options.snapshots.every));
        snapshots = std::move(folder);
    }
    ASSIGN_OR_RETURN(SceneSource source, OpenScene(options.scene));
    for (const RubeNote& part : source.leftOut)
    {
        WriteMessage("left out: " + part.Text());
    }
    const StopSignals stopSignals;
    if (IsPage(options.output))
    {
        return MakePage(options, plan, snapshots ? &*snapshots : nullptr, std::move(source));
    }
    return FilmRun(options, std::move(plan), snapshots ? &*snapshots : nullptr)
        .Make(std::move(source));
}

namespace
{

constexpr std::int64_t kMaxFrames = 10'000'000; // 46 hours at 60 frames a second

using NameAndValue = std::pair<std::string, std::string>;

/// "crf=20": libav's name and value.
Result<NameAndValue> ParseCodecOption(const std::string& option, const std::string& text)
{
    const std::size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos || sign + 1 == text.size())
    {
        return BadValue(option, text, "must be a name and a value, such as crf=20");
    }
    return NameAndValue{text.substr(0, sign), text.substr(sign + 1)};
}

void AddCodec(Command& command, std::string& codec)
{
    std::vector<std::string> names;
    std::vector<std::string> words;
    for (const CodecChoice& choice : CodecChoices())
    {
        names.push_back(choice.name);
        words.push_back(choice.name + " (" + JoinedBy(", ", choice.ends) + ")");
    }
    AddValue(command, "--codec", "NAME", codec, OneWordOf(names),
             Filled("Choose ", words, ", ") +
                 "\n(h264; .webm: vp9; .mkv with --quality lossless: ffv1)")
        .Group("Format");
}

/// How it is encoded.
void AddFormat(Command& command, RecordOptions& record)
{
    VideoSettings& film = record.film;
    AddValue(command, "--quality", "LEVEL", film.quality,
             OneOf<Quality>({{"draft", Quality::Draft},
                             {"standard", Quality::Standard},
                             {"high", Quality::High},
                             {"lossless", Quality::Lossless}}),
             "Choose draft, standard, high, lossless (standard)")
        .Group("Format");
    AddCodec(command, film.codec);
    AddValue(command, "--chroma", "KIND", film.chroma,
             OneOf<Chroma>({{"420", Chroma::Half}, {"444", Chroma::Full}}),
             "Set the chroma format: 420 plays everywhere, 444 keeps coloured\n"
             "lines sharp (420)")
        .Group("Format");
    AddValues(command, "--codec-option", "NAME=VALUE", film.codecOptions, ParseCodecOption,
              "Set an option of the encoder, such as crf=20; repeatable")
        .Group("Format");
    AddValue(command, "--format", "NAME", film.format, OneWordOf({"y4m", "nut", "mkv", "webm"}),
             "Write y4m, nut, mkv or webm to standard output (-o -)")
        .Group("Format");
    AddValue(command, "--loop", "N", film.plays, WholeBetween(0, 65535),
             "Play a gif, apng or webp N times; 0: forever (0)")
        .Group("Format");
    AddValue(command, "--group", "N", film.groupFrames, WholeBetween(1, 100000),
             "Encode each N frames independently; parts begin at multiples of N\n"
             "(100 with --frame-range or --resume, otherwise no groups)")
        .Group("Format");
    AddFlag(command, "--variable-rate", record.variableRate,
            "Store identical frames once in .mp4, .mkv and .webm, with a longer\n"
            "duration (.gif, .apng and .webp always do)")
        .Group("Format");
    AddFlag(command, "--constant-rate", record.constantRate, "Store every frame of a .gif or .apng")
        .Group("Format");
    AddValue(command, "--threads", "N", film.threads, WholeBetween(1, 64),
             "Set the encoder threads; H.264 bytes depend on them (2)")
        .Group("Format");
}

void AddUntil(Command& command, std::vector<Condition>& until)
{
    AddValues(command, "--until", "CONDITION", until, Condition::Parse,
              "End when this condition is true, such as \"17.y < -10\",\n"
              "\"all.speed < 0.01\" or \"awake == 0\"; repeatable")
        .Group("Time");
    AddFlag(
        command, "--until-sleep",
        [&until] { until.push_back(*Condition::Parse("--until-sleep", "awake == 0")); },
        "End when no body is awake")
        .Group("Time");
}

/// Adds the options of the film's length and speed.
void AddTime(Command& command, RecordOptions& record)
{
    AddValue(command, "--seconds", "TIME", record.length.seconds, ParseDuration,
             "Set the length of the film (10)")
        .Group("Time");
    AddValue(command, "--frames", "N", record.length.frames, WholeBetween(1, kMaxFrames),
             "Set the length in frames instead")
        .Group("Time");
    AddValue(command, "--from", "TIME", record.length.from, ParseDuration,
             "Simulate this time before the first frame (0)")
        .Group("Time");
    AddUntil(command, record.length.until);
    AddValue(command, "--fps", "RATE", record.film.framesPerSecond, RatioBetween(0.1, 1000.0),
             "Set the frames per second (60)")
        .Group("Time");
    AddValue(command, "--speed", "FACTOR", record.pace.speed, RatioBetween(0.001, 1000.0),
             "Set simulated seconds per second; 0.25 is slow motion (1)")
        .Group("Time");
    AddFlag(command, "--interpolate", record.pace.interpolate,
            "Show interpolated states between two steps")
        .Group("Time");
}

Result<FrameRange> ParseRange(const std::string& option, const std::string& text)
{
    Result<FrameRange> range = FrameRange::Parse(text);
    return range ? range : BadValue(option, text, "must be frames such as 200-399 or 1-3,5,7-20:2");
}

} // namespace

Command& Declare(Command& program, RecordOptions& record)
{
    Command& command = AddCommand(program, "record", "Make a film of a scene");
    AddScene(command, record.scene);
    AddPath(
        command, "-o,--output", "FILE", record.output,
        "Write the film here: " + JoinedBy(" ", VideoEnds()) +
            ",\nframes-####.png, or - with --format; .html is a page that plays\nit in a browser",
        RecordExtensions());
    AddForce(command, record.film.overwrite);
    AddFlag(command, "--resume", record.film.resume, "Continue a stopped film, or start it");
    AddFlag(command, "--skip-done", record.skipDone,
            "Do nothing if this part of --frame-range is complete");
    AddStats(command, record.messages.stats);
    AddValue(command, "--progress", "KIND", record.messages.progress,
             OneOf<ProgressMode>({{"auto", ProgressMode::Auto},
                                  {"bar", ProgressMode::Bar},
                                  {"lines", ProgressMode::Lines},
                                  {"json", ProgressMode::Json},
                                  {"openjd", ProgressMode::OpenJD},
                                  {"none", ProgressMode::None}}),
             "Show progress as auto, bar, lines, json, openjd, none (auto)");
    AddValue(
        command, "--frame-range", "RANGE", record.length.range, ParseRange,
        "Record only these frames, such as 200-399 or 1-3,5,7-20:2;\n`boxreel merge` joins parts");
    AddPath(command, "--snapshots", "DIR", record.snapshots.folder,
            "Save simulation states in this folder. Start from the last state\n"
            "there that is at or before the first frame");
    AddValue(command, "--snapshot-every", "N", record.snapshots.every,
             WholeBetween(1, 1'000'000'000),
             "Set the steps between snapshots (100, later up to 1/16 of all)");
    AddPath(command, "--thumbnail", "FILE", record.thumbnail.file,
            "Write a picture of one frame, .png", {".png"});
    AddValue(command, "--thumbnail-at", "TIME", record.thumbnail.at, ParseDuration,
             "Set the time of the thumbnail (the middle of the film, or the last\n"
             "frame if --until ends the film before)");
    AddTime(command, record);
    AddFormat(command, record);
    AddLook(command, record.look, nullptr);
    AddBackend(command, record.backend).Group("Picture");
    command.notes = {
        {"Ctrl-C ends with exit code 75 and leaves NAME.part.EXT, which is playable. The same\n"
         "command with --resume continues it, except a page (.html)."}};
    command.examples = {
        "boxreel record pyramid -o pyramid.mp4",
        "boxreel record newtons-cradle -o cradle.gif --seconds 4 --fps 25 --size 480x270",
        "boxreel record dominos -o frames-####.png --frames 120 --hud",
        "boxreel record tumbler -o exact.mkv --quality lossless --speed 0.25",
        "boxreel record dominos -o dominos.html --draw shapes,joints,contacts",
        "boxreel record dominos -o ball.mp4 --camera follow:13:8",
        "boxreel record machine.json -o machine.webm --camera 0,5,20",
        "boxreel record bridge -o bridge.mp4 --theme okabe-ito",
        "boxreel record double-domino -o d.webp --from 1s --until-sleep --thumbnail d.png",
        "boxreel record tumbler -o part-2.mkv --frame-range 200-399 --snapshots states",
        "boxreel record bridge -o - --format y4m | ffplay -"};
    return command;
}

Result<void> Check(RecordOptions& options)
{
    RETURN_IF_ERROR(CheckHud(options.look));
    if (options.scene.empty())
    {
        return Missing("record", "SCENE", "boxreel record pyramid -o pyramid.mp4");
    }
    if (options.output.empty())
    {
        return Missing("record", "-o FILE", "boxreel record pyramid -o pyramid.mp4");
    }
    RETURN_IF_ERROR(CheckFilmName(options.output));
    if (IsPage(options.output))
    {
        RETURN_IF_ERROR(CheckPage(options));
    }
    if (options.film.resume && options.film.overwrite)
    {
        return Conflict("--resume", "--force");
    }
    if (options.constantRate && options.variableRate)
    {
        return Conflict("--constant-rate", "--variable-rate");
    }
    options.film.timing = options.constantRate   ? FrameTiming::Constant
                          : options.variableRate ? FrameTiming::Variable
                                                 : FrameTiming::Automatic;
    if (options.length.range && !options.length.until.empty())
    {
        return Conflict("--frame-range", "--until");
    }
    if (options.skipDone && !options.length.range)
    {
        return Requires("--skip-done", "--frame-range");
    }
    if (options.skipDone && options.film.overwrite)
    {
        return Conflict("--skip-done", "--force");
    }
    if (options.messages.progress == ProgressMode::OpenJD && options.output == "-")
    {
        return Conflict("--progress openjd", "-o -");
    }
    if (options.look.panels.testbed && !options.snapshots.folder.empty())
    {
        return Conflict("--snapshots", "--ui");
    }
    if (options.snapshots.every && options.snapshots.folder.empty())
    {
        return Requires("--snapshot-every", "--snapshots");
    }
    if (options.thumbnail.at && options.thumbnail.file.empty())
    {
        return Requires("--thumbnail-at", "--thumbnail");
    }
    if (options.length.seconds && options.length.frames)
    {
        return Conflict("--seconds", "--frames");
    }
    if (options.length.seconds && options.length.seconds->nanoseconds == 0)
    {
        return Error{ErrorKind::Unusable, "--seconds 0", "must be more than 0"};
    }
    return {};
}

} // namespace boxreel
