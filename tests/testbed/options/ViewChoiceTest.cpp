// SPDX-License-Identifier: MIT
#include <base/Quoting.h>
#include <options/ViewChoice.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

ViewChoice Parsed(const std::string& text)
{
    const Result<ViewChoice> view = ParseView("--camera", text);
    EXPECT_TRUE(view) << text;
    return view ? *view : ViewChoice(FixedView{-1.0, -1.0, -1.0});
}

std::string Refusal(const std::string& text)
{
    const Result<ViewChoice> view = ParseView("--camera", text);
    if (view)
    {
        return "accepted: " + text;
    }
    EXPECT_EQ(view.GetError().kind, ErrorKind::Unusable) << text;
    EXPECT_EQ(view.GetError().culprit.Text().find('\n'), std::string::npos) << text;
    return view.GetError().culprit;
}

TEST(ViewChoice, ReadsEachForm)
{
    EXPECT_EQ(Parsed("scene"), ViewChoice());
    EXPECT_EQ(Parsed("fit"), ViewChoice(FitView{}));
    EXPECT_EQ(Parsed("fit:world"), ViewChoice(FitView{true}));
    EXPECT_EQ(Parsed("fit:3,17"), ViewChoice(FitBodiesView{{3, 17}}));
    EXPECT_EQ(Parsed("0,-20.5,50"), ViewChoice(FixedView{0.0, -20.5, 50.0}));
    EXPECT_EQ(Parsed("fit:left wheel,3"), ViewChoice(FitBodiesView{{BodyRef("left wheel"), 3}}));
    EXPECT_EQ(Parsed("follow:\"a:b\":5"), ViewChoice(FollowView{{BodyRef("a:b")}, 5.0}));
    EXPECT_EQ(Parsed("follow:17"), ViewChoice(FollowView{{17}, std::nullopt}));
    EXPECT_EQ(Parsed("follow:3,17:12.5"), ViewChoice(FollowView{{3, 17}, 12.5}));
    EXPECT_EQ(Parsed("path:0s=0,20,50;1500ms=10,5,12;6=0,-20,50"),
              ViewChoice(PathView{
                  {{0.0, 0.0, 20.0, 50.0}, {1.5, 10.0, 5.0, 12.0}, {6.0, 0.0, -20.0, 50.0}}}));
}

TEST(ViewChoice, RefusesUnknownViews)
{
    for (const char* text : {"", "fot", "1,2", "1,2,nan", "inf,2,5", "1,2,3,4", "world", "fit,3"})
    {
        EXPECT_EQ(Refusal(text), std::string("--camera ") + (*text == '\0' ? "''" : text));
    }
}

TEST(ViewChoice, RefusesNumbersOutOfLimits)
{
    for (const char* text :
         {"1,2,0", "1,2,-5", "1,2,1e9", "follow:1:0", "follow:1:-3", "follow:1:1e9"})
    {
        EXPECT_EQ(Refusal(text), std::string("--camera ") + text);
    }
    EXPECT_EQ(Refusal("0,-1e9,5"), "--camera 0,-1e9,5");
    EXPECT_EQ(Refusal("1e9,0,5"), "--camera 1e9,0,5");
}

TEST(ViewChoice, RefusesInvalidBodies)
{
    for (const char* text :
         {"fit:", "fit:-1", "fit:1,,2", "fit:1.5", "fit:3:17", "fit:99999999999", "fit: 3"})
    {
        EXPECT_EQ(Refusal(text), AsTyped("--camera", text));
    }
    for (const char* text : {"follow", "follow:", "follow:-1", "follow:1,",
                             "follow:1:", "follow:1:nan", "follow:1:inf", "follow:1:12:5"})
    {
        EXPECT_EQ(Refusal(text), AsTyped("--camera", text));
    }
}

TEST(ViewChoice, RefusesInvalidPaths)
{
    EXPECT_EQ(Refusal("path:0s=0,20,50"), "--camera path:0s=0,20,50");
    EXPECT_EQ(Refusal("path:1s=0,20,50;0s=1,1,5"), "--camera path:1s=0,20,50;0s=1,1,5");
    EXPECT_EQ(Refusal("path:1s=0,20,50;1000ms=1,1,5"), "--camera path:1s=0,20,50;1000ms=1,1,5");
    for (const char* key : {"", "1s", "1s=", "1s=1,2", "1s=1,2,0", "1s=1,nan,5", "1s=inf,2,5",
                            "-1s=1,2,5", "nan=1,2,5", "x=1,2,5", "1s=1,2,5=3", "1s=1,2,5,6"})
    {
        EXPECT_EQ(Refusal("path:0s=0,20,50;" + std::string(key)), AsTyped("--camera path:", key));
    }
    EXPECT_EQ(Refusal("path"), "--camera path: ''");
}

} // namespace
} // namespace boxreel
