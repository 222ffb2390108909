// SPDX-License-Identifier: MIT
#include <bench/Benchmark.h>

#include <gmock/gmock.h>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

constexpr const char* kLine =
    R"({"engine":"boxreel","scene":"rain","threads":1,"calls":600,"mean":0.004,"median":0.0039,)"
    R"("p99":0.006,"worst":0.007,"cpu":0.0041,"contacts":13624,"memory":5000,"finite":true,)"
    R"("escaped":0,"meanHeight":12.6,"highest":30,"meanSpeed":0.1,"asleep":false})";

BenchFigures Figures(double cpu, double contacts, double height)
{
    BenchFigures figures;
    figures.engine = "engine";
    figures.mean = figures.median = figures.p99 = figures.cpu = cpu;
    figures.contacts = contacts;
    figures.meanHeight = height;
    return figures;
}

TEST(Benchmark, ReadsTheLastLineOfWhatAProgramPrints)
{
    const Result<BenchFigures> figures = ParseFigures(std::string("Initializing\n") + kLine + "\n");
    ASSERT_TRUE(figures);
    EXPECT_EQ(figures->engine, "boxreel");
    EXPECT_EQ(figures->cpu, 0.0041);
    EXPECT_EQ(figures->contacts, 13624.0);
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
    const BenchFigures median =
        MedianOf({Figures(3.0, 10.0, 1.0), Figures(1.0, 30.0, 1.0), Figures(2.0, 20.0, 1.0)});
    EXPECT_EQ(median.cpu, 2.0);
    EXPECT_EQ(median.contacts, 20.0);
    EXPECT_EQ(MedianOf({Figures(1.0, 0.0, 0.0), Figures(2.0, 0.0, 0.0)}).cpu, 1.5);
}

TEST(Benchmark, CallsARunSoundThatEndsLikeThoseOfThePeers)
{
    std::vector<BenchFigures> engines{Figures(1, 100, 5), Figures(2, 104, 5.1), Figures(2, 97, 5)};
    Judge(engines);
    EXPECT_EQ(engines[0].verdict, "sound");
    engines[0].contacts = 60;
    Judge(engines);
    EXPECT_EQ(engines[0].verdict, "other contacts");
    engines[0].contacts = 100;
    engines[0].meanHeight = -8;
    Judge(engines);
    EXPECT_EQ(engines[0].verdict, "other heights");
    engines[1].escaped = 3;
    engines[2].finite = false;
    Judge(engines);
    EXPECT_EQ(engines[1].verdict, "3 escaped");
    EXPECT_EQ(engines[2].verdict, "not finite");
    EXPECT_EQ(engines[0].verdict, "sound") << "nobody sound to be compared with";
}

TEST(Benchmark, ShowsTimesWithUnitsAndRatiosInATable)
{
    BenchResult result{{"rain", "5000 circles"}, {Figures(0.004, 1, 1), Figures(0.02, 1, 1)}};
    BenchFigures failed;
    failed.engine = "other";
    failed.failure = "failed";
    result.engines.push_back(failed);
    Judge(result.engines);
    const std::string table = BenchTable({result});
    EXPECT_THAT(table, HasSubstr("4.00 ms"));
    EXPECT_THAT(table, HasSubstr("5.0x"));
    EXPECT_THAT(table, HasSubstr("failed"));
    EXPECT_THAT(BenchJson({result}), HasSubstr("\"ratio\": 5.0"));
}

} // namespace
} // namespace boxreel
