// SPDX-License-Identifier: MIT
// The page as a reader has it: in Chromium, without a window. page-harness.js uses it there.
#include "../../golden/TestPictures.h"
#include "../../page/Browser.h"

#include <golden/ReferenceStore.h>
#include <golden/ReportPage.h>
#include <golden/Verdicts.h>
#include <render/Png.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class PageInBrowser : public testing::Test
{
protected:
    void SetUp() override
    {
        if (browser.empty())
        {
            GTEST_SKIP() << "Chromium is not installed; install it with: apt install chromium";
        }
    }

    /// Returns the state of the page at its end, with a script behind it.
    Outcome Load(const std::string& page, const std::string& script) const
    {
        return LoadInChromium(browser, page, script, folder);
    }

    std::string PageOf(const std::map<std::string, FilmStrip>& strips = {}) const
    {
        const Result<std::vector<ReportedMoment>> moments = CollectVerdicts({output});
        EXPECT_TRUE(moments);
        Result<std::string> page = ReportPage(*moments, strips);
        EXPECT_TRUE(page);
        return *page;
    }

    GoldenCandidate World(const std::string& name) const
    {
        GoldenCandidate candidate = test::Candidate(name);
        candidate.camera = Camera{320, 180, 0.0, 6.43, 14.0};
        candidate.state.bodies = {{.number = 0}, {.number = 1, .x = -4.0f, .y = 1.5f}};
        for (std::int64_t step = 1; step <= 60; ++step)
        {
            candidate.trace.steps.push_back({step, "01234567", "ab"});
        }
        return candidate;
    }

    void Approve(const GoldenCandidate& candidate) const { ASSERT_TRUE(store.Accept(candidate)); }

    const std::string browser = Chromium();
    TemporaryFolder folder;
    fs::path output = folder / "output";
    ReferenceStore store{folder / "references", output};
};

FilmStrip SmallStrip()
{
    const Result<std::vector<std::uint8_t>> png = EncodePng(test::Filled(24, 14, test::kDark));
    const std::string bytes(png->begin(), png->end());
    FilmStrip strip;
    strip.width = 24;
    strip.height = 14;
    strip.pictures = {{6, bytes, bytes, bytes, bytes, {2, 2, 5, 5}},
                      {7, bytes, bytes, bytes, bytes, {2, 2, 5, 5}}};
    return strip;
}

TEST_F(PageInBrowser, HasWorkingControlsWithoutConsoleErrors)
{
    // One that passes, one without a reference, one whose body 1 is 3 cm to the right, one with
    // another colour and a point more.
    Approve(World("same/1s"));
    Approve(World("moved/1s"));
    Approve(World("painted/1s"));
    GoldenCandidate moved = World("moved/1s");
    for (int i = 0; i < 4; ++i)
    {
        moved.list.points[std::size_t(4 + i)].x += 0.03f;
    }
    moved.state.bodies[1].x += 0.03f;
    moved.stateHash = "fedcba9876543210";
    for (TraceStep& step : moved.trace.steps)
    {
        step = step.step >= 7 ? TraceStep{step.step, "76543210", "ac"} : step;
    }
    GoldenCandidate painted = World("painted/1s");
    test::FillRect(painted.frame, 20, 20, 60, 50, test::kLight);
    painted.list.items[1].color = test::kLight;
    painted.list.AddPoint({1.0f, 1.0f}, 3.0f, test::kLight);
    for (const GoldenCandidate& candidate : {World("same/1s"), World("gone/1s"), moved, painted})
    {
        ASSERT_TRUE(store.Verify(candidate));
    }
    const Outcome outcome =
        Load(PageOf({{"moved/1s", SmallStrip()}}), ReadBytes(BOXREEL_PAGE_HARNESS));
    const std::string results = ResultsOf(outcome);
    EXPECT_THAT(results, Not(HasSubstr("WRONG")));
    EXPECT_EQ(std::count(results.begin(), results.end(), '\n'), 39) << results;
    EXPECT_THAT(outcome.errors, Not(HasSubstr("CONSOLE")));
}

TEST_F(PageInBrowser, ShowsMarkupInNamesAsText)
{
    const std::string hostile = R"(</script><b class=planted onclick=planted()>\"' x)";
    fs::create_directories(output);
    std::ofstream(output / "a.verdict.json")
        << R"({"verdict": 2, "status": "drawlist", "name": )" << JsonText(hostile)
        << R"(, "renderer": )" << JsonText(hostile) << R"(, "findings": [)" << JsonText(hostile)
        << "]"
        << "}";
    std::ofstream(output / "a.expected.txt")
        << "world labels text #80cccc (1, 2) \"" << hostile << "\"\n";
    std::ofstream(output / "a.actual.txt")
        << "world labels text #80cccc (1, 3) \"" << hostile << "!\"\n";
    const Outcome outcome = Load(PageOf(), R"(
(async () => {
  await new Promise(done => setTimeout(done, 300));
  for (const button of document.querySelectorAll(".tabs button")) button.click();
  const views = [...document.querySelectorAll(".tabs button")].map(button => button.textContent).join();
  const planted = document.querySelectorAll(".planted").length;
  const name = document.querySelector("h2 a").textContent;
  const results = document.createElement("pre");
  results.textContent = `\nBEGIN\n${views} ${planted} ${name.startsWith("\u003c/script>")}\nEND\n`;
  document.body.append(results);
})();
)");
    EXPECT_EQ(ResultsOf(outcome), "Overlay,Draw list 0 true\n");
    EXPECT_THAT(outcome.errors, Not(HasSubstr("CONSOLE")));
}

TEST_F(PageInBrowser, ListsPassedMomentsWhenAllAreAsApproved)
{
    Approve(World("same/1s"));
    ASSERT_TRUE(store.Verify(World("same/1s")));
    const Outcome outcome = Load(PageOf(), R"(
const seen = document.querySelector("#passed li").getClientRects().length;
const results = document.createElement("pre");
results.textContent = `\nBEGIN\n${document.querySelector("#outcome").textContent} ${seen}\nEND\n`;
document.body.append(results);
)");
    EXPECT_EQ(ResultsOf(outcome), "1 moment: all as approved 1\n");
    EXPECT_THAT(outcome.errors, Not(HasSubstr("CONSOLE")));
}

} // namespace
} // namespace boxreel
