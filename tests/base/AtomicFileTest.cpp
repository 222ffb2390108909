// SPDX-License-Identifier: MIT
#include "Errors.h"
#include "TemporaryFolder.h"

#include <base/AtomicFile.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>

using namespace boxreel;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace
{

// A disk with room for this many bytes per file, during its lifetime.
class SmallDisk
{
public:
    explicit SmallDisk(rlim_t bytes)
    {
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &m_old);
        rlimit limit = m_old;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallDisk()
    {
        setrlimit(RLIMIT_FSIZE, &m_old);
        std::signal(SIGXFSZ, m_handler);
    }

private:
    rlimit m_old{};
    void (*m_handler)(int) = nullptr;
};

} // namespace

TEST(PartPath, KeepsFolderAndExtension)
{
    EXPECT_EQ(PartPath("dir/film.mp4"), "dir/film.part.mp4");
    EXPECT_EQ(PartPath("film.v2.webm"), "film.v2.part.webm");
    EXPECT_EQ(PartPath("film"), "film.part");
}

TEST(AtomicFile, HasItsNameOnlyOnceItIsComplete)
{
    const TemporaryFolder folder;
    Result<AtomicFile> file = AtomicFile::Create(folder / "film.mp4", false);
    ASSERT_TRUE(file) << file.GetError().Text();
    const std::uint8_t bytes[] = {'a', 'b', 'c'};
    EXPECT_TRUE(file->Write(bytes));
    EXPECT_THAT(folder.Names(), ElementsAre("film.part.mp4"));
    EXPECT_EQ(ReadBytes(file->PartPath()), "abc");
    EXPECT_TRUE(file->Write(bytes));
    EXPECT_TRUE(file->Commit());
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "abcabc");
}

TEST(AtomicFile, CommitsWhatALibraryWroteByName)
{
    const TemporaryFolder folder;
    Result<AtomicFile> file = AtomicFile::Create(folder / "film.mp4", false);
    ASSERT_TRUE(file);
    WriteBytes(file->PartPath(), "by name");
    EXPECT_TRUE(file->Commit());
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "by name");
}

TEST(AtomicFile, RemovesItsPartWhenNotCommitted)
{
    const TemporaryFolder folder;
    {
        Result<AtomicFile> file = AtomicFile::Create(folder / "film.mp4", false);
        ASSERT_TRUE(file);
        AtomicFile moved = std::move(*file);
        EXPECT_THAT(folder.Names(), ElementsAre("film.part.mp4"));
    }
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST(AtomicFile, RemovesItsFormerPartWhenAssignedAnother)
{
    const TemporaryFolder folder;
    Result<AtomicFile> a = AtomicFile::Create(folder / "a", false);
    Result<AtomicFile> b = AtomicFile::Create(folder / "b", false);
    ASSERT_TRUE(a && b);
    *a = std::move(*b);
    EXPECT_THAT(folder.Names(), ElementsAre("b.part"));
    EXPECT_TRUE(a->Commit());
    EXPECT_THAT(folder.Names(), ElementsAre("b"));
}

TEST(AtomicFile, OverwritesThePartThatAKilledProgramLeft)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "film.part.mp4", "the longer rest of a killed run");
    EXPECT_TRUE(WriteWhole(folder / "film.mp4", "short", false));
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "short");
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}

TEST(AtomicFile, KeepsAnExistingFileByDefault)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "film.mp4", "precious");
    EXPECT_THAT(WriteWhole(folder / "film.mp4", "new", false),
                Fails(ErrorKind::Unusable, (folder / "film.mp4").string()));
    EXPECT_FALSE(AtomicFile::Create(folder / "film.mp4", false))
        << "said before the work, not after";
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "precious");
    EXPECT_TRUE(WriteWhole(folder / "film.mp4", "new", true));
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "new");
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}

TEST(AtomicFile, KeepsAFileThatAppearedWhileItWrote)
{
    const TemporaryFolder folder;
    {
        Result<AtomicFile> file = AtomicFile::Create(folder / "film.mp4", false);
        ASSERT_TRUE(file);
        WriteBytes(folder / "film.mp4", "precious");
        EXPECT_THAT(file->Commit(), Fails(ErrorKind::Unusable, (folder / "film.mp4").string()));
    }
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "precious");
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}

TEST(AtomicFile, DetectsFileThatIsBeingWritten)
{
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "film.mp4";
    EXPECT_FALSE(IsBeingWritten(PartPath(path)));
    {
        Result<AtomicFile> file = AtomicFile::Create(path, false);
        ASSERT_TRUE(file);
        EXPECT_TRUE(IsBeingWritten(PartPath(path)));
        ASSERT_TRUE(file->Leave());
    }
    EXPECT_FALSE(IsBeingWritten(PartPath(path)));
}

TEST(AtomicFile, RefusesASecondWriterOfTheSameName)
{
    const TemporaryFolder folder;
    Result<AtomicFile> first = AtomicFile::Create(folder / "film.mp4", true);
    ASSERT_TRUE(first);
    EXPECT_THAT(WriteWhole(folder / "film.mp4", "second", true),
                Fails(ErrorKind::Failed, (folder / "film.mp4").string()));
    const std::uint8_t bytes[] = {'1'};
    EXPECT_TRUE(first->Write(bytes));
    EXPECT_TRUE(first->Commit());
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "1");
    EXPECT_TRUE(WriteWhole(folder / "film.mp4", "third", true));
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "third");
}

TEST(AtomicFile, ReplacesTheTargetOfALinkAndKeepsTheLink)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    EXPECT_TRUE(WriteWhole(folder / "link.txt", "new", true));
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(ReadBytes(folder / "real.txt"), "new");
    EXPECT_THAT(folder.Names(), UnorderedElementsAre("real.txt", "link.txt"));
}

TEST(AtomicFile, NamesAPathThatCannotBeWritten)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "file", "x");
    std::filesystem::create_directory(folder / "sub");
    // /proc is the one folder that every Linux has and that takes no files from anybody.
    const std::filesystem::path bad[] = {folder / "none/a.png",
                                         "/proc/boxreel.png",
                                         folder / "file/a.png",
                                         folder / "sub",
                                         folder / "sub/",
                                         folder / std::string(300, 'n'),
                                         "/dev/null"};
    for (const std::filesystem::path& path : bad)
    {
        EXPECT_THAT(WriteWhole(path, "x", true), Refuses(path.string()));
    }
    EXPECT_THAT(WriteWhole("", "x", true), Refuses("''"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_THAT(folder.Names(), UnorderedElementsAre("file", "sub"));
}

TEST(CheckFolderOf, RefusesAFileWhoseFolderDoesNotExist)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "file", "x");
    EXPECT_TRUE(CheckFolderOf(folder / "a.png"));
    EXPECT_TRUE(CheckFolderOf("a.png"));
    for (const std::filesystem::path& path : {folder / "none/a.png", folder / "file/a.png"})
    {
        EXPECT_THAT(CheckFolderOf(path), Refuses(path.string()));
    }
}

TEST(AtomicFile, NamesWhatOccupiesThePathOfItsPart)
{
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "folder.part.txt");
    WriteBytes(folder / "mine", "mine");
    std::filesystem::create_symlink(folder / "mine", folder / "link.part.txt");
    ASSERT_EQ(mkfifo((folder / "pipe.part.txt").c_str(), 0600), 0);
    for (const char* name : {"folder", "link", "pipe"})
    {
        const std::string path = (folder / name).string();
        EXPECT_THAT(WriteWhole(path + ".txt", "x", true),
                    RefusesWith(path + ".txt", path + ".part.txt"));
    }
    EXPECT_EQ(ReadBytes(folder / "mine"), "mine");
}

TEST(AtomicFile, LeavesTheOldFileAndNoPartWhenTheDiskIsFull)
{
    const TemporaryFolder folder;
    WriteBytes(folder / "film.mp4", "precious");
    {
        const SmallDisk disk(1000);
        EXPECT_THAT(WriteWhole(folder / "film.mp4", std::string(5000, 'x'), true),
                    Fails(ErrorKind::Failed, (folder / "film.mp4").string()));
    }
    EXPECT_EQ(ReadBytes(folder / "film.mp4"), "precious");
    EXPECT_THAT(folder.Names(), ElementsAre("film.mp4"));
}
