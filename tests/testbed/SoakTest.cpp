// SPDX-License-Identifier: MIT
// A long film of a busy scene: no frame is lost and no memory piles up.
#include "Subprocess.h"

#include <recorder/VideoReader.h>

#include <gtest/gtest.h>

namespace boxreel
{
namespace
{

Outcome RecordTumbler(const TemporaryFolder& folder, int seconds)
{
    return RunBoxreel({"record", "tumbler", "-o", "film.mp4", "--seconds", std::to_string(seconds),
                       "--size", "320x180", "--force"},
                      folder.Path());
}

TEST(Soak, FiveMinutesOfFilmTakeNoMoreMemoryThanTenSecondsAndLoseNoFrame)
{
    const TemporaryFolder folder;
    const Outcome brief = RecordTumbler(folder, 10);
    const Outcome lasting = RecordTumbler(folder, 300);
    ASSERT_EQ(brief.code, 0) << brief.errors;
    ASSERT_EQ(lasting.code, 0) << lasting.errors;
    EXPECT_GT(brief.peakKilobytes, 1024);
    EXPECT_LT(lasting.peakKilobytes, brief.peakKilobytes + 8 * 1024);

    Result<VideoReader> reader = VideoReader::Open(folder / "film.mp4");
    ASSERT_TRUE(reader) << reader.GetError().message;
    int frames = 0;
    Frame frame;
    Result<bool> more = reader->Next(frame);
    for (; more && *more; more = reader->Next(frame))
    {
        ++frames;
    }
    ASSERT_TRUE(more) << more.GetError().message;
    EXPECT_EQ(frames, 300 * 60);
}

} // namespace
} // namespace boxreel
