// SPDX-License-Identifier: MIT
#include "BenchSupport.h"

#include <bench/BenchChart.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;
using testing::Not;

constexpr const char* kLine =
    R"({"engine":"boxreel 1.0","scene":"rain","threads":2,"calls":600,"mean":0.004,"median":0.0039,)"
    R"("p99":0.006,"worst":0.007,"cpu":0.0041,"contacts":13624,"memory":5000,"finite":true,)"
    R"("escaped":0,"awake":0,"overlap":0.018,"meanHeight":12.6,"highest":30,"meanSpeed":0.1,)"
    R"("bodies":5001,"found":7,"foundSum":2.5,"bits":"0f"})";

TEST(Benchmark, ReadsWhatAProgramSaysOfItsScenes)
{
    const BenchScene scene =
        ParseBenchScene("static-20\tin a few words\tfaster=7.5 speed-up=1.6 memory=15360 "
                        "only-curve=static count=20 found=hits like=speeds");
    EXPECT_EQ(scene.name, "static-20");
    EXPECT_EQ(scene.what, "in a few words");
    EXPECT_EQ(scene.goalTimesFaster, 7.5);
    EXPECT_EQ(scene.goalSeconds, 0.0);
    EXPECT_EQ(scene.goalSpeedUp, 1.6);
    EXPECT_EQ(scene.goalMemory, 15360.0);
    EXPECT_EQ(scene.curve, "static");
    EXPECT_EQ(scene.count, 20.0);
    EXPECT_TRUE(scene.onlyForCurve);
    EXPECT_EQ(scene.found, "hits");
    EXPECT_TRUE(scene.comparesSpeeds);
    const BenchScene plain = ParseBenchScene("empty\tan empty world\tseconds=1e-07 like=heights");
    EXPECT_EQ(plain.goalSeconds, 1e-7);
    EXPECT_FALSE(plain.onlyForCurve || plain.comparesSpeeds);
    EXPECT_EQ(ParseBenchScene("alone").name, "alone");
}

TEST(Benchmark, ReadsTheLastLineOfWhatAProgramPrints)
{
    const Result<BenchFigures> figures = ParseFigures(std::string("Initializing\n") + kLine + "\n");
    ASSERT_TRUE(figures);
    EXPECT_EQ(figures->engine, "boxreel 1.0");
    EXPECT_EQ(figures->threads, 2);
    EXPECT_EQ(figures->cpu, 0.0041);
    EXPECT_EQ(figures->contacts, 13624.0);
    EXPECT_EQ(figures->overlap, 0.018);
    EXPECT_EQ(figures->meanHeight, 12.6);
    EXPECT_EQ(figures->meanSpeed, 0.1);
    EXPECT_EQ(figures->bodies, 5001.0);
    EXPECT_EQ(figures->found, 7.0);
    EXPECT_EQ(figures->foundSum, 2.5);
    EXPECT_EQ(figures->bits, "0f");
    EXPECT_TRUE(figures->finite);
}

TEST(Benchmark, RefusesWhatIsNoLineOfFigures)
{
    for (const char* text : {"", "\n", "{}", "[1,2]", "nonsense", R"({"engine":"x","mean":1})"})
    {
        EXPECT_FALSE(ParseFigures(text)) << text;
    }
}

TEST(Benchmark, TakesTheMedianOfEachFigure)
{
    const auto with = [](double cpu, double contacts) {
        return Figures("boxreel 1.0", cpu, contacts, 1.0);
    };
    const BenchFigures median = MedianOf({with(3.0, 10.0), with(1.0, 30.0), with(2.0, 20.0)});
    EXPECT_EQ(median.cpu, 2.0);
    EXPECT_EQ(median.contacts, 20.0);
    EXPECT_EQ(median.bits, "00");
    EXPECT_EQ(MedianOf({with(1.0, 0.0), with(2.0, 0.0)}).cpu, 1.5);
}

TEST(Benchmark, CallsARunSoundThatEndsLikeThoseOfThePeers)
{
    BenchResult result = Rain();
    std::vector<BenchFigures>& engines = result.engines;
    EXPECT_EQ(engines[0].verdict, "sound");
    engines[0].contacts = 60;
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "other contacts");
    engines[0].contacts = 100;
    engines[0].meanHeight = -8;
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "other heights");
    engines[1].escaped = 3;
    engines[2].finite = false;
    Judge(result);
    EXPECT_EQ(engines[1].verdict, "3 escaped");
    EXPECT_EQ(engines[2].verdict, "not finite");
    EXPECT_EQ(engines[0].verdict, "sound") << "nobody sound to be compared with";
    engines[0].awake = 7;
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "7 awake");
}

/// What an engine must not get away with that does nothing when it is asked to step, to cast a ray
/// or to make a body: the figures that it would print, beside those of two that work.
TEST(Benchmark, FindsAnEngineThatDoesNothing)
{
    struct Case
    {
        const char* scene;
        const char* found;
        BenchFigures works, idle;
        const char* verdict;
    };
    const auto figures = [](double contacts, double height, double bodies, double found,
                            double sum) {
        BenchFigures of = Figures("", 1.0, contacts, height);
        of.bodies = bodies;
        of.found = found;
        of.foundSum = sum;
        return of;
    };
    const Case cases[] = {
        {"one-box", "", figures(1, 0.515, 2, 0, 0), figures(0, 0.515, 2, 0, 0), "other contacts"},
        {"one-box", "", figures(1, 0.515, 2, 0, 0), figures(1, 0.55, 2, 0, 0), "other heights"},
        {"ray-casts", "hits", figures(0, 0, 20000, 9e4, 2e4), figures(0, 0, 20000, 0, 0),
         "other hits"},
        {"ray-casts", "hits", figures(0, 0, 20000, 9e4, 2e4), figures(0, 0, 20000, 9e4, 1e4),
         "other hits"},
        {"ray-casts", "hits", figures(0, 0, 20000, 9e4, 2e4), figures(0, 0, 0, 9e4, 2e4),
         "other bodies"},
        {"create-destroy", "bodies", figures(1, 0.515, 2, 1e5, 33.3), figures(1, 0.515, 2, 1e5, 0),
         "other bodies"},
        {"create-destroy", "bodies", figures(1, 0.515, 2, 1e5, 33.3), figures(1, 0.515, 2, 0, 33.3),
         "other bodies"},
        {"create-destroy", "bodies", figures(1, 0.515, 2, 1e5, 33.3),
         figures(1, 0.515, 100002, 1e5, 33.3), "other bodies"},
        {"empty", "bodies", figures(0, 0, 0, 1, 0.167), figures(0, 0, 0, 1, 0), "other bodies"},
    };
    for (const Case& test : cases)
    {
        BenchResult result{SceneNamed(test.scene), {test.works, test.works, test.works}};
        result.scene.found = test.found;
        result.engines[0].isOurs = true;
        result.engines[1].engine = "Box2D 2.4.1";
        result.engines[2].engine = "Chipmunk 7";
        Judge(result);
        EXPECT_EQ(result.engines[0].verdict, "sound") << test.scene;
        result.engines[0] = test.idle;
        result.engines[0].isOurs = true;
        Judge(result);
        EXPECT_EQ(result.engines[0].verdict, test.verdict) << test.scene;
    }
}

TEST(Benchmark, LetsBulletsTouchAFewMoreOrFewer)
{
    BenchResult result = Rain();
    result.scene.comparesSpeeds = true;
    result.engines[0].contacts = 4;
    result.engines[1].contacts = result.engines[2].contacts = 9;
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "sound");
    result.scene.comparesSpeeds = false;
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "other contacts");
}

TEST(Benchmark, ShowsWhatCallsFound)
{
    BenchResult result = Rain();
    result.scene.found = "hits";
    result.engines[1].found = 90210;
    result.engines[1].foundSum = 12345.6;
    EXPECT_THAT(BenchTable({result}), HasSubstr("found 90210 hits, in sum 12345.6\n"));
    EXPECT_THAT(BenchTable({Rain()}), Not(HasSubstr("found")));
}

TEST(Benchmark, WantsOverlapsNoDeeperThanThoseOfBox2D)
{
    BenchResult result = Rain();
    std::vector<BenchFigures>& engines = result.engines;
    engines[0].overlap = 0.024;
    engines[1].overlap = 0.020;
    engines[2].overlap = 0.001; // leaves another slop
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "sound");
    engines[0].overlap = 0.026;
    engines[2].overlap = 0.050;
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "deep overlaps");
    result.scene.comparesSpeeds = true; // little touches there
    Judge(result);
    EXPECT_EQ(engines[0].verdict, "sound");
}

TEST(Benchmark, ComparesSpeedsWhereNothingComesToRest)
{
    BenchResult result = Rain();
    result.scene.comparesSpeeds = true;
    result.engines[0].meanHeight = -8; // of no interest there
    result.engines[0].meanSpeed = 45;
    result.engines[1].meanSpeed = 46;
    result.engines[2].meanSpeed = 99;
    result.engines[2].escaped = 496; // and so not compared
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "sound");
    result.engines[0].meanSpeed = 60;
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "other speeds");
    result.engines[0].meanSpeed = 30;
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "other speeds");
}

TEST(Benchmark, WantsTheSameBitsEveryTimeAtEveryThreadCount)
{
    BenchResult result = Rain();
    result.engines.insert(result.engines.begin() + 1, result.engines.front());
    result.engines[1].threads = 2;
    Judge(result);
    EXPECT_EQ(result.engines[1].verdict, "sound");
    result.engines[1].bits = "01";
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "sound");
    EXPECT_EQ(result.engines[1].verdict, "other bits");

    std::vector<BenchFigures> rounds(3, Rain().engines.front());
    rounds[2].bits = "02";
    result = Rain();
    result.engines[0] = MedianOf(rounds);
    Judge(result);
    EXPECT_EQ(result.engines[0].verdict, "other bits");
}

TEST(Benchmark, ARunThatBurstIsNotCompared)
{
    const BenchFigures ours = Figures("boxreel 1.0", 1, 1, 1);
    BenchFigures peer = Figures("Chipmunk 7", 3, 1, 1);
    EXPECT_EQ(CpuRatio(ours, peer), 3.0);
    EXPECT_EQ(WallRatio(ours, peer), 3.0);
    peer.escaped = 1;
    EXPECT_EQ(CpuRatio(ours, peer), 0.0);
    EXPECT_EQ(WallRatio(peer, ours), 0.0) << "nor can a broken run of ours win";
}

TEST(Benchmark, ShowsTheRatioOfARunThatEndsOtherwiseInBracketsOnly)
{
    BenchResult result = Rain();
    result.engines[0].contacts = 1000;
    Judge(result);
    const std::string table = BenchTable({result});
    EXPECT_THAT(table, HasSubstr(" (5.00x) "));
    EXPECT_THAT(table, Not(HasSubstr(" 5.00x ")));
    EXPECT_THAT(table, HasSubstr("other contacts"));
    const std::string json = BenchJson({result});
    EXPECT_THAT(json, HasSubstr("\"cpuRatioNotComparable\": 5.0"));
    EXPECT_THAT(json, Not(HasSubstr("\"cpuRatio\"")));
    EXPECT_THAT(json, Not(HasSubstr("\"wallRatio\"")));
}

TEST(Benchmark, ShowsTimesWithUnitsRatiosAndGoalsInATable)
{
    BenchResult result = Rain();
    result.engines[0].p99 = 0.009;
    BenchFigures failed;
    failed.engine = "other";
    failed.failure = "failed";
    result.engines.push_back(failed);
    Judge(result);
    const std::string table = BenchTable({result});
    for (const char* text :
         {"4.00 ms", "5.00x", "8.00x", "2.25!", "0.50x", "failed", "104", "sound"})
    {
        EXPECT_THAT(table, HasSubstr(text));
    }
    EXPECT_THAT(table, Not(HasSubstr("threads"))) << "only where there are several";
}

TEST(Benchmark, ShowsTheSpeedUpOfThreads)
{
    BenchResult result = Rain();
    result.engines.insert(result.engines.begin() + 1, result.engines.front());
    result.engines[1].threads = 2;
    result.engines[1].mean = 0.0025;
    Judge(result);
    const std::string table = BenchTable({result});
    EXPECT_THAT(table, HasSubstr("threads speed-up"));
    EXPECT_THAT(table, HasSubstr("      2    1.60x        "));
}

TEST(Benchmark, SaysHowACurveGrows)
{
    const std::string table =
        BenchTable({Point("static", 200, 1.0, 2.0), Point("static", 2000, 1.1, 30.0),
                    Point("static", 20000, 1.2, 300.0)});
    EXPECT_THAT(table, HasSubstr("static-20000 takes 1.20x the CPU time of static-200\n"));
    EXPECT_THAT(table, HasSubstr("static-20000 takes 150x the CPU time of static-200\n"));
    EXPECT_THAT(BenchTable({Point("static", 200, 1.0, 2.0)}), Not(HasSubstr("takes")));

    std::vector<BenchResult> threads{Point("static", 200, 1.0, 2.0), Point("static", 400, 1, 2)};
    for (BenchResult& result : threads)
    {
        result.engines.insert(result.engines.begin() + 1, result.engines.front());
        result.engines[1].engine = "again";
    }
    EXPECT_THAT(BenchTable(threads), Not(HasSubstr("again            static-400 takes")))
        << "one thread count is enough";
}

TEST(Benchmark, ReadsItsOwnJsonBack)
{
    BenchResult rain = Rain();
    BenchFigures failed;
    failed.engine = "other";
    failed.failure = "failed";
    rain.engines.push_back(failed);
    rain.engines[1].threads = 2;
    rain.engines[1].meanSpeed = 3.0;
    rain.engines[1].overlap = 0.02;
    rain.scene.found = "hits";
    rain.engines[1].bodies = 3.0;
    rain.engines[1].found = 8.0;
    rain.engines[1].foundSum = 4.5;
    rain.engines[1].escaped = 5.0;
    rain.engines[2].awake = 4.0;
    rain.engines[2].memory = 1000.0;
    rain.scene.comparesSpeeds = true;
    rain.scene.goalSeconds = 1e-6;
    rain.scene.goalSpeedUp = 1.6;
    rain.scene.goalMemory = 15360.0;
    Judge(rain);
    const std::vector<BenchResult> results{rain, Point("asleep", 200, 1.0, 2.0)};
    const std::string json = BenchJson(results);
    EXPECT_THAT(json, HasSubstr("\"cpuRatio\": 2.0"));
    const Result<std::vector<BenchResult>> read = ParseBenchJson(json, "a.json");
    ASSERT_TRUE(read) << read.GetError().message;
    EXPECT_EQ(BenchJson(*read), json);
    EXPECT_EQ(BenchTable(*read), BenchTable(results));
}

TEST(Benchmark, RefusesOtherJson)
{
    for (const char* text : {"", "{}", "[]", R"({"scenes":[]})", R"({"scenes":[{"scene":"a"}]})",
                             R"({"scenes":[3]})", R"({"scenes":[{"scene":"a","engines":[1]}]})"})
    {
        const Result<std::vector<BenchResult>> read = ParseBenchJson(text, "a.json");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.GetError().kind, ErrorKind::Unusable);
        EXPECT_THAT(read.GetError().message, HasSubstr("a.json"));
    }
}

TEST(BenchChart, ShowsRatiosGoalsAndWhatIsNotCompared)
{
    BenchResult burst = Rain();
    burst.scene = SceneNamed("one-box");
    burst.scene.goalSeconds = 0.01;
    burst.engines[2].escaped = 9;
    burst.engines[0].contacts = 1000;
    Judge(burst);
    const Result<BarChart> chart = RatioChart({Rain(), burst});
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->series.size(), 2u);
    EXPECT_EQ(chart->series[0].name, "than Box2D 2.4.1");
    EXPECT_EQ(chart->start, 1.0);
    const std::vector<ChartBar>& rain = chart->groups[0].bars;
    EXPECT_EQ(rain[0].value, 5.0);
    EXPECT_EQ(rain[0].mark, 8.0);
    EXPECT_EQ(rain[1].value, 0.5);
    EXPECT_EQ(rain[0].label, "5.00\u00d7, goal 8.00\u00d7");
    EXPECT_TRUE(std::isnan(rain[1].mark)) << "the goals are against Box2D";
    const std::vector<ChartBar>& box = chart->groups[1].bars;
    EXPECT_EQ(box[0].mark, 2.0) << "the peer's time over the goal's";
    EXPECT_TRUE(std::isnan(box[0].value));
    EXPECT_EQ(box[0].label, "not compared: boxreel other contacts (5.00\u00d7)");
    EXPECT_TRUE(std::isnan(box[1].value));
    EXPECT_EQ(box[1].label, "not compared: 9 escaped");
}

TEST(BenchChart, NeedsAPeer)
{
    BenchResult alone{SceneNamed("rain"), {Figures("boxreel 1.0", 1, 1, 1)}};
    const Result<BarChart> chart = RatioChart({alone});
    ASSERT_FALSE(chart);
    EXPECT_THAT(chart.GetError().message, HasSubstr("libbox2d-dev"));
}

TEST(BenchChart, ShowsALineAnEngineAndKindInTheOrderOfTheCounts)
{
    const Result<LineChart> chart =
        CurveChart({Point("static", 2000, 1e-6, 30e-6), Point("static", 200, 1e-6, 2e-6),
                    Point("asleep", 200, 1e-6, 2e-6), Rain()});
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->lines.size(), 4u);
    const ChartLine& peer = chart->lines[1];
    EXPECT_EQ(peer.series.name, "Box2D 2.4.1, static");
    ASSERT_EQ(peer.points.size(), 2u);
    EXPECT_EQ(peer.points[0].x, 200.0);
    EXPECT_NEAR(peer.points[1].y, 30.0, 1e-9) << "microseconds";
    EXPECT_THAT(peer.points[1].label, HasSubstr("15"));
    EXPECT_EQ(chart->lines[2].series.color, chart->lines[0].series.color) << "both are ours";
    EXPECT_EQ(chart->lines[2].series.stroke, ChartStroke::Dashed);
    EXPECT_FALSE(CurveChart({Rain()}));
    const Result<LineChart> small =
        CurveChart({Point("static", 200, 1e-6, 2e-6), Point("asleep4", 200, 1e-6, 2e-6),
                    Point("of later", 200, 1e-6, 2e-6)});
    ASSERT_TRUE(small);
    EXPECT_EQ(small->lines[2].series.name, "boxreel 1.0, asleep, 4 sub-steps");
    EXPECT_EQ(small->lines[2].series.stroke, ChartStroke::Dotted);
    EXPECT_EQ(small->lines[4].series.name, "boxreel 1.0, of later");
}

} // namespace
} // namespace boxreel
