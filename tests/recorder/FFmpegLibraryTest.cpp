// SPDX-License-Identifier: MIT
#include "../base/TemporaryFolder.h"
#include "TestFilm.h"

#include <base/SharedLibrary.h>
#include <recorder/VideoReader.h>
#include <recorder/VideoWriter.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <sys/wait.h>
#include <unistd.h>

namespace
{

using boxreel::ErrorKind;
using boxreel::Result;
using testing::HasSubstr;

bool IsLibavLoaded()
{
    return ReadBytes("/proc/self/maps").find("libavcodec") != std::string::npos;
}

// In a process of its own, where nothing has loaded it.
TEST(FFmpegLibrary, IsLoadedOnlyForFilms)
{
    const pid_t child = fork();
    if (child == 0)
    {
        if (IsLibavLoaded())
        {
            _exit(77); // another test was here before
        }
        TemporaryFolder folder;
        (void)boxreel::CheckVideoPath(folder / "film.mp4", {});
        testfilm::WriteFilm(folder / "a-#.png", {}, testfilm::Drawings(64, 48, 2));
        (void)testfilm::ReadFilm(folder / "a-#.png");
        const bool isLoadedByPictures = IsLibavLoaded();
        testfilm::WriteFilm(folder / "film.mp4", {}, testfilm::Drawings(64, 48, 2));
        const bool isLoadedByFilm = IsLibavLoaded();
        std::filesystem::remove_all(folder / "");
        _exit(!isLoadedByPictures && isLoadedByFilm ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77)
    {
        GTEST_SKIP()
            << "libav was loaded by an earlier test of this process; CTest gives each its own";
    }
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

} // namespace
