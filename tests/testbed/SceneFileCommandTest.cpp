// SPDX-License-Identifier: MIT
// `boxreel export` and `boxreel check`.
#include "Subprocess.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
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

TEST_F(SceneFile, ThatIsExportedShowsThePicturesOfItsScene)
{
    ASSERT_EQ(Run({"export", "bridge", "-o", "bridge.json"}).code, 0);
    for (const char* scene : {"bridge", "bridge.json"})
    {
        const std::string picture = std::string(scene) + ".png";
        ASSERT_EQ(Run({"shot", scene, "--at", "2s", "-o", picture, "--size", "320x180"}).code, 0);
    }
    EXPECT_EQ(ReadFile(folder / "bridge.png"), ReadFile(folder / "bridge.json.png"));
}

TEST_F(SceneFile, IsOfTheMomentAndOfTheSeedThatAreAskedFor)
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

TEST_F(SceneFile, IsNotWrittenOverUnlessTold)
{
    Write("mine");
    const Outcome outcome = Run({"export", "bridge", "-o", "a.json"});
    EXPECT_NE(outcome.code, 0);
    EXPECT_EQ(ReadFile(folder / "a.json"), "mine");
    EXPECT_EQ(Run({"export", "bridge", "-o", "a.json", "--force"}).code, 0);
    EXPECT_EQ(Run({"check", "a.json"}).code, 0);
}

TEST_F(SceneFile, IsCheckedForWhatIsLeftOutAndWhatSurprises)
{
    Write(R"({"body": [{"name": "cart", "type": 2, "fixture": [{"name": "f", "density": 1,
              "friction": 0.3, "circle": {"radius": 0}}]}]})");
    const Outcome outcome = Run({"check", "a.json"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.output,
              "left out: fixture 0 \"f\" of body 0 \"cart\" is left out: a circle needs a radius "
              "above zero.\n"
              "note: body 0 \"cart\": it does not say awake, so it sleeps until something touches "
              "it.\n"
              "a.json: 1 body, 0 joints, 0 images, 1 note, 1 left out\n");
    Write(R"({"body": [{}]})");
    EXPECT_EQ(Run({"check", "a.json"}).code, 0);
}

TEST_F(SceneFile, ShowsItsImagesAsOutlines)
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
        const bool hasOutline = ReadFile(folder / "a.svg").find("polygon") != std::string::npos ||
                                ReadFile(folder / "a.svg").find("scene") != std::string::npos;
        EXPECT_EQ(hasOutline, text.find("image") != std::string::npos);
    }
}

TEST_F(SceneFile, ThatIsNoneIsRefusedInOneSentence)
{
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"check"}, "Name the scene file"},
        {{"check", "none.json"}, "none.json does not exist"},
        {{"check", "a.json"}, "a.json is no JSON text"},
        {{"export"}, "Say which scene"},
        {{"export", "bridge"}, "Say where the scene file goes"},
        {{"export", "brigde", "-o", "b.json"}, "did you mean 'bridge'?"},
        {{"export", "bridge", "-o", "b.json", "--at", "1s", "--step", "3"}, "both say when"},
        {{"export", "bridge", "-o", "none/b.json"}, "none"},
    };
    Write("no json");
    for (const auto& [arguments, message] : cases)
    {
        const Outcome outcome = Run(arguments);
        EXPECT_THAT(outcome.code, testing::AnyOf(1, 4));
        EXPECT_THAT(outcome.errors, AllOf(HasSubstr(message), EndsWith("\n")));
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
    }
    EXPECT_THAT(folder.Files(), ElementsAre("a.json"));
}

} // namespace
} // namespace boxreel
