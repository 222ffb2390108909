// SPDX-License-Identifier: MIT
// `boxreel export` and `boxreel check`.
#include "Refusals.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class SceneFile : public testing::Test
{
protected:
    Outcome Run(const std::vector<std::string>& arguments) const
    {
        return RunBoxreel(arguments, folder.Path());
    }
    void Write(const std::string& text) const { std::ofstream(folder / "a.json") << text; }

    TemporaryFolder folder;
};

TEST_F(SceneFile, GivesPicturesOfExportedScene)
{
    ASSERT_EQ(Run({"export", "bridge", "-o", "bridge.json"}).code, 0);
    for (const char* scene : {"bridge", "bridge.json"})
    {
        const std::string picture = std::string(scene) + ".png";
        ASSERT_EQ(Run({"shot", scene, "--at", "2s", "-o", picture, "--size", "320x180"}).code, 0);
    }
    EXPECT_EQ(ReadBytes(folder / "bridge.png"), ReadBytes(folder / "bridge.json.png"));
}

TEST_F(SceneFile, ExportsGivenMomentAndSeed)
{
    const auto file = [this](const std::vector<std::string>& moment) {
        std::vector<std::string> arguments{"export", "tumbler", "-o", "-"};
        arguments.insert(arguments.end(), moment.begin(), moment.end());
        return Run(arguments).output;
    };
    const std::string later = file({"--at", "1s"});
    EXPECT_TRUE(later != file({}));
    EXPECT_TRUE(later != file({"--at", "1s", "--seed", "2"}));
    EXPECT_TRUE(later == file({"--step", "60"}));
}

TEST_F(SceneFile, IsOverwrittenOnlyByForce)
{
    Write("mine");
    const Outcome outcome = Run({"export", "bridge", "-o", "a.json"});
    EXPECT_NE(outcome.code, 0);
    EXPECT_EQ(ReadBytes(folder / "a.json"), "mine");
    EXPECT_EQ(Run({"export", "bridge", "-o", "a.json", "--force"}).code, 0);
    EXPECT_EQ(Run({"check", "a.json"}).code, 0);
}

TEST_F(SceneFile, ListsOmittedPartsAndNotesInCheck)
{
    Write(R"({"body": [{"name": "cart", "type": 2, "fixture": [{"name": "f", "density": 1,
              "friction": 0.3, "circle": {"radius": 0}}]}]})");
    const Outcome outcome = Run({"check", "a.json"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.output,
                AllOf(HasSubstr("fixture 0 \"f\" of body 0 \"cart\""),
                      HasSubstr("1 body, 0 joints, 0 images, 1 note, 1 left out\n")));
    Write(R"({"body": [{}]})");
    EXPECT_EQ(Run({"check", "a.json"}).code, 0);
}

TEST_F(SceneFile, DrawsImagesAsOutlines)
{
    const std::string body = R"({"body": [{"type": 2, "awake": true}])";
    const std::string image = R"(, "image": [{"body": 0, "file": "cart.png",
        "corners": {"x": [-2, 2, 2, -2], "y": [-1, -1, 1, 1]}}])";
    for (const std::string& text : {body + "}", body + image + "}"})
    {
        Write(text);
        ASSERT_EQ(
            Run({"shot", "a.json", "--step", "0", "-o", "a.svg", "--camera", "0,0,5", "--force"})
                .code,
            0);
        const bool hasOutline = ReadBytes(folder / "a.svg").find("polygon") != std::string::npos ||
                                ReadBytes(folder / "a.svg").find("scene") != std::string::npos;
        EXPECT_EQ(hasOutline, text.find("image") != std::string::npos);
    }
}

TEST_F(SceneFile, RefusesInvalidFiles)
{
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"check"}, "check"},
        {{"check", "none.json"}, "none.json"},
        {{"check", "."}, "."},
        {{"check", "a.json"}, "a.json:1:2"},
        {{"export"}, "export"},
        {{"export", "bridge"}, "export"},
        {{"export", "brigde", "-o", "b.json"}, "'brigde'"},
        {{"export", "bridge", "-o", "b.json", "--at", "1s", "--step", "3"}, "--at"},
        {{"export", "bridge", "-o", "none/b.json"}, "none/b.json"},
        {{"export", "bridge", "-o", "b.txt"}, "-o b.txt"},
    };
    Write("no json");
    for (const auto& [arguments, culprit] : cases)
    {
        ExpectRefused(Run(arguments), culprit);
    }
    EXPECT_THAT(folder.Names(), ElementsAre("a.json"));
}

/// The same part of a text many times, with commas between.
std::string Repeated(const std::string& part, std::size_t times)
{
    std::string text;
    text.reserve((part.size() + 1) * times);
    for (std::size_t i = 0; i < times; ++i)
    {
        text.append(i > 0 ? "," : "").append(part);
    }
    return text;
}

/// The maximum number of bodies, fixtures, joints and vertices of a file.
class LargestSceneFile : public SceneFile, public testing::WithParamInterface<int>
{
protected:
    /// Ends the program if its time is quadratic in their number. Otherwise a second or two are
    /// enough.
    Outcome RunBriefly(const std::vector<std::string>& arguments) const
    {
        rlimit before{};
        getrlimit(RLIMIT_CPU, &before);
        rlimit brief = before;
        brief.rlim_cur = std::min<rlim_t>(BOXREEL_IS_SANITIZED ? 100 : 10, before.rlim_max);
        setrlimit(RLIMIT_CPU, &brief); // of the processor's time [s]
        const Outcome outcome = Run(arguments);
        setrlimit(RLIMIT_CPU, &before);
        return outcome;
    }
};

TEST_P(LargestSceneFile, IsReadInHalfAGigabyte)
{
    switch (GetParam())
    {
    case 0:
        Write("{\"body\":[" + Repeated("{}", 499'999) + "]}");
        break;
    case 1:
        Write(R"({"body":[{"type":0,"fixture":[)" +
              Repeated(R"({"density":1,"circle":{"radius":1}})", 249'999) + "]}]}");
        break;
    case 2:
        Write(R"({"body":[{"type":2},{"type":2}],"joint":[)" +
              Repeated(R"({"type":"rope","bodyA":0,"bodyB":1,"maxLength":1})", 390'000) + "]}");
        break;
    default:
        Write(R"({"body":[{"fixture":[{"chain":{"vertices":{"x":[)" + Repeated("1,0", 499'990) +
              "],\"y\":[" + Repeated("0", 999'980) + "]}}}]}]}");
        break;
    }
    const Outcome outcome = RunBriefly({"check", "a.json"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, testing::IsEmpty());
    if (!BOXREEL_IS_SANITIZED)
    {
        EXPECT_LT(outcome.peakKilobytes, 512 * 1024);
    }
}

INSTANTIATE_TEST_SUITE_P(Files, LargestSceneFile, testing::Range(0, 4));

TEST_F(SceneFile, RefusesFileOfOneGigabyteUnread)
{
    Write("{");
    std::filesystem::resize_file(folder / "a.json", 1u << 30); // sparse
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"check", "a.json"},
          {"shot", "a.json", "-o", "a.png", "--step", "1"},
          {"record", "a.json", "-o", "a.mp4", "--seconds", "1"}})
    {
        const Outcome outcome = Run(arguments);
        ExpectRefused(outcome, "a.json");
        EXPECT_THAT(outcome.errors, HasSubstr("64 MB"));
        if (!BOXREEL_IS_SANITIZED)
        {
            EXPECT_LT(outcome.peakKilobytes, 200 * 1024);
        }
    }
    EXPECT_THAT(folder.Names(), ElementsAre("a.json"));
}

} // namespace
} // namespace boxreel
