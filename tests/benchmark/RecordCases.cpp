// SPDX-License-Identifier: MIT
#include "RecordCases.h"

#include <sstream>

namespace bench
{
namespace
{

using Words = std::vector<std::string>;

Words Joined(Words words, const Words& more)
{
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string Seconds(double seconds)
{
    std::ostringstream text;
    text << seconds << 's';
    return text.str();
}

std::string SizeText(int width, int height)
{
    return std::to_string(width) + "x" + std::to_string(height);
}

/// Every option that affects the film is given, so that it does not depend on our defaults.
Words OurWords(const RecordCase& info, const std::string& program, const Film& film, double from)
{
    const Words words{program,
                      "record",
                      info.scene,
                      "-o",
                      film.path,
                      "--size",
                      SizeText(info.width, info.height),
                      "--fps",
                      "60",
                      "--from",
                      Seconds(from),
                      "--frames",
                      std::to_string(film.frames)};
    return info.isPictures
               ? words
               : Joined(words, {"--codec-option", "preset=veryfast", "--codec-option", "crf=20"});
}

} // namespace

const std::vector<RecordCase>& AllRecordCases()
{
    static const std::vector<RecordCase> all{
        {"pyramid", "the pyramid, which comes to rest", "pyramid"},
        {"tumbler", "the tumbler, which never rests", "tumbler"},
        // It has come to rest after 7 s, and moves in each of the 420 frames before.
        {.name = "asleep",
         .what = "the pyramid at rest",
         .scene = "pyramid",
         .from = 8.0,
         .movingFrames = 420},
        {.name = "pictures",
         .what = "the tumbler as PNG files",
         .scene = "tumbler",
         .frames = 300,
         .isPictures = true},
        {.name = "dominos", .what = "the dominos", .scene = "dominos", .onlyNamed = true},
        {.name = "web", .what = "the web of distance joints", .scene = "web", .onlyNamed = true},
        {.name = "ragdoll", .what = "the ragdolls", .scene = "ragdoll", .onlyNamed = true},
        {.name = "memory",
         .what = "the tumbler, ten times as long too",
         .scene = "tumbler",
         .width = 1920,
         .height = 1080,
         .longFrames = 6000,
         .onlyNamed = true}};
    return all;
}

RecordCase Resized(RecordCase info, std::int64_t frames, int width, int height)
{
    if (frames > 0)
    {
        info.movingFrames = info.movingFrames > 0 ? frames : 0;
        info.longFrames = info.longFrames > 0 ? 10 * frames : 0;
        info.frames = frames;
    }
    info.width = width > 0 ? width : info.width;
    info.height = width > 0 ? height : info.height;
    return info;
}

Words TakeWords(const RecordCase& info, std::int64_t frames)
{
    return {info.scene, std::to_string(frames), std::to_string(info.width),
            std::to_string(info.height), Seconds(info.from)};
}

std::vector<Film> FilmsOf(const RecordCase& info, const std::string& program,
                          const std::string& helper, const std::string& folder)
{
    std::vector<Film> films;
    const auto add = [&](const char* role, const char* method, std::int64_t frames) -> Film& {
        const char* name = info.isPictures ? "/frame-####.png" : "/film.mp4";
        films.push_back({role, method, frames, folder + "/" + role + name, {}});
        return films.back();
    };
    const auto addOurs = [&](const char* role, const char* method, std::int64_t frames,
                             double from) {
        if (frames > 0)
        {
            Film& film = add(role, method, frames);
            film.words = OurWords(info, program, film, from);
            film.isOfRaw = from == info.from;
        }
    };
    addOurs("boxreel", "boxreel record", info.frames, info.from);
    addOurs("start", "  its first frame", 1, info.from);
    addOurs("moving", "  while it moves", info.movingFrames, 0.0);
    addOurs("movingStart", "  the first of these", info.movingFrames > 0 ? 1 : 0, 0.0);
    addOurs("long", "  a longer film", info.longFrames, info.from);
    const Words take = TakeWords(info, info.frames);
    Film& encoding = add("encodeOnly", "ffmpeg {version}, which only encodes", info.frames);
    encoding.words =
        Joined(Joined({helper, "encode"}, take), {folder + "/frames.raw", encoding.path});
    if (!info.isPictures)
    {
        Film& immediate = add("immediate", "immediate mode | ffmpeg {version}", info.frames);
        immediate.words = Joined(Joined({helper, "immediate"}, take), {immediate.path});
    }
    return films;
}

Words CheckWords(const RecordCase& info, const Film& film, const std::string& helper,
                 const std::string& folder)
{
    const bool isImmediate = std::string(film.role) == "immediate";
    return Joined(
        Joined({helper, isImmediate ? "check-immediate" : "check"}, TakeWords(info, film.frames)),
        {film.path, folder + (film.isOfRaw ? "/frames.raw" : "/none")});
}

/// Two threads, as ours has. Colours are converted and tagged by bt709, or the films would differ.
std::vector<std::string> EncoderWords(int width, int height, const std::string& input,
                                      bool isUpsideDown, const std::string& film)
{
    std::vector<std::string> words{
        "ffmpeg",     "-hide_banner", "-loglevel", "error", "-nostdin",    "-y",
        "-f",         "rawvideo",     "-pix_fmt",  "rgba",  "-video_size", SizeText(width, height),
        "-framerate", "60",           "-i",        input,   "-threads",    "2"};
    if (film.ends_with(".png"))
    {
        std::string pattern = film;
        pattern.replace(pattern.find("####"), 4, "%04d");
        return Joined(
            words, {"-pix_fmt", "rgb24", "-compression_level", "1", "-start_number", "0", pattern});
    }
    const std::string flip = isUpsideDown ? "vflip," : "";
    return Joined(words,
                  {"-vf", flip + "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-c:v",
                   "libx264", "-preset", "veryfast", "-crf", "20", "-colorspace", "bt709",
                   "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv", film});
}

} // namespace bench
