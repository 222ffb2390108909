// SPDX-License-Identifier: MIT
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <gtest/gtest.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

/// A race between the threads of an encoder shows in one run of hundreds, a read of memory that was
/// never written only if the memory held something else: the same film, that often, in memory that
/// is filled with another byte each time.
namespace
{

using boxreel::Quality;

constexpr int kRuns = 750;     // of each quality: 3,000 films
constexpr int kSideBySide = 4; // films, of two encoder threads each: more than a small machine has

/// Boxes that move in many directions and cover each other, so that motion differs from macroblock
/// to macroblock.
std::vector<boxreel::Frame> Crowd(int width, int height, int count)
{
    std::vector<boxreel::Frame> frames;
    for (int i = 0; i < count; ++i)
    {
        boxreel::Frame frame(width, height);
        testfilm::FillRect(frame, 0, 0, width, height, {0, 0, 0});
        for (int box = 0; box < 60; ++box)
        {
            const auto swing = [&](int room, int seed) {
                const double angle = 0.02 * (1 + seed % 5) * i + 0.7 * seed;
                return int(0.5 * room * (1.0 + std::sin(angle)));
            };
            const int size = 6 + box % 7;
            const int x = swing(width - size, 3 * box + 1);
            const int y = swing(height - size, 5 * box + 2);
            testfilm::FillRect(frame, x, y, x + size, y + size, testfilm::kOutline);
            testfilm::FillRect(frame, x + 1, y + 1, x + size - 1, y + size - 1, testfilm::kFill);
        }
        frames.push_back(std::move(frame));
    }
    return frames;
}

/// Fills memory that is allocated from now on.
void FillMemoryWith([[maybe_unused]] int byte)
{
#if defined(__GLIBC__)
    mallopt(M_PERTURB, byte);
#endif
}

/// Makes the film again and again, several at a time. Returns all contents that it had.
std::set<std::string> ContentsOf(Quality quality, const std::vector<boxreel::Frame>& frames)
{
    TemporaryFolder folder;
    std::set<std::string> contents;
    std::mutex mutex;
    std::atomic<int> left{kRuns};
    std::vector<std::thread> threads;
    for (int i = 0; i < kSideBySide; ++i)
    {
        threads.emplace_back([&, path = folder / (std::to_string(i) + ".mp4")] {
            for (int run = left--; run > 0; run = left--)
            {
                FillMemoryWith(run % 256);
                testfilm::WriteFilm(path, {.quality = quality, .overwrite = true}, frames);
                const std::lock_guard lock(mutex);
                contents.insert(ReadBytes(path));
            }
        });
    }
    for (std::thread& thread : threads)
    {
        thread.join();
    }
    FillMemoryWith(0);
    return contents;
}

TEST(Repeat, WritesEqualBytesInThreeThousandFilms)
{
    const std::vector<boxreel::Frame> frames = Crowd(160, 96, 40);
    for (const Quality quality :
         {Quality::Draft, Quality::Standard, Quality::High, Quality::Lossless})
    {
        EXPECT_EQ(ContentsOf(quality, frames).size(), 1u) << "quality " << int(quality);
    }
}

} // namespace
