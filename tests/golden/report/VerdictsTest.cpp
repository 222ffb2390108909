// SPDX-License-Identifier: MIT
#include "../../base/Errors.h"
#include "../../testbed/cli/Subprocess.h"

#include <golden/Verdicts.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class Verdicts : public testing::Test
{
protected:
    void Write(const std::string& path, const std::string& bytes) const
    {
        fs::create_directories((folder / path).parent_path());
        std::ofstream(folder / path, std::ios::binary) << bytes;
    }
    void Leave(const std::string& where, const std::string& name, const std::string& status,
               const std::string& more = "") const
    {
        Write(where + "/" + name + ".verdict.json",
              R"({"verdict": 2, "name": ")" + name + R"(", "status": ")" + status +
                  R"(", "findings": ["it is )" + status + R"("])" + more + "}");
    }
    std::vector<ReportedMoment> Collect(const std::vector<std::string>& names) const
    {
        std::vector<fs::path> folders;
        for (const std::string& name : names)
        {
            folders.push_back(folder / name);
        }
        Result<std::vector<ReportedMoment>> moments = CollectVerdicts(folders);
        EXPECT_TRUE(moments) << moments.GetError().Text();
        return moments ? *std::move(moments) : std::vector<ReportedMoment>();
    }
    TemporaryFolder folder;
};

TEST_F(Verdicts, AreFoundAtEveryDepthAndSortedByName)
{
    Leave("out", "pyramid/2s", "same");
    Leave("out/shard-0-of-2", "bridge", "pixels");
    Write("out/pyramid/2s.actual.png", "no verdict");
    const std::vector<ReportedMoment> moments = Collect({"out"});
    ASSERT_THAT(moments, SizeIs(2));
    EXPECT_EQ(moments[0].shown.name, "bridge");
    EXPECT_EQ(moments[0].shown.base, folder / "out/shard-0-of-2/bridge");
    EXPECT_EQ(moments[0].shown.folder, (folder / "out/shard-0-of-2").string());
    EXPECT_EQ(moments[1].shown.name, "pyramid/2s");
    EXPECT_TRUE(moments[1].shown.Passed());
}

TEST_F(Verdicts, AreReducedToTheWorstOfShards)
{
    Leave("a", "bridge", "same");
    Leave("b", "bridge", "state");
    Leave("c", "bridge", "pixels");
    Leave("a", "car", "same");
    Leave("b", "car", "same");
    for (const std::vector<std::string>& order :
         std::vector<std::vector<std::string>>{{"a", "b", "c"}, {"c", "b", "a"}})
    {
        const std::vector<ReportedMoment> moments = Collect(order);
        ASSERT_THAT(moments, SizeIs(2));
        EXPECT_EQ(moments[0].shown.status, "state");
        ASSERT_THAT(moments[0].others, SizeIs(2));
        EXPECT_THAT(moments[1].others, IsEmpty()) << "they agree";
    }
}

TEST_F(Verdicts, HaveStepLimitsAndAcceptance)
{
    Leave("out", "a", "state",
          R"(, "step": 120, "firstStep": 43, "firstBodies": [17, 3], "firstHash": "01234567",
             "limits": "cross-machine allows 0.05 %", "ignoredBodies": [3])");
    Leave(
        "out", "b", "missing",
        R"(, "accepted": true, "accept": "do it", "limits": "exact allows 0 pixels", "ignored": [[0, 0, 8, 8]])");
    const std::vector<ReportedMoment> moments = Collect({"out"});
    ASSERT_THAT(moments, SizeIs(2));
    const ReportedVerdict& state = moments[0].shown;
    EXPECT_EQ(state.firstStep, 43);
    EXPECT_EQ(state.lastStep, 120);
    EXPECT_THAT(state.firstBodies, testing::ElementsAre(17, 3));
    EXPECT_EQ(state.firstHash, "01234567");
    EXPECT_EQ(state.limits, "cross-machine allows 0.05 %; bodies left out: 1");
    EXPECT_EQ(state.accept, "");
    EXPECT_EQ(moments[1].shown.status, "accepted");
    EXPECT_EQ(moments[1].shown.accept, "do it");
    EXPECT_EQ(moments[1].shown.limits, "exact allows 0 pixels; rectangles left out: 1");
}

TEST_F(Verdicts, AreEscapedForAnyBytes)
{
    Write("out/a.verdict.json", "{\"verdict\": 2, \"name\": \"</script>\", \"status\": \"same\", "
                                "\"findings\": [\"\xff\xfe\"]}");
    const std::vector<ReportedMoment> moments = Collect({"out"});
    ASSERT_THAT(moments, SizeIs(1));
    EXPECT_EQ(moments[0].shown.name, "</script>");
    EXPECT_THAT(moments[0].shown.json, AllOf(HasSubstr("\\u003c/script>"), Not(HasSubstr("<"))));
    EXPECT_THAT(moments[0].shown.findings, testing::ElementsAre("\uFFFD\uFFFD"));
    EXPECT_EQ(JsonText("a<b\"\n\xff"), "\"a\\u003cb\\\"\\n\uFFFD\"");
}

TEST_F(Verdicts, AreRefusedForFolderWithoutThem)
{
    fs::create_directories(folder / "empty");
    for (const char* name : {"none", "empty"})
    {
        EXPECT_THAT(CollectVerdicts({folder / name}), Refuses((folder / name).string()));
    }
}

TEST_F(Verdicts, AreReportedWithOthersWhenUnreadable)
{
    const std::vector<std::string> damaged{
        "",
        "{",
        "[]",
        R"({"verdict": 2})",
        R"({"verdict": 3, "name": "a", "status": "same", "findings": []})",
        R"({"verdict": 2, "name": "a", "status": "good", "findings": []})",
        R"({"verdict": 2, "name": 5, "status": "same", "findings": []})",
        R"({"verdict": 2, "name": "a", "status": "state", "findings": [], "firstStep": "x"})",
        std::string(2'000'000, ' ') +
            R"({"verdict": 2, "name": "a", "status": "same", "findings": []})"};
    for (const std::string& text : damaged)
    {
        Write("out/x.verdict.json", text);
        const Result<std::vector<ReportedMoment>> moments = CollectVerdicts({folder / "out"});
        ASSERT_TRUE(moments);
        ASSERT_EQ(moments->size(), 1u);
        const ReportedVerdict& shown = moments->front().shown;
        EXPECT_EQ(shown.status, "error") << text.substr(0, 80);
        EXPECT_EQ(shown.name, "x");
        EXPECT_THAT(shown.findings, testing::ElementsAre(HasSubstr("x.verdict.json")))
            << text.substr(0, 80);
    }
}

} // namespace
} // namespace boxreel
