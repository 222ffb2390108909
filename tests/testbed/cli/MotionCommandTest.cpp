// SPDX-License-Identifier: MIT
// `boxreel shot` with motion and annotations.
#include "Refusals.h"

#include <render/Png.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

class MotionCommand : public testing::Test
{
protected:
    std::string Written(const std::string& output, const std::vector<std::string>& extra) const
    {
        std::vector<std::string> arguments{"shot", "dominos", "-o", output};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        const Outcome outcome = RunBoxreel(arguments, folder.Path());
        EXPECT_EQ(outcome.code, 0) << output;
        EXPECT_EQ(outcome.output + outcome.errors, "");
        return ReadBytes(folder / output);
    }

    Frame Picture(const std::string& output, const std::vector<std::string>& extra) const
    {
        Written(output, extra);
        const Result<Frame> frame = ReadPng(folder / output);
        EXPECT_TRUE(frame);
        return frame ? *frame : Frame();
    }

    void ExpectRefusal(const std::vector<std::string>& extra, const std::string& culprit) const
    {
        std::vector<std::string> arguments{"shot", "dominos", "-o", "refused.png"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        const Outcome outcome = RunBoxreel(arguments, folder.Path());
        const std::string line = testing::PrintToString(arguments);
        SCOPED_TRACE(line);
        ExpectRefused(outcome, culprit);
        EXPECT_TRUE(folder.Names().empty()) << line;
    }

    TemporaryFolder folder;
};

/// Returns the position of `part` in `whole`, pixel for pixel; (-1, -1) if it is not found.
std::pair<int, int> Find(const Frame& part, const Frame& whole, int fromX, int fromY)
{
    for (int y = fromY; y + part.height <= whole.height; ++y)
    {
        for (int x = fromX; x + part.width <= whole.width; ++x)
        {
            bool equal = true;
            for (int row = 0; equal && row < part.height; ++row)
            {
                const std::uint8_t* const line = part.Pixel(0, row);
                equal = std::equal(line, line + 4 * part.width, whole.Pixel(x, y + row));
            }
            if (equal)
            {
                return {x, y};
            }
        }
    }
    return {-1, -1};
}

TEST_F(MotionCommand, FillsGridWithPicturesOfMoments)
{
    for (const std::vector<std::string>& look :
         {std::vector<std::string>{"--size", "160x90"},
          {"--size", "160x90", "--theme", "print", "--scale", "2", "--trail", "moving"}})
    {
        std::vector<std::string> all = look;
        all.insert(all.end(), {"--at", "0s,1s,2s,2500ms", "--scale-bar", "--force"});
        const Frame sheet = Picture("sheet.png", all);
        const char* const moments[] = {"0s", "1s", "2s", "2500ms"};
        for (int i = 0; i < 4; ++i)
        {
            std::vector<std::string> one = look;
            one.insert(one.end(), {"--at", moments[i], "--force"});
            const Frame single = Picture("single.png", one);
            EXPECT_NE(Find(single, sheet, i % 2 * single.width, i / 2 * single.height),
                      (std::pair{-1, -1}))
                << moments[i];
        }
    }
    EXPECT_THAT(Written("sheet.svg", {"--at", "0s,1.5s", "--size", "160x90"}),
                testing::AllOf(HasSubstr(">0 s</text>"), HasSubstr(">1.5 s</text>")));
}

TEST_F(MotionCommand, HasSmallerDefaultSizeForSeveralMoments)
{
    EXPECT_THAT(Written("a.svg", {"--step", "0,10"}), HasSubstr("width=\"640\" height=\"360\""));
    EXPECT_THAT(Written("b.svg", {"--step", "0,10", "--columns", "1", "--size", "320x180"}),
                HasSubstr("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"344\""));
    EXPECT_EQ(Picture("c.png", {"--step", "10"}).width, 1280);
}

TEST_F(MotionCommand, WritesEqualBytesInEveryFormat)
{
    const std::vector<std::string> look{
        "--at",        "1s,2s",       "--size",      "200x120",
        "--trail",     "moving",      "--onion",     "4:100ms",
        "--axes",      "--scale-bar", "--dimension", "3,4",
        "--dimension", "0,0 to 1,1",  "--caption",   "Dominos, and what they were set up for."};
    for (const char* extension : {".svg", ".png", ".pdf"})
    {
        EXPECT_EQ(Written(std::string("a") + extension, look),
                  Written(std::string("b") + extension, look));
    }
    const std::string svg = Written("c.svg", look);
    for (const char* part : {"class=\"trails\"", "class=\"poses\"", "class=\"annotations\"",
                             ">Dominos, and what", " m</text>"})
    {
        EXPECT_THAT(svg, HasSubstr(part));
    }
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST_F(MotionCommand, WritesLightAndDarkSheetForThemeBoth)
{
    const std::vector<std::string> look{"--at", "1s", "--size", "160x90", "--axes", "--theme"};
    const auto with = [&look](const char* theme) {
        std::vector<std::string> all = look;
        all.emplace_back(theme);
        return all;
    };
    std::vector<std::string> both{"shot", "dominos", "-o", "a.png"};
    const std::vector<std::string> rest = with("both");
    both.insert(both.end(), rest.begin(), rest.end());
    EXPECT_EQ(RunBoxreel(both, folder.Path()).code, 0);
    EXPECT_EQ(ReadBytes(folder / "a-light.png"), Written("l.png", with("print")));
    EXPECT_EQ(ReadBytes(folder / "a-dark.png"), Written("d.png", with("dark")));
}

TEST_F(MotionCommand, DrawsPanelOverTrails)
{
    const Frame plain = Picture("a.png", {"--at", "2s", "--hud"});
    const Frame trails = Picture("b.png", {"--at", "2s", "--hud", "--trail", "moving"});
    EXPECT_NE(plain, trails);
    EXPECT_TRUE(std::equal(plain.Pixel(20, 20), plain.Pixel(150, 20), trails.Pixel(20, 20)));
}

TEST_F(MotionCommand, RefusesInvalidOptionsBeforeSimulation)
{
    const std::string never = "1000000000";
    ExpectRefusal({"--step", never, "--strobe", "1s", "--onion", "3"}, "--strobe");
    ExpectRefusal({"--step", never, "--trail-seconds", "1s"}, "--trail-seconds");
    ExpectRefusal({"--step", never, "--columns", "2"}, "--columns");
    ExpectRefusal({"--step", "0," + never, "--hud"}, "--hud");
    ExpectRefusal({"--step", never, "--hud", "--caption", "x"}, "--hud");
    ExpectRefusal({"--step", never, "--trail", "3,500"}, "--trail 500");
    ExpectRefusal({"--step", never, "--strobe", "1step"}, "--strobe");
    ExpectRefusal({"--step", never + ",0"}, "--step 1000000000,0");
    ExpectRefusal({"--step", "0,1,2,3,4,5,6,7," + never, "--columns", "9", "--size", "1280x720"},
                  "--size");
    ExpectRefusal({"--step", never, "--dimension", "3"}, "--dimension 3");
    ExpectRefusal({"--at", "1s", "--step", "3"}, "--at");
}

/// In the tumbler the drum is body 0, and all others come later.
class MotionOfLaterBodies : public MotionCommand
{
protected:
    Outcome Shot(const std::vector<std::string>& extra) const
    {
        std::vector<std::string> arguments{"shot",   "tumbler", "-o",     "t.svg",
                                           "--size", "320x180", "--force"};
        arguments.insert(arguments.end(), extra.begin(), extra.end());
        return RunBoxreel(arguments, folder.Path());
    }
};

TEST_F(MotionOfLaterBodies, IsShownOnceTheyExist)
{
    const std::pair<std::vector<std::string>, const char*> looks[] = {
        {{"--trail", "3"}, "body-3-trails"},        {{"--strobe", "250ms:3"}, "body-3-poses"},
        {{"--onion", "3:100ms:3"}, "body-3-poses"}, {{"--dimension", "3,5"}, "annotations"},
        {{"--camera", "follow:3:4"}, "body-3"},     {{"--camera", "fit:3,5"}, "body-5"}};
    for (const auto& [look, group] : looks)
    {
        std::vector<std::string> arguments = look;
        arguments.insert(arguments.end(), {"--at", "2s"});
        const Outcome outcome = Shot(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_THAT(ReadBytes(folder / "t.svg"), HasSubstr(std::string("id=\"") + group));
    }
    EXPECT_EQ(Shot({"--at", "0s,1s", "--dimension", "3,5", "--trail", "5"}).code, 0)
        << "there in one of the pictures";
}

TEST_F(MotionOfLaterBodies, IsRefusedBeforeTheyExist)
{
    for (const std::vector<std::string>& look : {std::vector<std::string>{"--trail", "399"},
                                                 {"--strobe", "250ms:399"},
                                                 {"--onion", "3:100ms:399"},
                                                 {"--dimension", "0,399"},
                                                 {"--camera", "follow:399"}})
    {
        std::vector<std::string> arguments = look;
        arguments.insert(arguments.end(), {"--at", "300ms"});
        const Outcome outcome = Shot(arguments);
        EXPECT_EQ(outcome.code, 1) << look.front();
        EXPECT_THAT(outcome.errors, HasSubstr(look.front() + " 399: "));
        EXPECT_TRUE(folder.Names().empty());
    }
}

} // namespace
} // namespace boxreel
