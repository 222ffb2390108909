// SPDX-License-Identifier: MIT
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

/// A race between the threads of an encoder shows in one run of hundreds: the same film, that
/// often.
namespace
{

using boxreel::Quality;

constexpr int kRuns = 750;     // of each quality: 3,000 films
constexpr int kSideBySide = 4; // films, of two encoder threads each: more than a small machine has

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
            while (left-- > 0)
            {
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
    return contents;
}

TEST(Repeat, ThreeThousandFilmsUnderLoadHaveEqualBytes)
{
    const std::vector<boxreel::Frame> frames = testfilm::Drawings(160, 96, 40);
    for (const Quality quality :
         {Quality::Draft, Quality::Standard, Quality::High, Quality::Lossless})
    {
        EXPECT_EQ(ContentsOf(quality, frames).size(), 1u) << "quality " << int(quality);
    }
}

} // namespace
