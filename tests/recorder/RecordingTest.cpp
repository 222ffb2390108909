// SPDX-License-Identifier: MIT
#include "../base/Errors.h"
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <recorder/Recording.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <thread>

namespace
{

using namespace testfilm;
using boxreel::Error;
using boxreel::ErrorKind;
using boxreel::Fails;
using boxreel::Frame;
using boxreel::FrameContent;
using boxreel::Quality;
using boxreel::Recording;
using boxreel::RecordingProgress;
using boxreel::RecordingSettings;
using boxreel::RefusesWith;
using boxreel::Renderer;
using boxreel::Result;
using boxreel::VideoWriter;

constexpr int kWidth = 160;
constexpr int kHeight = 90;

/// A box on its way, which stops at frame `stop`.
void FillBox(std::int64_t frame, std::int64_t stop, FrameContent& content)
{
    content.camera.width = kWidth;
    content.camera.height = kHeight;
    content.camera.centerX = 0.0;
    content.camera.centerY = 0.0;
    content.camera.pixelsPerMeter = 10.0;
    const float x = 0.05f * float(std::min(frame, stop));
    const boxreel::Vec2 box[] = {{x, -1}, {x + 2, -1}, {x + 2, 1}, {x, 1}};
    content.list.AddSolidPolygon(box, 4, kOutline);
}

class RecordingTest : public testing::Test
{
protected:
    void SetUp() override
    {
        Result<Renderer> renderer = Renderer::Create({.width = kWidth, .height = kHeight});
        ASSERT_TRUE(renderer) << renderer.GetError().Text();
        m_renderer.emplace(std::move(*renderer));
    }

    VideoWriter OpenWriter(const std::filesystem::path& path, int width = kWidth)
    {
        Result<VideoWriter> writer = VideoWriter::Open(
            path, {.width = width, .height = kHeight, .quality = Quality::Lossless});
        EXPECT_TRUE(writer) << writer.GetError().Text();
        return std::move(*writer);
    }

    RecordingSettings Settings(std::int64_t count, std::int64_t stop)
    {
        RecordingSettings settings;
        settings.frameCount = count;
        settings.fill = [stop](std::int64_t frame, FrameContent& content) -> Result<void> {
            FillBox(frame, stop, content);
            return {};
        };
        return settings;
    }

    TemporaryFolder m_folder;
    std::optional<Renderer> m_renderer;
};

TEST_F(RecordingTest, EqualsFramesDrawnOneByOne)
{
    constexpr int kCount = 40;
    VideoWriter writer = OpenWriter(m_folder / "film.mkv");
    const Result<boxreel::RecordingEnd> recorded =
        Record(Settings(kCount, 25), *m_renderer, writer);
    ASSERT_TRUE(recorded) << recorded.GetError().Text();
    const Film film = ReadFilm(m_folder / "film.mkv");
    ASSERT_EQ(film.frames.size(), std::size_t(kCount));
    for (int k = 0; k < kCount; ++k)
    {
        FrameContent content;
        FillBox(k, 25, content);
        Frame expected;
        ASSERT_TRUE(m_renderer->Draw(content.list, content.camera, expected));
        EXPECT_EQ(film.frames[std::size_t(k)], expected) << "frame " << k;
    }
}

TEST_F(RecordingTest, RepeatsAndReportsEqualFrames)
{
    VideoWriter writer = OpenWriter(m_folder / "film.mkv");
    RecordingSettings settings = Settings(30, 10);
    RecordingProgress last;
    settings.progress = [&](const RecordingProgress& progress) {
        EXPECT_GT(progress.framesDone, last.framesDone);
        EXPECT_EQ(progress.framesTotal, 30);
        last = progress;
        return true;
    };
    ASSERT_TRUE(Record(settings, *m_renderer, writer));
    EXPECT_EQ(last.framesDone, 30);
    EXPECT_EQ(last.framesRepeated, 19); // frames 11 to 29 equal frame 10
    EXPECT_EQ(ReadFilm(m_folder / "film.mkv").frames.size(), 30u);
}

TEST_F(RecordingTest, WritesFirstFrameEqualToRenderersLast)
{
    FrameContent content;
    FillBox(0, 0, content);
    Frame expected;
    ASSERT_TRUE(m_renderer->Draw(content.list, content.camera, expected));
    VideoWriter writer = OpenWriter(m_folder / "film.mkv");
    ASSERT_TRUE(Record(Settings(3, 0), *m_renderer, writer));
    const Film film = ReadFilm(m_folder / "film.mkv");
    ASSERT_EQ(film.frames.size(), 3u);
    EXPECT_EQ(film.frames[2], expected);
}

TEST_F(RecordingTest, FillsFramesInOrderOnTheCallingThread)
{
    const std::thread::id caller = std::this_thread::get_id();
    std::int64_t next = 0;
    RecordingSettings settings = Settings(20, 100);
    settings.fill = [&](std::int64_t frame, FrameContent& content) -> Result<void> {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_EQ(frame, next++);
        EXPECT_TRUE(content.list.items.empty());
        if (frame > 0)
        {
            EXPECT_EQ(content.camera.width, kWidth) << "the camera stays as it was left";
        }
        FillBox(frame, 100, content);
        return {};
    };
    VideoWriter writer = OpenWriter(m_folder / "film.mkv");
    ASSERT_TRUE(Record(settings, *m_renderer, writer));
    EXPECT_EQ(next, 20);
}

TEST_F(RecordingTest, WritesEqualBytesAtAnySpeed)
{
    for (const char* name : {"a.mp4", "b.mp4"})
    {
        const bool isSlow = *name == 'b';
        RecordingSettings settings = Settings(40, 20);
        settings.fill = [isSlow](std::int64_t frame, FrameContent& content) -> Result<void> {
            if (isSlow && frame % 7 == 0)
            {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            FillBox(frame, 20, content);
            return {};
        };
        VideoWriter writer = OpenWriter(m_folder / name);
        ASSERT_TRUE(Record(settings, *m_renderer, writer));
    }
    EXPECT_EQ(ReadBytes(m_folder / "a.mp4"), ReadBytes(m_folder / "b.mp4"));
}

TEST_F(RecordingTest, LeavesNothingAfterErrorOfTheCaller)
{
    {
        RecordingSettings settings = Settings(1000, 1000);
        settings.fill = [](std::int64_t frame, FrameContent& content) -> Result<void> {
            FillBox(frame, 1000, content);
            return frame < 12 ? Result<void>() : Error{ErrorKind::Failed, "the world ended"};
        };
        VideoWriter writer = OpenWriter(m_folder / "film.mkv");
        const Result<boxreel::RecordingEnd> recorded = Record(settings, *m_renderer, writer);
        EXPECT_THAT(recorded, Fails(ErrorKind::Failed, "the world ended"));
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

// A GIF cannot hold a lossless frame of more than 256 colours: the writer fails in the middle of
// the film.
TEST_F(RecordingTest, ReturnsErrorOfTheEncoderAndEnds)
{
    std::int64_t filled = 0;
    {
        RecordingSettings settings = Settings(1000, 1000);
        settings.fill = [&](std::int64_t frame, FrameContent& content) -> Result<void> {
            ++filled;
            FillBox(frame, 1000, content);
            for (int i = 0; frame >= 12 && i < 300; ++i)
            {
                const boxreel::Vec2 center{-8.0f + 0.05f * float(i), -4.0f + 0.02f * float(i)};
                content.list.AddSolidCircle(
                    center, 0.3f, {1, 0}, {std::uint8_t(i % 256), std::uint8_t(255 - i % 256), 99});
            }
            return {};
        };
        VideoWriter writer = OpenWriter(m_folder / "film.gif");
        const Result<boxreel::RecordingEnd> recorded = Record(settings, *m_renderer, writer);
        EXPECT_THAT(recorded, RefusesWith((m_folder / "film.gif").string(), "frame 12"));
    }
    EXPECT_LT(filled, 30) << "the loop runs on after the encoder has failed";
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

TEST_F(RecordingTest, StopsWithoutErrorAndKeepsTheWriterOpen)
{
    {
        RecordingSettings settings = Settings(100000, 100000);
        settings.progress = [](const RecordingProgress& progress) {
            return progress.framesDone < 10;
        };
        VideoWriter writer = OpenWriter(m_folder / "film.mkv");
        const Result<boxreel::RecordingEnd> recorded = Record(settings, *m_renderer, writer);
        ASSERT_TRUE(recorded);
        EXPECT_EQ(*recorded, boxreel::RecordingEnd::Stopped);
        EXPECT_THAT(m_folder.Names(), testing::ElementsAre("film.part.mkv"));
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

TEST_F(RecordingTest, RefusesAFilmWithoutFrames)
{
    VideoWriter writer = OpenWriter(m_folder / "film.mkv");
    const Result<boxreel::RecordingEnd> recorded = Record(Settings(0, 0), *m_renderer, writer);
    ASSERT_FALSE(recorded);
    EXPECT_EQ(recorded.GetError().kind, ErrorKind::Unusable);
}

TEST_F(RecordingTest, WritesTheSameFilmFrameByFrame)
{
    VideoWriter writer = OpenWriter(m_folder / "pulled.mkv");
    ASSERT_TRUE(Record(Settings(40, 25), *m_renderer, writer));
    Result<Recording> recording =
        Recording::Open(m_folder / "pushed.mkv",
                        {.width = kWidth, .height = kHeight, .quality = Quality::Lossless});
    ASSERT_TRUE(recording) << recording.GetError().Text();
    for (std::int64_t frame = 0; frame < 40; ++frame)
    {
        FrameContent content;
        FillBox(frame, 25, content);
        EXPECT_TRUE(recording->Add(content.list, content.camera));
    }
    const Result<void> closed = recording->Close();
    ASSERT_TRUE(closed) << closed.GetError().Text();
    EXPECT_EQ(ReadFilm(m_folder / "pushed.mkv").frames, ReadFilm(m_folder / "pulled.mkv").frames);
    EXPECT_THAT(m_folder.Names(), testing::UnorderedElementsAre("pulled.mkv", "pushed.mkv"));
}

TEST_F(RecordingTest, ReturnsFirstErrorOfAddFromClose)
{
    {
        Result<Recording> recording =
            Recording::Open(m_folder / "film.mkv", {.width = kWidth, .height = kHeight});
        ASSERT_TRUE(recording);
        FrameContent content;
        FillBox(0, 0, content);
        EXPECT_TRUE(recording->Add(content.list, content.camera));
        content.camera.width += 2;
        EXPECT_FALSE(recording->Add(content.list, content.camera));
        content.camera.width -= 2;
        EXPECT_FALSE(recording->Add(content.list, content.camera)) << "it has a gap";
        const Result<void> closed = recording->Close();
        ASSERT_FALSE(closed);
        EXPECT_EQ(closed.GetError().kind, ErrorKind::Unusable);
        EXPECT_FALSE(recording->Close());
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
}

TEST_F(RecordingTest, LeavesNothingWithoutClose)
{
    {
        Result<Recording> recording =
            Recording::Open(m_folder / "film.mkv", {.width = kWidth, .height = kHeight});
        ASSERT_TRUE(recording);
        FrameContent content;
        FillBox(0, 0, content);
        EXPECT_TRUE(recording->Add(content.list, content.camera));
    }
    EXPECT_THAT(m_folder.Names(), testing::IsEmpty());
    EXPECT_FALSE(Recording::Open(m_folder / "film.mkv", {.width = 33, .height = kHeight}));
}

} // namespace
