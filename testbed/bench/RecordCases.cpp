// SPDX-License-Identifier: MIT
// What is filmed, with which settings, and what ours is held against.
#include "Format.h"
#include "RecordBench.h"

namespace boxreel
{
namespace
{

// The encoder's own process needs 207 to 284 MB at 1080p, with one to three threads; what draws,
// Mesa and its compiler among it, may need so much more.
constexpr double kMemoryOverEncoder = 130e6;

std::string SizeText(const RecordCase& info)
{
    return Format("%dx%d", info.width, info.height);
}

RecordCase Film(const char* name, const char* what, const char* scene)
{
    RecordCase info;
    info.name = name;
    info.what = what;
    info.scene = scene;
    info.goalMemory = kMemoryOverEncoder;
    return info;
}

RecordCase Pyramid()
{
    RecordCase info = Film("pyramid", "the pyramid, which comes to rest", "pyramid");
    info.goalOverEncoding = 1.0;
    info.goalOverImmediate = 0.5;
    return info;
}

RecordCase Asleep()
{
    RecordCase info = Film("asleep", "the pyramid at rest", "pyramid");
    info.from = 8.0;         // it has come to rest after 7
    info.movingFrames = 420; // and moves in each of these
    info.goalTimesFaster = 10.0;
    return info;
}

RecordCase Pictures()
{
    RecordCase info;
    info.name = "pictures";
    info.what = "the tumbler as PNG files";
    info.scene = "tumbler";
    info.frames = 300;
    info.isPictures = true;
    info.goalRate = 100.0;
    return info;
}

RecordCase Memory()
{
    RecordCase info;
    info.name = "memory";
    info.what = "the tumbler, ten times as long too";
    info.scene = "tumbler";
    info.width = 1920;
    info.height = 1080;
    info.longFrames = 6000;
    info.isOptional = true;
    info.goalMemory = kMemoryOverEncoder;
    info.goalGrowth = 10e6;
    return info;
}

using Words = std::vector<std::string>;

void Append(Words& words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
}

} // namespace

std::vector<RecordCase> AllRecordCases()
{
    return {Pyramid(), Film("tumbler", "the tumbler, which never rests", "tumbler"), Asleep(),
            Pictures(), Memory()};
}

RecordCase Resized(RecordCase info, const RecordSize& size)
{
    const RecordCase before = info;
    if (size.frames > 0)
    {
        info.movingFrames = info.movingFrames > 0 ? size.frames : 0;
        info.longFrames = info.longFrames > 0 ? 10 * size.frames : 0;
        info.frames = size.frames;
    }
    if (size.width > 0)
    {
        info.width = size.width;
        info.height = size.height;
    }
    if (!(info == before))
    {
        info.goalOverEncoding = info.goalOverImmediate = info.goalRate = info.goalTimesFaster =
            info.goalMemory = info.goalGrowth = 0.0;
    }
    return info;
}

const char* RoleName(RecordRole role)
{
    constexpr const char* kNames[] = {"boxreel", "start",      "moving",   "movingStart",
                                      "long",    "encodeOnly", "immediate"};
    return kNames[std::size_t(role)];
}

/// All that decides the film is said, so that it is the peer's whatever our defaults are.
std::vector<std::string> OursWords(const RecordCase& info, std::int64_t frames, double from,
                                   const std::filesystem::path& film)
{
    Words words{"record", info.scene,          "-o",       film.string(),
                "--size", SizeText(info),      "--fps",    "60",
                "--from", Format("%gs", from), "--frames", std::to_string(frames)};
    if (!info.isPictures)
    {
        Append(words, {"--codec-option", "preset=veryfast", "--codec-option", "crf=20",
                       "--codec-option", "mbtree=0"});
    }
    return words;
}

/// Two threads, as ours has. Colours are converted and tagged by bt709, or the films would differ.
std::vector<std::string> EncoderWords(const RecordCase& info, const std::string& input,
                                      bool isUpsideDown, const std::filesystem::path& film)
{
    Words words{"-hide_banner", "-loglevel",  "error",    "-nostdin", "-y",
                "-f",           "rawvideo",   "-pix_fmt", "rgba",     "-video_size",
                SizeText(info), "-framerate", "60",       "-i",       input,
                "-threads",     "2"};
    const std::string flip = isUpsideDown ? "vflip," : "";
    if (info.isPictures)
    {
        Append(words, {"-pix_fmt", "rgb24", "-compression_level", "1", "-start_number", "0",
                       film.string()});
        return words;
    }
    Append(words, {"-vf", flip + "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-c:v",
                   "libx264", "-preset", "veryfast", "-crf", "20", "-mbtree", "0", "-colorspace",
                   "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range",
                   "tv", film.string()});
    return words;
}

} // namespace boxreel
