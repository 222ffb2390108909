// SPDX-License-Identifier: MIT
// `boxreel shot` as SVG, PDF and PNG, in all themes, at any scale.
#include "Refusals.h"

#include <base/Quoting.h>

#include <debugdraw/Theme.h>
#include <render/Png.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class FigureCommand : public testing::Test
{
protected:
    Outcome Shot(const std::string& output, const std::vector<std::string>& extra = {}) const
    {
        std::vector<std::string> arguments{"shot",   "bridge",  "--step", "20",
                                           "--size", "320x180", "-o",     output};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        return RunBoxreel(arguments, folder.Path());
    }

    /// Returns the file of a run that printed nothing.
    std::string Written(const std::string& output, const std::vector<std::string>& extra = {}) const
    {
        const Outcome outcome = Shot(output, extra);
        EXPECT_EQ(outcome.code, 0) << output;
        EXPECT_EQ(outcome.output + outcome.errors, "");
        return ReadBytes(folder / output);
    }

    void ExpectRefusal(const std::vector<std::string>& arguments, int code,
                       const std::string& culprit) const
    {
        const std::vector<std::string> before = folder.Names();
        const Outcome outcome = RunBoxreel(arguments, folder.Path());
        const std::string line = testing::PrintToString(arguments);
        SCOPED_TRACE(line);
        ExpectRefused(outcome, culprit, code);
        EXPECT_EQ(folder.Names(), before) << line;
    }

    TemporaryFolder folder;
};

TEST_F(FigureCommand, SelectsFormatByExtension)
{
    const std::string svg = Written("a.svg", {"--labels"});
    EXPECT_THAT(svg, testing::StartsWith("<?xml"));
    EXPECT_THAT(svg, HasSubstr("<title>Bridge</title>"));
    EXPECT_THAT(svg, HasSubstr("<g id=\"body-17\" class=\"shapes\">"));
    EXPECT_THAT(svg, HasSubstr("<g id=\"joints\" class=\"joints\">"));
    EXPECT_THAT(svg, HasSubstr(">17</text>"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(Written("a.pdf"), testing::StartsWith("%PDF-"));
    EXPECT_THAT(Written("a.png"), testing::StartsWith("\x89PNG"));
    EXPECT_THAT(folder.Names(), ElementsAre("a.pdf", "a.png", "a.svg"));
}

TEST_F(FigureCommand, NamesGroupsByBodiesOfSceneFile)
{
    std::ofstream(folder / "named.json")
        << R"({"body":[{"name":"left plank","type":2,"fixture":[{"density":1,"circle":)"
        << R"({"center":0,"radius":1}}]},{"type":2,"position":{"x":5,"y":0},"fixture":)"
        << R"([{"density":1,"circle":{"center":0,"radius":1}}]}]})";
    const auto shot = [&](const char* layers) {
        const Outcome outcome = RunBoxreel(
            {"shot", "named.json", "--step", "0", "--draw", layers, "--force", "-o", "a.svg"},
            folder.Path());
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return ReadBytes(folder / "a.svg");
    };
    const std::string plain = shot("shapes");
    EXPECT_THAT(plain, HasSubstr("<g id=\"body-0-left-plank\" class=\"shapes\">"));
    EXPECT_THAT(plain, HasSubstr("<g id=\"body-1\" class=\"shapes\">"));
    EXPECT_THAT(plain, Not(HasSubstr("</text>")));
    const std::string named = shot("shapes,names,masses");
    EXPECT_THAT(named, HasSubstr(">left plank</text>"));
    EXPECT_THAT(named, HasSubstr(">1</text>"));
    EXPECT_THAT(named, HasSubstr("class=\"centers-of-mass\""));
}

TEST_F(FigureCommand, ShowsAndSelectsBodiesByName)
{
    std::ofstream(folder / "named.json")
        << R"({"gravity":{"x":0,"y":-10},"body":[{"name":"wall"},{"name":"left ball","type":2,"awake":true,"fixture":)"
        << R"([{"density":1,"circle":{"center":0,"radius":1}}]},{"name":"twin","type":2},)"
        << R"({"name":"twin","type":2}],"joint":[{"type":"rope","name":"long rope","bodyA":0,)"
        << R"("bodyB":1,"anchorA":{"x":-5,"y":5},"anchorB":0,"maxLength":9}]})";
    const auto shot = [&](const std::vector<std::string>& extra) {
        std::vector<std::string> all{"shot",    "named.json", "--step", "30",
                                     "--force", "-o",         "a.svg"};
        all.insert(all.end(), extra.begin(), extra.end());
        return RunBoxreel(all, folder.Path());
    };
    EXPECT_EQ(shot({"--draw", "shapes,glyphs,names", "--labels"}).code, 0);
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr(">1 left ball</text>"));
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr(">long rope</text>"));
    EXPECT_EQ(shot({"--draw", "shapes", "--labels"}).code, 0);
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr(">1</text>"));
    EXPECT_THAT(ReadBytes(folder / "a.svg"), Not(HasSubstr(">long rope</text>")));
    EXPECT_EQ(shot({"--trail", "left ball"}).code, 0);
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr("class=\"trails\""));
    EXPECT_EQ(shot({"--dimension", "wall to left ball", "--camera", "fit:wall,left ball"}).code, 0);
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr(" m</text>"));
    for (const std::string option : {"--trail", "--camera"})
    {
        const std::string before = option == "--camera" ? "follow:" : "";
        const Outcome twins = shot({option, before + "twin"});
        EXPECT_EQ(twins.code, 1);
        EXPECT_THAT(twins.errors, HasSubstr(option + " twin"));
        EXPECT_THAT(shot({option, before + "left bal"}).errors, HasSubstr("mean 'left ball'?"));
    }
}

TEST_F(FigureCommand, WarnsOnceOfMissingGlyphs)
{
    const std::string caption = "Fig. \u6f22\u5b57\u6f22, \u00b5m";
    const Outcome png = Shot("a.png", {"--caption", caption, "--theme", "both"});
    EXPECT_EQ(png.code, 0);
    EXPECT_THAT(png.errors, HasSubstr(" \u6f22\u5b57,"));
    const Outcome pdf = Shot("a.pdf", {"--caption", caption + " \u0633\u0644\u0627\u0645"});
    EXPECT_EQ(pdf.code, 0);
    EXPECT_THAT(pdf.errors, HasSubstr("\u6f22\u5b57\u0633\u0644\u0627\u0645"));
    EXPECT_EQ(Shot("b.pdf", {"--caption", "Fig. 1, \u00b5m, \u0416, \u03c9"}).errors, "");
    EXPECT_THAT(Written("a.svg", {"--caption", caption}), HasSubstr("\u6f22\u5b57"));
}

TEST_F(FigureCommand, FailsWithoutFileWhenSizeLimitIsReached)
{
    for (const char* const output : {"a.png", "a.svg", "a.pdf"})
    {
        // The limit is in blocks of 512 bytes. Uses a shell, because this process may ignore the
        // signal.
        const std::string line = "cd '" + folder.Path().string() +
                                 "' && ulimit -f 2 && exec '" BOXREEL_PROGRAM
                                 "' shot pyramid --at 0s -o " +
                                 output + " 2> /dev/null";
        const int status = std::system(line.c_str());
        ASSERT_TRUE(WIFEXITED(status)) << output << " died of signal " << WTERMSIG(status);
        EXPECT_EQ(WEXITSTATUS(status), 4) << output;
        EXPECT_THAT(folder.Names(), testing::IsEmpty());
    }
}

TEST_F(FigureCommand, RefusesLargeSheetsAsPng)
{
    const auto sheet = [&](const char* output) {
        return RunBoxreel(
            {"shot", "newtons-cradle", "--step", "1,2,3", "--size", "8192x8192", "-o", output},
            folder.Path());
    };
    for (const char* output : {"a.svg", "a.pdf"})
    {
        EXPECT_EQ(sheet(output).errors, "");
    }
    EXPECT_THAT(ReadBytes(folder / "a.svg"), HasSubstr("width=\"24632\""));
    EXPECT_EQ(sheet("a.png").code, 1);
    EXPECT_THAT(sheet("a.png").errors, HasSubstr("--size"));
}

TEST_F(FigureCommand, WritesEqualBytesForEqualCommands)
{
    for (const char* extension : {".svg", ".pdf", ".png"})
    {
        const std::vector<std::string> look{"--labels", "--theme", "print", "--scale", "1.5"};
        EXPECT_EQ(Written(std::string("a") + extension, look),
                  Written(std::string("b") + extension, look))
            << extension;
    }
}

TEST_F(FigureCommand, MultipliesPixelsByScale)
{
    Written("a.png", {"--scale", "2.5", "--hud"});
    const Result<Frame> frame = ReadPng(folder / "a.png");
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->width, 800);
    EXPECT_EQ(frame->height, 450);
    EXPECT_THAT(Written("a.svg", {"--scale", "0.5"}),
                HasSubstr("width=\"160\" height=\"90\" viewBox=\"0 0 320 180\""));
    EXPECT_EQ(Written("one.png", {"--scale", "1"}), Written("plain.png"));
    EXPECT_EQ(RunBoxreel({"shot", "bridge", "--step", "1", "--size", "1280x720", "--scale", "16",
                          "-o", "large.svg"},
                         folder.Path())
                  .code,
              0);
    EXPECT_THAT(ReadBytes(folder / "large.svg"), HasSubstr("width=\"20480\""))
        << "8192 is a limit of pixels";
}

TEST_F(FigureCommand, ChangesOnlyColoursByTheme)
{
    const std::string classic = Written("classic.svg", {"--theme", "classic"});
    EXPECT_EQ(classic, Written("default.svg"));
    for (const char* theme : {"okabe-ito", "print", "dark"})
    {
        const std::string svg = Written(std::string(theme) + ".svg", {"--theme", theme});
        EXPECT_NE(svg, classic);
        EXPECT_EQ(std::count(svg.begin(), svg.end(), '\n'),
                  std::count(classic.begin(), classic.end(), '\n'));
    }
    EXPECT_NE(Written("print.png", {"--theme", "print"}), Written("classic.png"));
}

TEST_F(FigureCommand, WritesLightAndDarkPictureForThemeBoth)
{
    for (const char* extension : {".svg", ".png"})
    {
        EXPECT_EQ(Shot(std::string("twin") + extension, {"--theme", "both"}).code, 0);
    }
    EXPECT_THAT(folder.Names(),
                ElementsAre("twin-dark.png", "twin-dark.svg", "twin-light.png", "twin-light.svg"));
    EXPECT_EQ(ReadBytes(folder / "twin-light.svg"), Written("print.svg", {"--theme", "print"}));
    EXPECT_EQ(ReadBytes(folder / "twin-dark.svg"), Written("dark.svg", {"--theme", "dark"}));
    EXPECT_EQ(ReadBytes(folder / "twin-dark.png"), Written("dark.png", {"--theme", "dark"}));

    // If one of them already exists, neither is written.
    std::filesystem::remove(folder / "twin-light.svg");
    std::ofstream(folder / "twin-dark.svg") << "mine";
    EXPECT_EQ(Shot("twin.svg", {"--theme", "both"}).code, 1);
    EXPECT_FALSE(std::filesystem::exists(folder / "twin-light.svg"));
    EXPECT_EQ(ReadBytes(folder / "twin-dark.svg"), "mine");
}

TEST_F(FigureCommand, RefusesInvalidOptionsBeforeSimulation)
{
    const auto shot = [](const std::string& output, const std::vector<std::string>& extra) {
        std::vector<std::string> arguments{"shot", "pyramid", "--step", "1000000000", "-o", output};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        return arguments;
    };
    for (const char* scale : {"0", "-1", "0.09", "16.1", "nan", "2x", ""})
    {
        ExpectRefusal(shot("a.svg", {"--scale", scale}), 1, AsTyped("--scale", scale));
    }
    ExpectRefusal(shot("a.png", {"--scale", "8"}), 1, "--scale");
    ExpectRefusal(shot("a.svg", {"--theme", "neon"}), 1, "--theme neon");
    ExpectRefusal(shot("a.svg", {"--hud"}), 1, "--hud");
    ExpectRefusal(shot("a.jpg", {}), 1, "a.jpg");
    ExpectRefusal(shot("none/a.pdf", {}), 1, "none/a.pdf");
    ExpectRefusal(shot("none/a.svg", {"--theme", "both"}), 1, "none/a-light.svg");
    std::filesystem::create_directory(folder / "a.pdf");
    ExpectRefusal(shot("a.pdf", {}), 1, "a.pdf");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--frames", "10000000", "--theme", "both"},
                  1, "--theme both");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--frames", "10000000", "--theme", "neon"},
                  1, "--theme neon");
    ExpectRefusal({"record", "pyramid", "-o", "a.mp4", "--scale", "2"}, 1, "--scale");
}

TEST_F(FigureCommand, NamesMissingCairoForPdf)
{
    std::filesystem::create_directory(folder / "lib");
    std::ofstream(folder / "lib/libcairo.so.2") << "no library";
    setenv("LD_LIBRARY_PATH", (folder / "lib").c_str(), 1);
    ExpectRefusal({"shot", "pyramid", "--step", "1000000000", "-o", "a.pdf"}, 3, "libcairo.so.2");
    Written("a.svg"); // needs no library
    unsetenv("LD_LIBRARY_PATH");
}

TEST_F(FigureCommand, AppliesThemesToFilms)
{
    const auto film = [&](const std::string& theme) {
        const Outcome outcome =
            RunBoxreel({"record", "bridge", "--frames", "2", "--size", "160x90", "--theme", theme,
                        "--progress", "none", "-o", theme + "-#.png"},
                       folder.Path());
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        const Result<Frame> frame = ReadPng(folder / (theme + "-0.png"));
        EXPECT_TRUE(frame);
        return frame ? *frame : Frame();
    };
    EXPECT_EQ(int(film("print").Pixel(1, 1)[0]), 255);
    EXPECT_EQ(int(film("classic").Pixel(1, 1)[0]), 26);
}

} // namespace
} // namespace boxreel
