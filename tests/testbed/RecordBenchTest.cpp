// SPDX-License-Identifier: MIT
// What `boxreel bench --record` makes of the figures of made-up films.
#include <bench/RecordBench.h>

#include <gmock/gmock.h>

#include <cmath>

namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

RecordFigures Film(RecordRole role, const char* method, std::int64_t frames, double wall)
{
    RecordFigures figures;
    figures.role = role;
    figures.method = method;
    figures.frames = frames;
    figures.wall = wall;
    figures.cpu = 1.5 * wall;
    figures.memory = 200e6;
    figures.bytes = 1e6;
    figures.verdict = "sound";
    return figures;
}

RecordCase CaseNamed(const std::string& name)
{
    for (const RecordCase& info : AllRecordCases())
    {
        if (info.name == name)
        {
            return info;
        }
    }
    ADD_FAILURE() << "no case is called " << name;
    return {};
}

/// Meets every goal.
RecordResult Pyramid()
{
    RecordResult result;
    result.info = CaseNamed("pyramid");
    result.cached = 1.0;
    result.methods = {Film(RecordRole::Ours, "boxreel record", 600, 4.0),
                      Film(RecordRole::Start, "  its first frame", 1, 0.3),
                      Film(RecordRole::Encoding, "ffmpeg 5", 600, 5.0),
                      Film(RecordRole::Immediate, "immediate mode", 600, 10.0)};
    result.stages = {{"simulating", "main", 0.001, 0.0011},
                     {"waiting for a frame", "encoder", 0.0, 0.002},
                     {"encoding", "codec", 0.004, kNoValue}};
    return result;
}

/// The film of one role.
RecordFigures& Of(RecordResult& result, RecordRole role)
{
    for (RecordFigures& figures : result.methods)
    {
        if (figures.role == role)
        {
            return figures;
        }
    }
    ADD_FAILURE() << "there is no such film";
    return result.methods.front();
}

std::vector<std::string> Missed(const RecordResult& result)
{
    std::vector<std::string> missed;
    for (const RecordGoal& goal : RecordGoals(result))
    {
        if (!goal.IsMet())
        {
            missed.push_back(goal.what);
        }
    }
    return missed;
}

TEST(RecordBench, HoldsOursAgainstEncodingOnlyAndAgainstImmediateMode)
{
    RecordResult result = Pyramid();
    EXPECT_EQ(RecordGoals(result).size(), 3u);
    EXPECT_THAT(Missed(result), IsEmpty());
    Of(result, RecordRole::Ours).wall = 5.01;
    EXPECT_THAT(Missed(result),
                ElementsAre("wall time over encoding only", "wall time over immediate mode"));
    Of(result, RecordRole::Immediate).wall = 10.1;
    EXPECT_THAT(Missed(result), ElementsAre("wall time over encoding only"));
    Of(result, RecordRole::Ours) = Film(RecordRole::Ours, "boxreel record", 600, 4.0);
    Of(result, RecordRole::Ours).memory = 331e6;
    EXPECT_THAT(Missed(result), ElementsAre("memory over the encoder's"));
    result.info = Resized(result.info, {.frames = 10});
    EXPECT_THAT(RecordGoals(result), IsEmpty()) << "goals are for films of 600 frames";
}

TEST(RecordBench, LetsNoBrokenFilmWin)
{
    RecordResult result = Pyramid();
    Of(result, RecordRole::Ours).verdict = "599 frames";
    EXPECT_EQ(Missed(result).size(), 3u);
    EXPECT_THAT(RecordTable({result}), HasSubstr("599 frames\n"));
    EXPECT_THAT(RecordTable({result}), HasSubstr("goal MISSED: wall time over encoding only"));
    EXPECT_FALSE(RecordSpeedChart({result})->groups[0].bars[0].value > 0.0);
}

TEST(RecordBench, HoldsAFrameAtRestAgainstAMovingOneWithoutStartAndEnd)
{
    RecordResult result = Pyramid();
    result.info = CaseNamed("asleep");
    Of(result, RecordRole::Ours).wall = 0.3 + 599 * 0.0005;
    result.methods.push_back(Film(RecordRole::Moving, "moves", 120, 0.2 + 119 * 0.0051));
    result.methods.push_back(Film(RecordRole::MovingStart, "first", 1, 0.2));
    EXPECT_THAT(Missed(result), IsEmpty());
    Of(result, RecordRole::Moving).wall = 0.2 + 119 * 0.0049;
    EXPECT_THAT(Missed(result), ElementsAre("times faster than moving"));
    EXPECT_THAT(RecordTable({result}), HasSubstr("0.599!")) << "marked at our time";
}

TEST(RecordBench, HoldsPicturesAgainstARate)
{
    RecordResult result;
    result.info = CaseNamed("pictures");
    result.methods = {Film(RecordRole::Ours, "boxreel record", 300, 2.9)};
    EXPECT_THAT(Missed(result), IsEmpty());
    result.methods[0].wall = 3.1;
    EXPECT_THAT(Missed(result), ElementsAre("frames a second"));
    EXPECT_THAT(RecordTable({result}), HasSubstr(" 96.8!"));
}

TEST(RecordBench, HoldsTheMemoryOfALongFilmAgainstThatOfAShortOne)
{
    RecordResult result = Pyramid();
    result.info = CaseNamed("memory");
    result.methods.push_back(Film(RecordRole::Long, "longer", 6000, 40.0));
    EXPECT_THAT(Missed(result), IsEmpty());
    Of(result, RecordRole::Long).memory = 211e6;
    EXPECT_THAT(Missed(result), ElementsAre("memory of the longer film"));
    EXPECT_THAT(RecordTable({result}), HasSubstr(" 211! "));
}

TEST(RecordBench, JudgesAFilmByItsFramesItsSizeAndItsColours)
{
    const RecordCase info = CaseNamed("pyramid");
    RecordFigures figures = Film(RecordRole::Ours, "boxreel record", 600, 4.0);
    const FilmCheck good{600, 1280, 720, 2.0, 0.5};
    EXPECT_EQ(JudgeFilm(info, figures, good), "sound");
    FilmCheck check = good;
    check.frames = 599;
    EXPECT_EQ(JudgeFilm(info, figures, check), "599 frames");
    check = good;
    check.height = 360;
    EXPECT_EQ(JudgeFilm(info, figures, check), "1280x360");
    check = good;
    check.groundError = 17.25;
    EXPECT_EQ(JudgeFilm(info, figures, check), "colours off by 17.2 of 255");
    check = good;
    check.drawnError = 25.0;
    EXPECT_EQ(JudgeFilm(info, figures, check), "colours off by 25.0 of 255");
    check.drawnError = 6.0;
    EXPECT_EQ(JudgeFilm(info, figures, check), "colours off by 6.0 of 255");
    figures.role = RecordRole::Immediate;
    EXPECT_EQ(JudgeFilm(info, figures, check), "sound") << "its lines are jagged";
    check.drawnError = std::nan("");
    EXPECT_NE(JudgeFilm(info, figures, check), "sound");
}

TEST(RecordBench, GivesBothTheSameEncoderWithTheSameSettings)
{
    const RecordCase info = CaseNamed("pyramid");
    EXPECT_THAT(OursWords(info, 600, 0.0, "a.mp4"),
                AllOf(Contains("preset=veryfast"), Contains("crf=20"), Contains("mbtree=0"),
                      Contains("1280x720")));
    const std::vector<std::string> words = EncoderWords(info, "a.raw", false, "a.mp4");
    std::string line;
    for (const std::string& word : words)
    {
        line += word + " ";
    }
    EXPECT_THAT(line, AllOf(HasSubstr("-preset veryfast -crf 20 -mbtree 0 "),
                            HasSubstr("-threads 2 "), HasSubstr("-video_size 1280x720 "),
                            HasSubstr("-i a.raw "), HasSubstr("out_color_matrix=bt709")));
    EXPECT_THAT(EncoderWords(info, "pipe:0", true, "a.mp4"), Contains(HasSubstr("vflip,")));
    EXPECT_THAT(EncoderWords(CaseNamed("pictures"), "a.raw", false, "%04d.png"),
                AllOf(Contains("-compression_level"), Not(Contains("libx264"))));
}

TEST(RecordBench, ReadsStagesAmongOtherLines)
{
    const auto stages = ParseStages(
        "Mesa says hello\n{\"event\":\"done\",\"frames\":600}\n"
        R"({"event":"stages","frames":10,"stages":[{"stage":"a","thread":"main","cpuSeconds":0.5,)"
        R"("wallSeconds":1},{"stage":"b","thread":"codec","cpuSeconds":2}]})"
        "\n");
    ASSERT_TRUE(stages);
    ASSERT_EQ(stages->size(), 2u);
    EXPECT_DOUBLE_EQ((*stages)[0].cpu, 0.05) << "of one of ten frames";
    EXPECT_DOUBLE_EQ((*stages)[0].wall, 0.1);
    EXPECT_EQ((*stages)[1].thread, "codec");
    EXPECT_TRUE(std::isnan((*stages)[1].wall));
    for (const char* other : {"", "{}", R"({"event":"stages","frames":0,"stages":[]})",
                              R"({"event":"stages","frames":1,"stages":[1]})"})
    {
        EXPECT_FALSE(ParseStages(other)) << other;
    }
}

TEST(RecordBench, ReadsWhatAFilmShows)
{
    const auto check = ParseFilmCheck(
        R"({"frames":600,"width":1280,"height":720,"drawnError":1.5,"groundError":0.25})");
    ASSERT_TRUE(check);
    EXPECT_EQ(check->frames, 600);
    EXPECT_EQ(check->height, 720);
    EXPECT_EQ(check->drawnError, 1.5);
    EXPECT_EQ(check->groundError, 0.25);
    for (const char* other : {"", "{}", "[]", R"({"frames":1,"width":0,"height":1})"})
    {
        EXPECT_FALSE(ParseFilmCheck(other)) << other;
    }
}

TEST(RecordBench, MarksInTheTableWhatMissesItsGoal)
{
    RecordResult result = Pyramid();
    const std::string good = RecordTable({result});
    EXPECT_THAT(good.substr(0, good.find("Each film")), Not(HasSubstr("!")));
    EXPECT_THAT(good, HasSubstr("goal met:    wall time over encoding only  0.8, at most 1\n"));
    EXPECT_THAT(good, HasSubstr("100 % of the raw frames in the page cache"));
    Of(result, RecordRole::Ours).wall = 6.0;
    Of(result, RecordRole::Ours).memory = 400e6;
    EXPECT_THAT(RecordTable({result}), AllOf(HasSubstr(" 6.00! "), HasSubstr(" 400! ")));
}

TEST(RecordBench, SaysWhereTheTimeOfAFrameGoes)
{
    EXPECT_THAT(RecordTable({Pyramid()}),
                HasSubstr("simulating                main          1.000     1.100\n"
                          "waiting for a frame       encoder       0.000     2.000\n"
                          "encoding                  codec         4.000         -\n"
                          "all                                     5.000\n"));
}

TEST(RecordBench, SumsUpHowMuchMoreTheOthersTake)
{
    RecordResult alone = Pyramid();
    alone.info.name = "tumbler";
    alone.methods.resize(2);
    Of(alone, RecordRole::Ours).bytes = 3e6;
    EXPECT_THAT(RecordTable({Pyramid(), alone}),
                HasSubstr("pyramid             1.25      1.25      1.00        2.50      2.50"
                          "      1.00\n"
                          "tumbler                -         -         -           -         -"
                          "         -\n"));
}

TEST(RecordBench, TellsWhoFailed)
{
    RecordResult result = Pyramid();
    Of(result, RecordRole::Immediate).failure = "no library";
    EXPECT_THAT(RecordTable({result}), HasSubstr("  failed: no library\n"));
    EXPECT_EQ(RecordGoals(result).size(), 2u) << "there is nothing to hold it against";
}

TEST(RecordBench, ReadsWhatItWrote)
{
    RecordResult result = Pyramid();
    result.methods.push_back(Film(RecordRole::Long, "broken", 6000, 1.0));
    result.methods.back().failure = "failed";
    RecordResult other = Pyramid();
    other.info = Resized(CaseNamed("pictures"), {.frames = 2, .width = 64, .height = 36});
    other.cached = kNoValue;
    const std::string text = RecordJson({result, other});
    const auto again = ParseRecordJson(text, "a.json");
    ASSERT_TRUE(again);
    EXPECT_EQ(RecordJson(*again), text);
    EXPECT_EQ(RecordTable(*again), RecordTable({result, other}));
}

TEST(RecordBench, RefusesWhatItDidNotWrite)
{
    const std::string film =
        R"({"role":"boxreel","method":"a","frames":1,"wallSeconds":1,"cpuSeconds":1,)"
        R"("filmBytes":1,"verdict":"sound"})";
    const auto withCase = [](const std::string& fields) {
        return R"({"cases":[{"case":"a","frames":1,"width":2,"height":2,)" + fields + "}]}";
    };
    EXPECT_TRUE(ParseRecordJson(withCase("\"methods\":[" + film + "]"), "a.json"));
    for (const std::string& no :
         {std::string(), std::string("{}"), std::string("[]"), std::string(R"({"cases":[]})"),
          std::string(R"({"cases":[1]})"), withCase("\"methods\":[]"),
          withCase(R"("methods":[{"role":"nobody","method":"a","frames":1,"failure":"x"}])"),
          withCase(R"("methods":[{"role":"boxreel","method":"a","frames":1}])"),
          withCase("\"methods\":[" + film + "],\"stages\":[{}]"),
          R"({"cases":[{"case":"a","methods":[)" + film + "]}]}"})
    {
        EXPECT_FALSE(ParseRecordJson(no, "a.json")) << no;
    }
}

TEST(RecordBench, ChartsHowManyTimesFasterOursIs)
{
    const auto chart = RecordSpeedChart({Pyramid()});
    ASSERT_TRUE(chart);
    ASSERT_EQ(chart->series.size(), 2u);
    ASSERT_EQ(chart->groups.size(), 1u);
    const std::vector<ChartBar>& bars = chart->groups[0].bars;
    EXPECT_DOUBLE_EQ(bars[0].value, 1.25);
    EXPECT_DOUBLE_EQ(bars[1].value, 2.5);
    EXPECT_DOUBLE_EQ(bars[0].mark, 1.0);
    EXPECT_DOUBLE_EQ(bars[1].mark, 2.0);
    EXPECT_EQ(chart->groups[0].value, "4.00 s");
    RecordResult alone = Pyramid();
    alone.methods.resize(2);
    EXPECT_FALSE(RecordSpeedChart({alone}));
    const auto both = RecordSpeedChart({alone, Pyramid()});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->groups[0].bars[0].label, "not made");
}

TEST(RecordBench, ChartsTheStagesThatTakeTime)
{
    const auto chart = RecordStageChart({Pyramid(), Pyramid()});
    ASSERT_TRUE(chart);
    EXPECT_EQ(chart->series.size(), 2u);
    ASSERT_EQ(chart->groups.size(), 2u) << "waiting takes none";
    EXPECT_EQ(chart->groups[0].name, "simulating");
    EXPECT_DOUBLE_EQ(chart->groups[1].bars[1].value, 4.0) << "[ms]";
    RecordResult without = Pyramid();
    without.stages.clear();
    EXPECT_FALSE(RecordStageChart({without}));
    EXPECT_FALSE(RecordStageChart({}));
}

} // namespace
} // namespace boxreel
