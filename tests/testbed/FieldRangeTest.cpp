// SPDX-License-Identifier: MIT
#include "BenchSupport.h"

#include <bench/AccuracySweep.h>
#include <bench/RecordBench.h>
#include <bench/RenderBench.h>

#include <gmock/gmock.h>

/// Files of figures may be anybody's: every reader refuses what could not be shown, in a sentence.
namespace boxreel
{
namespace
{

using testing::AllOf;
using testing::HasSubstr;

template <class Results>
std::string SentenceOf(const Result<Results>& read)
{
    if (!read)
    {
        EXPECT_EQ(read.GetError().kind, ErrorKind::Unusable);
    }
    return read ? "none" : read.GetError().message;
}

/// The text with the value of the first field of this name replaced.
std::string With(std::string text, const std::string& field, const std::string& value)
{
    const std::string name = "\"" + field + "\": ";
    const std::size_t at = text.find(name);
    EXPECT_NE(at, std::string::npos) << field;
    const std::size_t start = at + name.size();
    return text.replace(start, text.find_first_of(",\n", start) - start, value);
}

std::string SpeedText()
{
    BenchResult rain = Rain();
    rain.scene.goalSeconds = 1e-3;
    rain.scene.goalSpeedUp = 1.6;
    rain.scene.goalMemory = 1000.0;
    rain.scene.curve = "static";
    rain.scene.count = 200.0;
    return BenchJson({rain});
}

std::string ReadSpeed(const std::string& field, const std::string& value)
{
    return SentenceOf(ParseBenchJson(With(SpeedText(), field, value), "a.json"));
}

TEST(FieldRange, IsThatOfEveryNumberOfARun)
{
    for (const char* field :
         {"meanSeconds", "medianSeconds", "p99Seconds", "cpuSeconds", "contacts", "escaped",
          "awake", "bodies", "threads", "count", "goalTimesFaster", "goalSeconds",
          "goalSpeedUpOfTwoThreads", "goalMemoryKilobytes", "memoryKilobytes"})
    {
        EXPECT_EQ(ReadSpeed(field, "2"), "none") << field;
        EXPECT_EQ(ReadSpeed(field, "0"), "none") << field;
        for (const char* value : {"1e300", "-1e300", "1e308"})
        {
            EXPECT_THAT(ReadSpeed(field, value),
                        AllOf(HasSubstr("'a.json' has '" + std::string(field) + "' of "),
                              HasSubstr("make it again with `boxreel bench --json`.")))
                << field << " " << value;
        }
    }
    EXPECT_EQ(ReadSpeed("memoryKilobytes", "-4"), "none") << "a process may shrink";
    EXPECT_EQ(ReadSpeed("contacts", "null"), "none") << "of a world that burst";
    EXPECT_EQ(ReadSpeed("meanHeightMetres", "-1e30"), "none") << "the same";
    EXPECT_THAT(ReadSpeed("cpuSeconds", "-1"), HasSubstr("'cpuSeconds' of -1, which is no number"));
    EXPECT_THAT(ReadSpeed("cpuSeconds", "1e-300"), HasSubstr("cpuSeconds"));
}

TEST(FieldRange, IsAskedOfAccuracyRenderersAndFilmsToo)
{
    const std::string accuracy =
        R"({"cases":[{"case":"A","what":"","unit":"m","goal": 1,"goals":[],"runs":[{"engine":"x",)"
        R"("hz":60,"subSteps":1,"cpuSecondsOfAStep": 1,
"error": 1,
"held":true}]}]})";
    const std::string render =
        R"({"cases":[{"case":"a","shapes":1,"width":1,"height":1,"methods":[{"method":"x",)"
        R"("rms": 1,"frames":{"full":{"cpuSeconds": 1,
"wallSeconds": 1}}}]}]})";
    const std::string record =
        R"({"cases":[{"case":"a","frames": 1,"width":2,"height":2,"methods":[{"role":"boxreel",)"
        R"("method":"a","frames":1,"wallSeconds": 1,"cpuSeconds": 1,"filmBytes": 1,)"
        R"("verdict":"sound"}]}]})";
    const auto readAccuracy = [&](const char* field, const char* value) {
        return SentenceOf(ParseAccuracyJson(With(accuracy, field, value), "a.json"));
    };
    const auto readRender = [&](const char* field, const char* value) {
        return SentenceOf(ParseRenderJson(With(render, field, value), "a.json"));
    };
    const auto readRecord = [&](const char* field, const char* value) {
        return SentenceOf(ParseRecordJson(With(record, field, value), "a.json"));
    };
    EXPECT_EQ(readAccuracy("error", "0.5"), "none");
    EXPECT_EQ(readRender("rms", "0.5"), "none");
    EXPECT_EQ(readRecord("filmBytes", "5"), "none");
    EXPECT_THAT(readAccuracy("cpuSecondsOfAStep", "1e308"),
                HasSubstr("again with `boxreel bench --accuracy --json`."));
    EXPECT_THAT(readAccuracy("error", "1e308"), HasSubstr("'error'"));
    EXPECT_THAT(readRender("cpuSeconds", "1e308"),
                HasSubstr("again with `boxreel bench --render --json`."));
    EXPECT_THAT(readRender("rms", "1e308"), HasSubstr("'rms'"));
    EXPECT_THAT(readRecord("wallSeconds", "1e308"),
                HasSubstr("again with `boxreel bench --record --json`."));
    EXPECT_THAT(readRecord("frames", "1e300"), HasSubstr("'frames'"));
}

TEST(FieldRange, LeavesNoControlCharacterForTheTerminal)
{
    for (const char* value : {R"("\u001b[2J")", R"("a\nb")", R"("\u007f")", R"("\u009b2J")"})
    {
        for (const char* field : {"engine", "scene", "what", "curve", "bits"})
        {
            EXPECT_THAT(ReadSpeed(field, value), HasSubstr("control characters"))
                << field << " " << value;
        }
    }
    EXPECT_EQ(ReadSpeed("what", "\"f\u00fcnf \u2026 K\u00e4sten\""), "none");
    const char* named = R"({"cases":[{"case":"A","what":"","unit":"m","goal":1,"goals":[],)"
                        R"("runs":[{"engine":"x","hz":60,"subSteps":1,"cpuSecondsOfAStep":1,)"
                        R"("error":1,"held":true,"remarks":{"\u001b[2J":1}}]}]})";
    EXPECT_THAT(SentenceOf(ParseAccuracyJson(named, "a.json")), HasSubstr("control characters"));
}

TEST(FieldRange, IsNotLookedForWhereCopiesWouldRunOutOfStack)
{
    const std::string deep = std::string(200000, '[') + std::string(200000, ']');
    EXPECT_THAT(ReadSpeed("bits", deep), HasSubstr("'a.json' is nested too deep; make it again"));
    EXPECT_THAT(SentenceOf(ParseAccuracyJson(deep, "a.json")), HasSubstr("too deep"));
    EXPECT_THAT(SentenceOf(ParseRenderJson(deep, "a.json")), HasSubstr("too deep"));
    EXPECT_THAT(SentenceOf(ParseRecordJson(deep, "a.json")), HasSubstr("too deep"));
}

} // namespace
} // namespace boxreel
