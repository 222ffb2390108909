// SPDX-License-Identifier: MIT
#include <bench/ChartCanvas.h>
#include <bench/ChartLabels.h>
#include <bench/ChartParts.h>
#include <bench/ChartScale.h>
#include <render/Png.h>

#include "Subprocess.h"

#include <debugdraw/AtomicFile.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace boxreel
{
namespace
{

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Remembers what was painted; every letter is as wide as half its height.
class Recorder : public ChartCanvas
{
public:
    struct Box
    {
        double x, y, width, height;
        ChartColor color;
    };
    struct Word
    {
        std::string text;
        double x, y;
        TextPlace place;
    };

    double TextWidth(const std::string& text, const TextStyle& style) override
    {
        return 0.5 * style.size * double(text.size());
    }
    void Text(double x, double y, const std::string& text, const TextStyle& style) override
    {
        words.push_back({text, x, y, style.place});
    }
    void Lines(const std::vector<std::pair<double, double>>& points,
               const LineStyle& style) override
    {
        lines.push_back(points);
        anyDashed = anyDashed || style.stroke == ChartStroke::Dashed;
    }
    void Rectangle(double x, double y, double width, double height,
                   const ChartColor& color) override
    {
        boxes.push_back({x, y, width, height, color});
    }
    void Disc(double x, double y, double, const ChartColor&) override { discs.emplace_back(x, y); }

    const Word& Find(const std::string& text) const
    {
        const auto found = std::find_if(words.begin(), words.end(),
                                        [&](const Word& word) { return word.text == text; });
        EXPECT_NE(found, words.end()) << text;
        return found == words.end() ? words.front() : *found;
    }

    std::vector<Box> boxes;
    std::vector<Word> words;
    std::vector<std::vector<std::pair<double, double>>> lines;
    std::vector<std::pair<double, double>> discs;
    bool anyDashed = false;
};

std::vector<std::string> Named(const ChartScale& scale)
{
    std::vector<std::string> texts;
    for (const ChartTick& tick : scale.Ticks())
    {
        if (!tick.text.empty())
        {
            texts.push_back(tick.text);
        }
    }
    return texts;
}

BarChart TwoBars()
{
    BarChart chart;
    chart.frame.title = "Faster";
    chart.axis = {"times", true};
    chart.start = 1.0;
    chart.markName = "goal";
    chart.series = {{"than A", 0}, {"than B", 1}};
    chart.groups = {{"rain", "drops", "3 ms", {{10.0, "10x", 100.0}, {0.1, "0.1x"}}},
                    {"snow", "", "", {{kNoValue, "burst"}, {2.0, "2x"}}}};
    return chart;
}

/// Boxes as high as a bar, without those of the legend.
std::vector<Recorder::Box> Bars(const Recorder& canvas)
{
    std::vector<Recorder::Box> bars(canvas.boxes);
    bars.erase(bars.begin(), bars.begin() + 2);
    return bars;
}

TEST(ChartScale, PutsEqualRatiosAtEqualDistancesOnALogarithmicAxis)
{
    const ChartScale scale({"", true}, {1.0, 1000.0}, 0.0, 300.0);
    EXPECT_NEAR(scale.At(1.0), 0.0, 1e-9);
    EXPECT_NEAR(scale.At(10.0), 100.0, 1e-9);
    EXPECT_NEAR(scale.At(1000.0), 300.0, 1e-9);
}

TEST(ChartScale, WidensToRoundNumbers)
{
    const ChartScale logarithmic({"", true}, {0.7, 28.0, kNoValue}, 0.0, 1.0);
    EXPECT_EQ(logarithmic.Low(), 0.5);
    EXPECT_EQ(logarithmic.High(), 50.0);
    EXPECT_THAT(Named(logarithmic), ElementsAre("0.5", "1", "2", "5", "10", "20", "50"));
    const ChartScale linear({"", false}, {3.0, 98.0}, 0.0, 1.0);
    EXPECT_EQ(linear.Low(), 0.0);
    EXPECT_EQ(linear.High(), 100.0);
    EXPECT_THAT(Named(linear),
                ElementsAre("0", "10", "20", "30", "40", "50", "60", "70", "80", "90", "100"));
}

TEST(ChartScale, HasRoomForOneValueAndForNone)
{
    for (const bool logarithmic : {false, true})
    {
        const ChartScale one({"", logarithmic}, {5.0}, 0.0, 100.0);
        EXPECT_TRUE(std::isfinite(one.At(5.0)));
        EXPECT_LT(one.Low(), one.High());
        const ChartScale none({"", logarithmic}, {}, 0.0, 100.0);
        EXPECT_LT(none.Low(), none.High());
    }
}

TEST(ChartScale, NamesOnlyDecadesWhereThereAreMany)
{
    EXPECT_THAT(Named(ChartScale({"", true}, {1.0, 1e5}, 0.0, 1.0)),
                ElementsAre("1", "10", "100", "1,000", "10,000", "100,000"));
    EXPECT_GT(ChartScale({"", true}, {1.0, 1e5}, 0.0, 1.0).Ticks().size(), 40u);
    EXPECT_EQ(ChartScale({"", true}, {1.0, 1e12}, 0.0, 1.0).Ticks().size(), 13u);
}

TEST(ChartScale, WritesNumbersShortAndThousandsApart)
{
    EXPECT_EQ(ChartNumber(0.05), "0.05");
    EXPECT_EQ(ChartNumber(0.0), "0");
    EXPECT_EQ(ChartNumber(999.0), "999");
    EXPECT_EQ(ChartNumber(28100.0), "28,100");
    EXPECT_EQ(ChartNumber(-1234567.0), "-1,234,567");
}

TEST(Chart, BarsBeginAtTheStartAndGoTheirWayOnItsScale)
{
    Recorder canvas;
    Paint(canvas, TwoBars());
    const std::vector<Recorder::Box> bars = Bars(canvas);
    ASSERT_EQ(bars.size(), 3u);
    EXPECT_NEAR(bars[1].x + bars[1].width, bars[0].x, 1e-6) << "both begin at 1";
    EXPECT_NEAR(bars[0].width, bars[1].width, 1e-6) << "ten times and a tenth are equally long";
    EXPECT_GT(bars[1].y, bars[0].y + bars[0].height - 1e-6);
}

TEST(Chart, LabelsStandOutsideTheirBarsAndAwayFromTheMark)
{
    BarChart chart = TwoBars();
    Recorder canvas;
    Paint(canvas, chart);
    const std::vector<Recorder::Box> bars = Bars(canvas);
    EXPECT_GT(canvas.Find("10x").x, bars[0].x + bars[0].width);
    EXPECT_LT(canvas.Find("0.1x").x, bars[1].x);
    EXPECT_EQ(canvas.Find("0.1x").place, TextPlace::LeftOf);
    EXPECT_GT(canvas.Find("burst").x, bars[0].x) << "where a bar would begin";

    chart.groups[0].bars[0].mark = 11.0; // where the label would be
    Recorder crossed;
    Paint(crossed, chart);
    const auto scaled =
        std::find_if(crossed.lines.begin(), crossed.lines.end(), [&](const auto& l) {
            return l.size() == 2 && l[1].second - l[0].second < 20.0 && l[0].first > bars[0].x &&
                   l[0].second > 80.0;
        });
    ASSERT_NE(scaled, crossed.lines.end());
    EXPECT_GT(crossed.Find("10x").x, scaled->front().first);
}

TEST(Chart, LinesGoThroughTheirPointsAndSayWhatTheyAre)
{
    LineChart chart;
    chart.frame.title = "Error";
    chart.x = {"time", true};
    chart.y = {"error", true};
    chart.lines = {{{"ours", 0}, {{1.0, 100.0, ""}, {10.0, 10.0, ""}, {100.0, 1.0, "last"}}},
                   {{"theirs", 1, ChartStroke::Dashed}, {{1.0, 1.0, ""}, {100.0, 1.05, "other"}}}};
    Recorder canvas;
    Paint(canvas, chart);
    ASSERT_EQ(canvas.discs.size(), 2u + 5u) << "two in the legend";
    const auto& first = canvas.discs[4]; // what comes first is in front
    const auto& second = canvas.discs[5];
    const auto& third = canvas.discs[6];
    EXPECT_NEAR(second.first - first.first, third.first - second.first, 1e-6);
    EXPECT_NEAR(second.second - first.second, third.second - second.second, 1e-6);
    EXPECT_GT(second.second, first.second) << "less is lower";
    EXPECT_TRUE(canvas.anyDashed);
    EXPECT_GE(std::abs(canvas.Find("last").y - canvas.Find("other").y), 12.0)
        << "labels at one place are moved apart";
    EXPECT_LE(canvas.Find("last").x + canvas.TextWidth("other", {.size = 11.0}), 1000.0);
}

/// A curve of three points whose last two are too small for the axis, and one beside it.
LineChart WithSmallErrors()
{
    LineChart chart;
    chart.x = chart.y = {"", true};
    chart.floor = 0.01;
    chart.floorText = "0.01 or less";
    chart.lines = {{{"ours", 0}, {{1.0, 1.0, ""}, {10.0, 0.01, ""}, {100.0, 0.0, ""}}},
                   {{"theirs", 1}, {{1.0, 0.5, ""}, {100.0, 0.001, ""}}}};
    return chart;
}

TEST(Chart, PutsWhatIsTooSmallForTheAxisBelowItInARowForEachColour)
{
    Recorder canvas;
    Paint(canvas, WithSmallErrors());
    ASSERT_EQ(canvas.discs.size(), 2u + 5u);
    // What is painted last is in front: ours.
    const auto ours = canvas.discs.end() - 3;
    const auto theirs = canvas.discs.end() - 5;
    EXPECT_EQ(ours[1].second, ours[2].second) << "0.01 and nothing are both at the floor";
    EXPECT_GT(theirs[1].second, ours[2].second + 15.0);
    EXPECT_LT(canvas.Find("0.01").y, ours[1].second) << "the axis ends above";
    EXPECT_GT(canvas.Find("0.01 or less").y, canvas.Find("0.01").y);
}

TEST(Chart, DrawsRulesAcrossAndUprightAndNamesThemInside)
{
    LineChart chart = WithSmallErrors();
    chart.rules = {{0.1, false, "goal"}, {10.0, true, "budget"}};
    Recorder canvas;
    Paint(canvas, chart);
    int across = 0, upright = 0;
    for (const auto& line : canvas.lines)
    {
        const bool isLong = line.size() == 2 && std::hypot(line[1].first - line[0].first,
                                                           line[1].second - line[0].second) > 300;
        across += isLong && line[0].second == line[1].second &&
                  std::abs(line[0].second - canvas.Find("0.1").y + 4.0) < 1e-6;
        upright += isLong && line[0].first == line[1].first &&
                   std::abs(line[0].first - canvas.Find("10").x) < 1e-6;
    }
    EXPECT_EQ(across, 2) << "the grid's and the goal's";
    EXPECT_EQ(upright, 2);
    EXPECT_NEAR(canvas.Find("goal").y, canvas.Find("0.1").y, 20.0);
    EXPECT_NEAR(canvas.Find("budget").x, canvas.Find("10").x, 60.0);
}

TEST(Chart, ShowsWhatIsBeyondAllNumbersAtTheUpperEdge)
{
    LineChart chart = WithSmallErrors();
    chart.lines[1].points[0].y = kNoValue;
    Recorder canvas;
    Paint(canvas, chart);
    const auto theirs = canvas.discs.end() - 5;
    const auto ours = canvas.discs.end() - 3;
    EXPECT_LT(theirs[0].second, ours[0].second);
}

TEST(ChartScale, WritesLongPowersOfTenAsPowers)
{
    EXPECT_EQ(ChartPower(1e-7), "10\u207b\u2077");
    EXPECT_EQ(ChartPower(1e12), "10\u00b9\u00b2");
    EXPECT_EQ(ChartPower(0.001), "0.001");
    EXPECT_EQ(ChartPower(2e-7), "2e-07");
}

TEST(ChartLabels, KeepOffWordsMarksAndLinesWhereThereIsRoom)
{
    LabelLayout layout({0.0, 0.0, 400.0, 400.0});
    layout.AvoidLine(200.0, 200.0, 400.0, 200.0); // to the right
    const auto first = layout.PlaceBeside(200.0, 200.0, 40.0, 12.0, false);
    const auto second = layout.PlaceBeside(200.0, 200.0, 40.0, 12.0, false);
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(first->bottom <= 200.0 || first->top >= 200.0 || first->right <= 200.0);
    EXPECT_TRUE(first->right <= second->left || second->right <= first->left ||
                first->bottom <= second->top || second->bottom <= first->top);
}

TEST(ChartLabels, AreLeftOutOrPutFartherAwayWhereThereIsNoRoom)
{
    LabelLayout layout({0.0, 0.0, 400.0, 400.0});
    layout.AvoidMark(200.0, 200.0, 25.0, 1.0);
    EXPECT_FALSE(layout.PlaceBeside(200.0, 200.0, 20.0, 12.0, true));
    const auto far = layout.PlaceBeside(200.0, 200.0, 20.0, 12.0, false);
    ASSERT_TRUE(far);
    EXPECT_TRUE(far->left >= 225.0 || far->right <= 175.0 || far->top >= 225.0 ||
                far->bottom <= 175.0);
    LabelLayout corner({0.0, 0.0, 400.0, 400.0});
    const auto inside = corner.PlaceBeside(398.0, 2.0, 40.0, 12.0, false);
    ASSERT_TRUE(inside);
    EXPECT_LE(inside->right, 400.0);
    EXPECT_GE(inside->top, 0.0);
}

bool IsCairoLoaded()
{
    return ReadFile("/proc/self/maps").find("libcairo") != std::string::npos;
}

TEST(Chart, LoadsTheLibraryThatDrawsOnlyWhenADrawingIsAskedFor)
{
    if (IsCairoLoaded())
    {
        GTEST_SKIP() << "by an earlier test of this process; CTest gives each its own";
    }
    Recorder canvas;
    Paint(canvas, TwoBars());
    EXPECT_FALSE(IsCairoLoaded());
    EXPECT_TRUE(PrepareCharts());
    EXPECT_TRUE(IsCairoLoaded());
}

TEST(Chart, BecomesAPngOfTwoPixelsAPoint)
{
    const BarChart chart = TwoBars();
    const Result<std::vector<std::uint8_t>> bytes = EncodeChart(chart, ChartFormat::Png);
    ASSERT_TRUE(bytes) << bytes.GetError().message;
    const TemporaryFolder folder;
    ASSERT_TRUE(WriteWhole(folder / "chart.png", *bytes, false));
    const Result<Frame> frame = ReadPng(folder / "chart.png");
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->width, 2000);
    ASSERT_EQ(frame->height, 2 * int(std::ceil(HeightOf(chart))));

    // The first bar has its colour where the layout says, and paper is white.
    Recorder canvas;
    Paint(canvas, chart);
    const Recorder::Box bar = Bars(canvas).front();
    const auto pixel = [&](double x, double y) {
        return &frame->rgba[4 * (std::size_t(2.0 * y) * 2000 + std::size_t(2.0 * x))];
    };
    const std::uint8_t* inside = pixel(bar.x + 5.0, bar.y + 5.0);
    EXPECT_NEAR(inside[0], 255 * bar.color.red, 1.0);
    EXPECT_NEAR(inside[1], 255 * bar.color.green, 1.0);
    EXPECT_NEAR(inside[2], 255 * bar.color.blue, 1.0);
    EXPECT_EQ(pixel(3.0, 3.0)[0], 255);
    EXPECT_EQ(*bytes, *EncodeChart(chart, ChartFormat::Png)) << "same chart, same bytes";
}

TEST(Chart, BecomesAnSvgWithoutFonts)
{
    const Result<std::vector<std::uint8_t>> bytes = EncodeChart(TwoBars(), ChartFormat::Svg);
    ASSERT_TRUE(bytes) << bytes.GetError().message;
    const std::string text(bytes->begin(), bytes->end());
    EXPECT_THAT(text, testing::StartsWith("<?xml"));
    EXPECT_THAT(text, HasSubstr("</svg>"));
    EXPECT_THAT(text, HasSubstr("width=\"1000"));
    EXPECT_THAT(text, HasSubstr("<use ")) << "letters are outlines, drawn by reference";
    EXPECT_THAT(text, Not(HasSubstr("<text")));
    EXPECT_THAT(text, Not(HasSubstr("font-family")));
}

} // namespace
} // namespace boxreel
