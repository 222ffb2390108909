// SPDX-License-Identifier: MIT
// Films when the world outside fails: disks, folders, pipes. One sentence, the right exit code, and
// nothing left behind.
#include "Refusals.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string kEvery[] = {"film.mp4",  "film.mkv", "film.webm", "film.gif", "film.apng",
                              "film.webp", "film.y4m", "film.nut",  "f-###.png"};

/// One line, and it is a message of this program.
void ExpectOneSentence(const std::string& errors)
{
    EXPECT_THAT(errors, StartsWith("boxreel: "));
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
}

std::vector<std::string> Record(const std::string& name, std::vector<std::string> more = {})
{
    std::vector<std::string> command{"record",  "tumbler", "--frames", "400",        "--size",
                                     "320x180", "-o",      name,       "--progress", "none"};
    command.insert(command.end(), more.begin(), more.end());
    return command;
}

/// While one exists, files of this process and its children may not become larger.
class SmallFiles
{
public:
    explicit SmallFiles(rlim_t bytes)
    {
        m_handler = signal(SIGXFSZ, SIG_IGN); // and so it stays in a program that is started
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SmallFiles()
    {
        setrlimit(RLIMIT_FSIZE, &m_before);
        signal(SIGXFSZ, m_handler);
    }
    SmallFiles(const SmallFiles&) = delete;
    SmallFiles& operator=(const SmallFiles&) = delete;

private:
    rlimit m_before{};
    sighandler_t m_handler = SIG_DFL;
};

/// A file system of its own, where that may be made.
class SmallDisk
{
public:
    /// `options`: of tmpfs.
    explicit SmallDisk(const std::string& options)
        : m_isMounted(mount("none", m_folder.Path().c_str(), "tmpfs", 0, options.c_str()) == 0)
    {}
    ~SmallDisk()
    {
        if (m_isMounted)
        {
            umount2(m_folder.Path().c_str(), MNT_DETACH);
        }
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool IsMounted() const { return m_isMounted; }
    const TemporaryFolder& Folder() const { return m_folder; }

    void MakeReadOnly() const
    {
        mount("none", m_folder.Path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr);
    }

private:
    TemporaryFolder m_folder;
    bool m_isMounted;
};

#define BOXREEL_NEEDS(disk)                                                                        \
    if (!(disk).IsMounted())                                                                       \
    GTEST_SKIP() << "only the superuser may make a file system for a test; limits of file sizes "  \
                    "are tested in its place"

class FilmFailures : public testing::Test
{
protected:
    TemporaryFolder folder;
};

/// A film of this name cannot be written in a folder, and leaves nothing there.
void ExpectFails(const std::string& name, const TemporaryFolder& folder)
{
    SCOPED_TRACE(name);
    const Outcome outcome = RunBoxreel(Record(name), folder.Path());
    EXPECT_EQ(outcome.code, 4) << outcome.errors;
    ExpectOneSentence(outcome.errors);
    EXPECT_THAT(outcome.errors,
                StartsWith("boxreel: " + (name.ends_with(".png") ? "f-" : name + ": ")));
    EXPECT_THAT(folder.Names(), IsEmpty());
}

TEST_F(FilmFailures, FailsAtFileSizeLimitInEveryFormat)
{
    for (const std::string& name : kEvery)
    {
        const SmallFiles limit(name.ends_with(".png") ? 500 : 30000);
        ExpectFails(name, folder);
    }
}

TEST_F(FilmFailures, FailsOnFullDiskInEveryFormat)
{
    const SmallDisk disk("size=64k");
    BOXREEL_NEEDS(disk);
    for (const std::string& name : kEvery)
    {
        ExpectFails(name, disk.Folder());
    }
}

TEST_F(FilmFailures, FailsWhenManifestHasNoSpace)
{
    const SmallDisk disk("size=64m,nr_inodes=2"); // the folder itself and the film
    BOXREEL_NEEDS(disk);
    const Outcome outcome = RunBoxreel(Record("film.mkv"), disk.Folder().Path());
    ExpectRefused(outcome, "film.part.mkv.json", 4);
    EXPECT_THAT(disk.Folder().Names(), IsEmpty());
}

TEST_F(FilmFailures, KeepsFilmWhenThumbnailCannotBeWritten)
{
    const SmallFiles limit(60000);
    const Outcome outcome =
        RunBoxreel({"record", "tumbler", "--frames", "3", "--size", "1600x900", "-o", "film.webm",
                    "--progress", "none", "--quality", "draft", "--thumbnail", "film.png"},
                   folder.Path());
    ExpectRefused(outcome, "film.png", 4);
    EXPECT_THAT(folder.Names(), ElementsAre("film.webm"));
}

TEST_F(FilmFailures, RefusesContradictionsBeforeSimulation)
{
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"record", "pyramid", "-o", "f-###.png", "--thumbnail", "f-005.png", "--force"},
         "--thumbnail f-005.png"},
        {{"record", "pyramid", "-o", "f-###.png", "--thumbnail", "./f-0005.png"},
         "--thumbnail ./f-0005.png"},
        {{"record", "pyramid", "-o", "a.mp4", "--thumbnail", ""}, "--thumbnail"},
        {{"record", "pyramid", "-o", "a.mp4", "--frames", "10", "--thumbnail", "a.png",
          "--thumbnail-at", "5s"},
         "--thumbnail-at"},
        {{"record", "pyramid", "-o", "a.part.mp4"}, "-o a.part.mp4"},
        {{"merge", "a.mkv", "-o", "a.part.mkv"}, "-o a.part.mkv"},
        {{"merge", "a.mkv", "-o", "-"}, "-o -"},
        {{"merge", "absent.mkv", "-o", "film.mkv"}, "absent.mkv"},
        {{"merge", ".", "-o", "film.mkv"}, "."},
        {{"record", "pyramid", "-o", "a.webm", "--codec-option", "drop-threshold=50"},
         "--codec-option drop-threshold=50"},
    };
    for (const auto& [arguments, culprit] : cases)
    {
        ExpectRefused(RunBoxreel(arguments, folder.Path()), culprit);
        EXPECT_TRUE(folder.Names().empty()) << culprit;
    }
}

TEST_F(FilmFailures, WarnsOfPartInsideGroup)
{
    const auto errors = [this](const char* range, const char* output = "a.mkv") {
        const Outcome outcome =
            RunBoxreel({"record", "pyramid", "-o", output, "--frames", "20", "--size", "64x64",
                        "--progress", "none", "--group", "10", "--force", "--frame-range", range},
                       folder.Path());
        EXPECT_EQ(outcome.code, 0);
        return outcome.errors;
    };
    EXPECT_THAT(errors("15-19"), HasSubstr("--frame-range 15-19"));
    EXPECT_THAT(errors("10-19"), testing::Not(HasSubstr("--frame-range")));
    EXPECT_EQ(errors("15-19", "pictures-##.png"), "");
}

TEST_F(FilmFailures, KeepsPartsWhenMergeHasNoSpace)
{
    for (const std::string kind : {".mp4", ".mkv", ".webm", ".gif", ".apng", ".webp"})
    {
        SCOPED_TRACE(kind);
        const TemporaryFolder parts;
        const auto part = [&](const std::string& name, const std::string& range) {
            return RunBoxreel({"record", "tumbler", "--frames", "60", "--size", "160x90", "--fps",
                               "30", "--group", "30", "--frame-range", range, "-o", name + kind},
                              parts.Path())
                .code;
        };
        ASSERT_EQ(part("a", "0-29"), 0);
        ASSERT_EQ(part("b", "30-59"), 0);
        const std::vector<std::string> before = parts.Names();
        const SmallFiles limit(9000);
        const Outcome outcome =
            RunBoxreel({"merge", "a" + kind, "b" + kind, "-o", "film" + kind}, parts.Path());
        EXPECT_EQ(outcome.code, 4) << outcome.errors;
        ExpectOneSentence(outcome.errors);
        EXPECT_EQ(parts.Names(), before);
    }
}

TEST_F(FilmFailures, FailsInReadOnlyFolderForEveryFormat)
{
    const SmallDisk disk("size=64k");
    BOXREEL_NEEDS(disk);
    disk.MakeReadOnly();
    for (const std::string& name : kEvery)
    {
        SCOPED_TRACE(name);
        const Outcome outcome = RunBoxreel(Record(name), disk.Folder().Path());
        EXPECT_EQ(outcome.code, 4) << outcome.errors;
        ExpectOneSentence(outcome.errors);
        EXPECT_THAT(outcome.errors,
                    StartsWith("boxreel: " + (name.ends_with(".png") ? "f-" : name + ": ")));
        EXPECT_THAT(disk.Folder().Names(), IsEmpty());
    }
    const std::string elsewhere = (folder / "film.mkv").string();
    const Outcome outcome =
        RunBoxreel(Record(elsewhere, {"--thumbnail", "film.png"}), disk.Folder().Path());
    EXPECT_EQ(outcome.code, 4) << outcome.errors;
    ExpectOneSentence(outcome.errors);
    EXPECT_THAT(folder.Names(), IsEmpty());
}

/// Returns the exit code of a film that is piped to a program that reads a little; `errors`: its
/// messages.
int PipeToHead(const std::string& format, const TemporaryFolder& folder, std::string& errors)
{
    const std::string command = "cd '" + folder.Path().string() +
                                "' && { '" BOXREEL_PROGRAM
                                "' record tumbler --frames 400 --size 320x180 -o - --format " +
                                format +
                                " --progress none 2> errors; echo $? > code; } | head -c 20000 > "
                                "/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    errors = ReadBytes(folder / "errors");
    return std::atoi(ReadBytes(folder / "code").c_str());
}

TEST_F(FilmFailures, FailsWhenPipeIsClosed)
{
    // Repeated, because the output after the first failure depends on timing.
    for (const std::string format :
         {"y4m", "nut", "mkv", "webm", "y4m", "y4m", "y4m", "y4m", "nut"})
    {
        SCOPED_TRACE(format);
        std::string errors;
        EXPECT_EQ(PipeToHead(format, folder, errors), 4);
        ExpectOneSentence(errors);
        EXPECT_THAT(errors, StartsWith("boxreel: standard output: "));
        EXPECT_THAT(folder.Names(), ElementsAre("code", "errors"));
    }
}

TEST_F(FilmFailures, FailsWhenStandardOutputIsOnFullDisk)
{
    const std::string command = "'" BOXREEL_PROGRAM
                                "' record tumbler --frames 100 --size 320x180 -o - --format y4m "
                                "--progress none > /dev/full 2> '" +
                                (folder / "errors").string() + "'; test $? -eq 4";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string errors = ReadBytes(folder / "errors");
    ExpectOneSentence(errors);
    EXPECT_THAT(errors, StartsWith("boxreel: standard output: "));
}

TEST_F(FilmFailures, LeavesPlayablePageAfterSignal)
{
    const std::filesystem::path part = folder / "film.part.html";
    for (const int signal : {SIGINT, SIGTERM})
    {
        const Outcome outcome =
            RunBoxreel({"record", "tumbler", "--frames", "10000000", "-o", "film.html", "--force"},
                       folder.Path(), [&](int process) {
                           constexpr std::uintmax_t kSomeFrames = 100'000; // [bytes]
                           std::error_code none;
                           for (int i = 0; i < 6000; ++i)
                           {
                               const std::uintmax_t size = std::filesystem::file_size(part, none);
                               if (!none && size > kSomeFrames)
                               {
                                   break;
                               }
                               std::this_thread::sleep_for(std::chrono::milliseconds(10));
                           }
                           kill(process, signal);
                       });
        EXPECT_EQ(outcome.code, 75) << outcome.errors;
        EXPECT_THAT(outcome.errors, HasSubstr("film.part.html"));
        EXPECT_THAT(folder.Names(), ElementsAre("film.part.html"));
        const std::string page = ReadBytes(part);
        EXPECT_TRUE(page.ends_with("</html>\n"));
        const std::size_t at = outcome.errors.find("Stopped after ") + 14;
        const std::string frames = outcome.errors.substr(at, outcome.errors.find(' ', at) - at);
        EXPECT_THAT(page, HasSubstr("\"frames\":" + frames + ","));
        std::filesystem::remove(part);
    }
}

} // namespace
} // namespace boxreel
