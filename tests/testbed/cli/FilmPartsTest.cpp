// SPDX-License-Identifier: MIT
#include "FilmFixture.h"
#include "Refusals.h"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <map>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class FilmParts : public FilmFixture
{
protected:
    std::map<std::string, std::string> Contents() const
    {
        std::map<std::string, std::string> contents;
        for (const std::string& name : folder.Names())
        {
            contents[name] = ReadBytes(folder / name);
        }
        return contents;
    }

    void Clear() const
    {
        for (const std::string& name : folder.Names())
        {
            std::filesystem::remove(folder / name);
        }
    }
};

TEST_F(FilmParts, RefusesPartsThatDifferFromManifest)
{
    for (const std::string kind : {".mkv", ".mp4", ".webm", ".gif", ".apng", ".webp"})
    {
        SCOPED_TRACE(kind);
        const auto make = [&](const std::string& name, const std::string& range) {
            return Run({"record", "tumbler", "--frames", "40", "--fps", "20", "--group", "20",
                        "--size", "96x54", "--frame-range", range, "-o", name + kind})
                .code;
        };
        ASSERT_EQ(make("a", "0-19"), 0);
        ASSERT_EQ(make("b", "20-39"), 0);
        const std::string whole = ReadBytes(folder / ("b" + kind));
        std::string flipped = whole;
        flipped[whole.size() / 2] ^= 1;
        for (const std::string& bad : {whole.substr(0, whole.size() * 99 / 100), flipped,
                                       ReadBytes(folder / ("a" + kind)), whole + "more"})
        {
            std::ofstream(folder / ("b" + kind)) << bad;
            const Outcome refused = Run({"merge", "a" + kind, "b" + kind, "-o", "film" + kind});
            EXPECT_EQ(refused.code, 1);
            EXPECT_THAT(refused.errors, testing::StartsWith("boxreel: b" + kind + ": "));
            EXPECT_FALSE(std::filesystem::exists(folder / ("film" + kind)));
        }
        std::ofstream(folder / ("b" + kind)) << whole;
        EXPECT_EQ(Run({"merge", "a" + kind, "b" + kind, "-o", "film" + kind}).code, 0);
    }
}

TEST_F(FilmParts, JoinsIncompletePartsOnlyIfPartial)
{
    const auto make = [&](const std::string& name, const std::string& range) {
        EXPECT_EQ(Run({"record", "tumbler", "--frames", "41", "--group", "10", "--size", "96x54",
                       "--frame-range", range, "-o", name})
                      .code,
                  0);
    };
    make("b.mkv", "10-19");
    make("c.mkv", "20-39");
    const Outcome refused = Run({"merge", "b.mkv", "c.mkv", "-o", "film.mkv"});
    EXPECT_EQ(refused.code, 1);
    EXPECT_THAT(refused.errors, testing::StartsWith("boxreel: frames 0 to 9 and 40"));
    EXPECT_FALSE(std::filesystem::exists(folder / "film.mkv"));
    const Outcome piece = Run({"merge", "b.mkv", "c.mkv", "-o", "film.mkv", "--partial"});
    ASSERT_EQ(piece.code, 0) << piece.errors;
    EXPECT_EQ(Decode("film.mkv").size(), 30u);
    const std::string part = ReadBytes(folder / "b.mkv");
    const Outcome replaced =
        Run({"merge", "b.mkv", "c.mkv", "-o", "./b.mkv", "--partial", "--force"});
    EXPECT_EQ(replaced.code, 1);
    EXPECT_THAT(replaced.errors, testing::StartsWith("boxreel: -o ./b.mkv: "));
    EXPECT_EQ(ReadBytes(folder / "b.mkv"), part);
}

TEST_F(FilmParts, RefusesToOverwriteStoppedFilm)
{
    for (const std::string kind : {".mkv", ".mp4", ".gif", ".apng", ".webp"})
    {
        SCOPED_TRACE(kind);
        ASSERT_EQ(Run({"record", "tumbler", "--frames", "10", "--group", "10", "--size", "96x54",
                       "--fps", "20", "--frame-range", "0-9", "-o", "a" + kind})
                      .code,
                  0);
        std::ofstream(folder / ("film.part" + kind)) << "left";
        const Outcome refused = Run({"merge", "a" + kind, "-o", "film" + kind});
        EXPECT_EQ(refused.code, 1);
        EXPECT_THAT(refused.errors, HasSubstr("film.part" + kind));
        EXPECT_EQ(ReadBytes(folder / ("film.part" + kind)), "left");
        EXPECT_EQ(Run({"merge", "a" + kind, "-o", "film" + kind, "--force"}).code, 0);
        EXPECT_FALSE(std::filesystem::exists(folder / ("film.part" + kind)));
    }
}

TEST_F(FilmParts, SkipsPartsThatExistAndRefusesOtherFilms)
{
    const auto make = [&](const std::string& scene, const std::string& range) {
        return Run({"record", scene, "--frames", "40", "--group", "20", "--size", "96x54",
                    "--frame-range", range, "-o", "a.mkv", "--skip-done", "--resume"});
    };
    ASSERT_EQ(make("tumbler", "0-19").code, 0);
    const std::filesystem::path part = folder / "a.mkv";
    const auto made = std::filesystem::last_write_time(part);
    const Outcome again = make("tumbler", "0-19");
    EXPECT_EQ(again.code, 0);
    EXPECT_THAT(again.errors, HasSubstr("a.mkv"));
    EXPECT_EQ(std::filesystem::last_write_time(part), made);
    const Outcome other = make("dominos", "0-19");
    ExpectRefused(other, "a.mkv");
    EXPECT_THAT(other.errors, AllOf(HasSubstr("record tumbler"), HasSubstr("record dominos")));
    const Outcome next = make("tumbler", "20-39");
    ExpectRefused(next, "a.mkv");
    EXPECT_THAT(next.errors, HasSubstr("19"));
    std::filesystem::resize_file(part, std::filesystem::file_size(part) - 1);
    const Outcome cut = make("tumbler", "0-19");
    ExpectRefused(cut, "a.mkv");
}

TEST_F(FilmParts, KeepsManifestOfOtherFilmsAndBuilds)
{
    const auto make = [&](const std::string& scene, std::vector<std::string> more) {
        std::vector<std::string> command{"record", scene,    "--frames", "40", "--group",
                                         "20",     "--size", "96x54",    "-o", "v.mkv"};
        command.insert(command.end(), more.begin(), more.end());
        return Run(command);
    };
    ASSERT_EQ(make("pyramid", {"--frame-range", "0-19"}).code, 0);
    std::filesystem::remove(folder / "v.mkv");
    const std::string manifest = ReadBytes(folder / "v.mkv.json");
    std::string older = manifest;
    older.replace(older.find(BOXREEL_VERSION), std::string(BOXREEL_VERSION).size(), "0.0.1");
    std::string unread = manifest;
    unread.replace(unread.find("\"checksum\""), 10, "\"sum\"");
    struct Case
    {
        std::string manifest;
        std::string scene;
        std::string range;
    };
    const Case cases[] = {
        {manifest, "tumbler", "0-19"},
        {manifest, "pyramid", "20-39"},
        {older, "pyramid", "0-19"},
        {unread, "pyramid", "0-19"},
    };
    for (const char* name : {"v.mkv.json", "v.part.mkv.json"})
    {
        for (const Case& c : cases)
        {
            SCOPED_TRACE(std::string(name) + ": " + c.scene + " " + c.range);
            std::ofstream(folder / name) << c.manifest;
            const Outcome refused = make(c.scene, {"--frame-range", c.range});
            EXPECT_EQ(refused.code, 1);
            EXPECT_THAT(refused.errors,
                        testing::StartsWith("boxreel: " + std::string(name) + ": "));
            EXPECT_THAT(folder.Names(), ElementsAre(name));
            EXPECT_EQ(ReadBytes(folder / name), c.manifest);
        }
        std::filesystem::remove(folder / name);
    }
    std::ofstream(folder / "v.part.mkv.json") << older;
    EXPECT_EQ(make("tumbler", {"--frame-range", "0-19", "--force"}).code, 0);
    EXPECT_THAT(folder.Names(), ElementsAre("v.mkv", "v.mkv.json"));
    std::filesystem::remove(folder / "v.mkv");
    EXPECT_EQ(make("tumbler", {"--frame-range", "0-19"}).code, 0) << "they are of this film";
}

TEST_F(FilmParts, ResumesOnlyTheFramesThatWereStopped)
{
    struct Case
    {
        std::vector<std::string> stopped;
        std::vector<std::string> asked;
        std::string first;
    };
    const Case cases[] = {
        {{"--frame-range", "100-9999999"}, {"--frame-range", "100-120"}, "100"},
        {{"--frame-range", "100-9999999"}, {"--frame-range", "100,9999999"}, "100"},
        {{}, {"--frame-range", "0-20"}, "0"},
    };
    const std::pair<std::string, std::string> films[] = {{"z.mp4", "z.part.mp4.json"},
                                                         {"z.apng", "z.part.apng.json"},
                                                         {"z.webp", "z.part.webp.json"},
                                                         {"z-#######.png", ""}};
    for (const auto& [film, manifest] : films)
    {
        for (const Case& c : cases)
        {
            SCOPED_TRACE(film + " " + c.asked.back());
            std::vector<std::string> record{"record",  "tumbler", "--fps",    "20",
                                            "--size",  "32x18",   "-o",       film,
                                            "--group", "50",      "--frames", "10000000"};
            std::vector<std::string> again = record;
            record.insert(record.end(), c.stopped.begin(), c.stopped.end());
            const Outcome stopped = RunBoxreel(record, folder.Path(), [&](int process) {
                StopAfterGroups(process, SIGTERM, 200);
            });
            ASSERT_EQ(stopped.code, 75) << stopped.errors;
            const std::map<std::string, std::string> before = Contents();
            again.insert(again.end(), c.asked.begin(), c.asked.end());
            again.emplace_back("--resume");
            const Outcome refused = Run(again);
            EXPECT_EQ(refused.code, 1);
            EXPECT_THAT(refused.errors, AllOf(HasSubstr(".part."), HasSubstr(" " + c.first + " "),
                                              HasSubstr("9999999)")));
            if (!manifest.empty() && c.asked.back() != "100,9999999")
            {
                ExpectRefused(refused, manifest);
            }
            EXPECT_TRUE(Contents() == before) << "nothing is changed";
            Clear();
        }
    }
}

TEST_F(FilmParts, NamesPicturesThatSkipDoneCannotCheck)
{
    const auto make = [&](std::vector<std::string> more) {
        std::vector<std::string> command{"record", "tumbler", "--frames", "60",
                                         "--size", "32x18",   "-o",       "p-##.png"};
        command.insert(command.end(), more.begin(), more.end());
        return Run(command);
    };
    for (const std::vector<std::string>& parts :
         {std::vector<std::string>{}, std::vector<std::string>{"--frame-range", "20-59"}})
    {
        ASSERT_EQ(make(parts).code, 0);
        const std::map<std::string, std::string> before = Contents();
        for (std::vector<std::string> options :
             {std::vector<std::string>{}, std::vector<std::string>{"--resume"}})
        {
            options.insert(options.end(), {"--frame-range", "30-49", "--skip-done"});
            const Outcome refused = make(options);
            ExpectRefused(refused, "p-30.png");
            EXPECT_THAT(refused.errors, AllOf(HasSubstr("manifest"), HasSubstr("--force")));
        }
        EXPECT_TRUE(Contents() == before);
        Clear();
    }
}

TEST_F(FilmParts, ContinuesStoppedPicturesWithSkipDoneAndResume)
{
    const auto command = [](const std::string& scene, std::vector<std::string> more) {
        std::vector<std::string> record{"record", scene,          "--frames",      "10000000",
                                        "--size", "32x18",        "--frame-range", "100-9999999",
                                        "-o",     "p-#######.png"};
        record.insert(record.end(), more.begin(), more.end());
        return record;
    };
    const auto stop = [&](int process) { StopAfterGroups(process, SIGTERM, 200); };
    const std::vector<std::string> farm = command("tumbler", {"--skip-done", "--resume"});
    ASSERT_EQ(RunBoxreel(farm, folder.Path(), stop).code, 75);
    const std::map<std::string, std::string> before = Contents();
    const Outcome advised = Run(command("tumbler", {"--skip-done"}));
    ExpectRefused(advised, "p-0000100.png");
    EXPECT_THAT(advised.errors, AllOf(HasSubstr("stopped"), HasSubstr("--resume")));
    ExpectRefused(Run(command("pyramid", {"--skip-done"})), "p-0000100.part.png.json");
    EXPECT_TRUE(Contents() == before);
    const Outcome again = RunBoxreel(farm, folder.Path(),
                                     [&](int process) { StopAfterGroups(process, SIGTERM, 400); });
    EXPECT_EQ(again.code, 75) << again.errors;
    EXPECT_GT(Contents().size(), before.size());
}

TEST_F(FilmParts, RefusesToJoinToPageBeforeReadingParts)
{
    for (const char* const part : {"missing.mp4", "page.html"})
    {
        const Outcome page = Run({"merge", part, "-o", "m.html"});
        ExpectRefused(page, "-o m.html");
        EXPECT_THAT(page.errors, HasSubstr("page"));
        ExpectRefused(Run({"merge", part, "-o", "m-##.png"}), "-o m-##.png");
        ExpectRefused(Run({"merge", part, "-o", "m.avi"}), "m.avi");
    }
}

TEST_F(FilmParts, HasPicturesOfAllPartsInOneFolder)
{
    const auto record = [&](const char* range, std::vector<std::string> more = {}) {
        std::vector<std::string> command{"record", "pyramid", "-o",    "a-##.png",      "--frames",
                                         "9",      "--size",  "32x18", "--frame-range", range};
        command.insert(command.end(), more.begin(), more.end());
        return Run(command).code;
    };
    EXPECT_EQ(record("0-3"), 0);
    EXPECT_EQ(record("4-8"), 0);
    EXPECT_EQ(folder.Names().size(), 9u + 2u) << "a manifest for each";
    const std::string kept = ReadBytes(folder / "a-04.png");
    for (const char* const range : {"0-3", "4-8"})
    {
        EXPECT_EQ(record(range, {"--skip-done"}), 0) << range;
        EXPECT_EQ(record(range, {"--resume"}), 1) << range << " is complete";
        EXPECT_EQ(record(range), 1) << range;
    }
    EXPECT_EQ(record("4-7", {"--skip-done"}), 1) << "other frames";
    std::ofstream(folder / "a-06.png") << "changed";
    EXPECT_EQ(record("4-8", {"--skip-done"}), 1);
    EXPECT_EQ(record("0-3", {"--skip-done"}), 0);
    EXPECT_EQ(record("4-8", {"--force"}), 0);
    EXPECT_EQ(ReadBytes(folder / "a-04.png"), kept);
    EXPECT_EQ(Run({"merge", "a-00.png", "a-04.png", "-o", "a.mkv"}).code, 1);
}

TEST_F(FilmParts, JoinsResumedPart)
{
    const std::vector<std::string> record{"record", "tumbler", "--frames",
                                          "800",    "--size",  "160x90"};
    const auto part = [&](const char* name, const char* range) {
        std::vector<std::string> command = record;
        command.insert(command.end(), {"-o", name, "--frame-range", range});
        return command;
    };
    std::vector<std::string> second = part("b.mkv", "100-699");
    const Outcome stopped = RunBoxreel(second, folder.Path(), [&](int process) {
        StopAfterGroups(process, SIGTERM, 300); // 100 of its frames are whole, and more
    });
    ASSERT_EQ(stopped.code, 75) << stopped.errors;
    second.emplace_back("--resume");
    EXPECT_EQ(Run(second).code, 0);
    EXPECT_EQ(Run(part("a.mkv", "0-99")).code, 0);
    EXPECT_EQ(Run(part("c.mkv", "700-799")).code, 0);
    EXPECT_EQ(Run(part("whole.mkv", "0-799")).code, 0);
    const Outcome merged = Run({"merge", "a.mkv", "b.mkv", "c.mkv", "-o", "film.mkv"});
    ASSERT_EQ(merged.code, 0) << merged.errors;
    EXPECT_TRUE(Decode("film.mkv") == Decode("whole.mkv"));
}

} // namespace
} // namespace boxreel
