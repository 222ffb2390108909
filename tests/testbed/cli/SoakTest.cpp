// SPDX-License-Identifier: MIT
// Long, large and crowded films: no frame is lost and no memory piles up.
#include "Subprocess.h"

#include <recorder/VideoReader.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace boxreel
{
namespace
{

Outcome Record(const TemporaryFolder& folder, const std::string& scene, const std::string& name,
               const std::vector<std::string>& more)
{
    std::vector<std::string> arguments{"record",  scene,        "-o",  name,
                                       "--force", "--progress", "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Outcome outcome = RunBoxreel(arguments, folder.Path());
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return outcome;
}

struct Decoded
{
    std::int64_t frames = 0;
    int width = 0;
    int height = 0;
};

Decoded Decode(const std::filesystem::path& path)
{
    Decoded decoded;
    Result<VideoReader> reader = VideoReader::Open(path);
    if (!reader)
    {
        ADD_FAILURE() << reader.GetError().Text();
        return decoded;
    }
    Frame frame;
    Result<bool> more = reader->Next(frame);
    for (; more && *more; more = reader->Next(frame))
    {
        ++decoded.frames;
    }
    EXPECT_TRUE(more) << more.GetError().Text();
    decoded.width = frame.width;
    decoded.height = frame.height;
    return decoded;
}

TEST(Soak, KeepsMemoryConstantForLongFilms)
{
    constexpr long kRoom = 2 * 1024; // [KB]
    // An MP4 has its index in front, so it is copied when it is complete: the library's reader and
    // writer keep an entry a frame each meanwhile (143 bytes together). Until then nothing grows.
    constexpr long kIndexRoom = 100000L * 160 / 1024; // [KB]
    const TemporaryFolder folder;
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "film.gif"})
    {
        const auto record = [&](const char* frames) {
            return Record(folder, "tumbler", name, {"--frames", frames, "--size", "64x36"});
        };
        const Outcome brief = record("1000");
        const Outcome lasting = record("100000");
        std::printf("%s: %ld MB, of a thousand frames %ld MB\n", name, lasting.peakKilobytes / 1024,
                    brief.peakKilobytes / 1024);
        EXPECT_GT(brief.peakKilobytes, 1024) << name;
        const long room = kRoom + (name == std::string("film.mp4") ? kIndexRoom : 0);
        EXPECT_LT(lasting.peakKilobytes, brief.peakKilobytes + room) << name;
        // A GIF is shown at most 50 times a second, so it has every other frame.
        EXPECT_EQ(Decode(folder / name).frames, name == std::string("film.gif") ? 50000 : 100000)
            << name;
    }
}

TEST(Soak, RecordsFramesOf8K)
{
    const TemporaryFolder folder;
    for (const char* name : {"film.mp4", "film.mkv", "film.webm", "frame-#.png"})
    {
        Record(folder, "pyramid", name, {"--frames", "3", "--size", "7680x4320"});
    }
    for (const char* name : {"film.mp4", "film.mkv", "film.webm"})
    {
        const Decoded film = Decode(folder / name);
        EXPECT_EQ(film.frames, 3) << name;
        EXPECT_EQ(film.width, 7680) << name;
        EXPECT_EQ(film.height, 4320) << name;
    }
    EXPECT_TRUE(std::filesystem::exists(folder / "frame-2.png"));
}

/// A scene file of a square heap of boxes.
std::string Boxes(int side)
{
    std::string bodies;
    for (int i = 0; i < side * side; ++i)
    {
        bodies += std::string(i > 0 ? "," : "") + R"({"type":2,"awake":true,"position":{"x":)" +
                  std::to_string(0.6 * (i % side)) + R"(,"y":)" +
                  std::to_string(0.6 * double(i / side)) +
                  R"(},"fixture":[{"density":1,"polygon":{"vertices":)"
                  R"({"x":[-0.25,0.25,0.25,-0.25],"y":[-0.25,-0.25,0.25,0.25]}}}]})";
    }
    return R"({"gravity":{"x":0,"y":-10},"body":[{"type":0,"position":{"x":0,"y":-1},)"
           R"("fixture":[{"polygon":{"vertices":{"x":[-100,200,200,-100],"y":[-1,-1,0,0]}}}]},)" +
           bodies + "]}";
}

TEST(Soak, RecordsTenThousandBodies)
{
    const TemporaryFolder folder;
    std::ofstream(folder / "boxes.json") << Boxes(100);
    Record(folder, "boxes.json", "film.mp4", {"--frames", "120"});
    EXPECT_EQ(Decode(folder / "film.mp4").frames, 120);
}

} // namespace
} // namespace boxreel
