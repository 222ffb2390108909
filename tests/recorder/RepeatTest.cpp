// SPDX-License-Identifier: MIT
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <gtest/gtest.h>

#include <string>

/// A race between the threads of an encoder shows in one run of hundreds: the same film, that
/// often.
namespace
{

using boxreel::Quality;

constexpr int kRuns = 500;

TEST(Repeat, FiveHundredRunsGiveTheSameFilm)
{
    const std::vector<boxreel::Frame> frames = testfilm::Drawings(160, 96, 40);
    for (const Quality quality :
         {Quality::Draft, Quality::Standard, Quality::High, Quality::Lossless})
    {
        TemporaryFolder folder;
        std::string first;
        for (int run = 0; run < kRuns; ++run)
        {
            testfilm::WriteFilm(folder / "film.mp4", {.quality = quality, .overwrite = true},
                                frames);
            const std::string bytes = ReadBytes(folder / "film.mp4");
            first = run == 0 ? bytes : first;
            ASSERT_EQ(bytes, first) << "run " << run << ", quality " << int(quality);
        }
    }
}

} // namespace
