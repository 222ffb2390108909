// SPDX-License-Identifier: MIT
// The content of the page. PageInBrowserTest.cpp tests its behaviour in a browser.
#include "../../base/Errors.h"
#include "../../testbed/cli/Subprocess.h"

#include <golden/ReportPage.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Page : public testing::Test
{
protected:
    ReportedMoment Moment(const std::string& name, const std::string& status,
                          const std::string& message = "it differs") const
    {
        ReportedMoment moment;
        moment.shown.name = name;
        moment.shown.status = status;
        moment.shown.findings = {message};
        moment.shown.json = "{\"name\":" + JsonText(name) + "}";
        moment.shown.base = folder / "base";
        moment.shown.renderer = "some GL";
        return moment;
    }
    static std::string Of(const std::vector<ReportedMoment>& moments,
                          const std::map<std::string, FilmStrip>& strips = {})
    {
        const Result<std::string> page = ReportPage(moments, strips);
        EXPECT_TRUE(page) << page.GetError().Text();
        return page ? *page : "";
    }

    TemporaryFolder folder;
};

TEST_F(Page, ShowsThatAllIsAsApproved)
{
    const std::string page = Of({Moment("a", "same"), Moment("b", "same")});
    EXPECT_THAT(page, AllOf(HasSubstr("<title>2 moments"), HasSubstr("class=\"good\""),
                            HasSubstr("some GL"), Not(HasSubstr("<article"))));
}

TEST_F(Page, CountsEachVerdictAndShowsWhatDiffers)
{
    ReportedMoment missing = Moment("d", "missing");
    missing.shown.accept = "boxreel golden accept d --references '<r>'";
    const std::string page = Of({Moment("a", "same"), Moment("b", "state"), Moment("c", "state"),
                                 missing, Moment("e", "accepted")});
    EXPECT_THAT(page, AllOf(ContainsRegex("<title>5 moments[^<]*3 [^<]*1 accepted"),
                            HasSubstr("2 state"), HasSubstr("1 missing"),
                            HasSubstr("boxreel golden accept d --references '&lt;r&gt;'")));
    EXPECT_THAT(page,
                AllOf(HasSubstr("id=\"b\""), HasSubstr("id=\"e\""), Not(HasSubstr("id=\"a\""))));
}

TEST_F(Page, EmbedsPicturesAndReadsNoOtherFile)
{
    std::ofstream(folder / "base.actual.png") << "Man";
    std::ofstream(folder / "base.expected.txt") << "</script><b>";
    FilmStrip strip;
    strip.pictures = {{.step = 7,
                       .actual = "ab",
                       .closeUp = "",
                       .expected = "",
                       .expectedCloseUp = "",
                       .mark = {1, 2, 3, 4}}};
    const std::string page = Of({Moment("a", "state")}, {{"a", strip}});
    EXPECT_THAT(page,
                AllOf(HasSubstr("\"actualPicture\":\"data:image/png;base64,TWFu\""),
                      HasSubstr("\"expectedList\":\"\\u003c/script>\\u003cb>\""),
                      HasSubstr("\"step\":7,\"actual\":\"data:image/png;base64,YWI=\""),
                      HasSubstr("\"mark\":[1,2,3,4]"), Not(HasSubstr("\"expectedPicture\""))));
    const std::regex outside("(src|href)=\"(?!data:|#)|url\\(|@import|fetch\\(|XMLHttp");
    EXPECT_FALSE(std::regex_search(page, outside));
    EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST_F(Page, ShowsMarkupInNamesAndMessagesAsText)
{
    const std::string hostile = "<b class=\"x\">'&{{script}}";
    const std::string page =
        Of({Moment(hostile, "pixels", hostile), Moment("ok" + hostile, "same")});
    EXPECT_THAT(page, Not(HasSubstr("<b class=\"x\">")));
    EXPECT_THAT(page, AllOf(HasSubstr("<li>&lt;b class=&quot;x&quot;&gt;'&amp;{{script}}</li>"),
                            HasSubstr("data-name=\"ok&lt;b")));
}

TEST_F(Page, ShowsVerdictsOfOtherShards)
{
    ReportedMoment moment = Moment("a", "state");
    moment.shown.folder = "shard-0";
    moment.others = {Moment("a", "same", "all the <same>").shown};
    moment.others[0].folder = "shard-1";
    EXPECT_THAT(Of({moment}), AllOf(HasSubstr("shard-0"), HasSubstr("shard-1"),
                                    HasSubstr("all the &lt;same&gt;")));
}

TEST_F(Page, ListsFindingsOnePerLine)
{
    ReportedMoment moment = Moment("a/b", "state");
    moment.shown.findings = {"worlds differ (x; y)", "line 1 is \"(; \""};
    EXPECT_THAT(Of({moment}),
                HasSubstr("<li>worlds differ (x; y)</li>\n<li>line 1 is &quot;(; &quot;</li>\n"));
}

TEST_F(Page, RefusesAPictureThatCannotBeRead)
{
    std::filesystem::create_directories(folder / "base.actual.png");
    const Result<std::string> page = ReportPage({Moment("a", "state")}, {});
    EXPECT_THAT(page, Refuses(testing::EndsWith("base.actual.png")));
}

} // namespace
} // namespace boxreel
