// SPDX-License-Identifier: MIT
#include "TemporaryFolder.h"

#include <base/ReadWhole.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace
{

using namespace boxreel;

void ExpectUnusable(const std::filesystem::path& path, std::uintmax_t limit)
{
    const Result<std::string> read = ReadWhole(path, limit);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.GetError().kind, ErrorKind::Unusable);
    EXPECT_EQ(read.GetError().culprit, path.string());
}

TEST(ReadWhole, ReturnsAllBytes)
{
    const TemporaryFolder folder;
    const std::string bytes("a\0\r\n\xff", 5);
    WriteBytes(folder / "file", bytes);
    const Result<std::string> read = ReadWhole(folder / "file", 5);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
}

TEST(ReadWhole, RefusesFileAboveLimit)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "file", "12345");
    ExpectUnusable(folder / "file", 4);
}

TEST(ReadWhole, RefusesWhatIsNotAFile)
{
    const TemporaryFolder folder;
    ExpectUnusable(folder / "missing", 100);
    std::filesystem::create_directory(folder / "folder");
    ExpectUnusable(folder / "folder", 100);
}

TEST(ReadWhole, RefusesFileWithoutPermission)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "file", "secret");
    std::filesystem::permissions(folder / "file", std::filesystem::perms::none);
    if (std::ifstream(folder / "file"))
    {
        GTEST_SKIP() << "this user may read every file";
    }
    ExpectUnusable(folder / "file", 100);
}

} // namespace
