// SPDX-License-Identifier: MIT
#include "FieldRange.h"
#include "RenderBench.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace boxreel
{
namespace
{

/// Fields by name: of times as programs print them and as files keep them, of goals, of a case.
struct ClockField
{
    const char* printed;
    const char* kept;
    double RenderTimes::*time;
};
constexpr ClockField kClocks[] = {{"cpu", "cpuSeconds", &RenderTimes::cpu},
                                  {"wall", "wallSeconds", &RenderTimes::wall},
                                  {"submit", "submitSeconds", &RenderTimes::submit},
                                  {"read", "readSeconds", &RenderTimes::read}};

constexpr std::pair<const char*, double RenderCase::*> kGoals[] = {
    {"goalFullSeconds", &RenderCase::goalFull},
    {"goalChangedSeconds", &RenderCase::goalChanged},
    {"goalUnchangedSeconds", &RenderCase::goalNone},
    {"goalEmptyOverFloor", &RenderCase::goalEmpty},
    {"goalRms", &RenderCase::goalRms}};

constexpr std::pair<const char*, int RenderCase::*> kSizes[] = {
    {"shapes", &RenderCase::count}, {"width", &RenderCase::width}, {"height", &RenderCase::height}};

constexpr FieldRange kRanges[] = {{"cpuSeconds", kSmallest, kLongest},
                                  {"wallSeconds", kSmallest, kLongest},
                                  {"submitSeconds", kSmallest, kLongest},
                                  {"readSeconds", kSmallest, kLongest},
                                  {"goalFullSeconds", kSmallest, kLongest},
                                  {"goalChangedSeconds", kSmallest, kLongest},
                                  {"goalUnchangedSeconds", kSmallest, kLongest},
                                  {"goalEmptyOverFloor", kSmallest, kLargest},
                                  {"goalRms", kSmallest, kLargest},
                                  {"rms", kSmallest, kLargest},
                                  {"most", kSmallest, kLargest},
                                  {"edgePixels", 1.0, kLargest},
                                  {"shapes", 1.0, kMostOf},
                                  {"width", 1.0, kMostOf},
                                  {"height", 1.0, kMostOf}};

constexpr const char* kDefinition =
    "rms: root mean square of the differences from 16 x 16 supersampling, over the red, green and "
    "blue of the pixels whose 256 samples are not all alike, in steps of 8 bits; most: of any "
    "pixel; times: medians of a frame";

Json NumberOrNull(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

const Json& Member(const Json& json, const char* name)
{
    static const Json kNothing;
    return json.is_object() && json.contains(name) ? json[name] : kNothing;
}

/// What is measured, printed or kept.
void ReadTimes(const Json& json, const char* ClockField::*name, RenderFigures& figures)
{
    for (const RenderWork& work : RenderWorks())
    {
        for (const ClockField& field : kClocks)
        {
            (figures.*work.times).*field.time =
                Number(Member(json, work.name), field.*name, kNoValue);
        }
    }
}

void ReadErrors(const Json& json, RenderFigures& figures)
{
    figures.rms = Number(json, "rms", kNoValue);
    figures.most = Number(json, "most", kNoValue);
    figures.edgePixels = Number(json, "edgePixels", 0.0);
}

Json FiguresJson(const RenderFigures& figures)
{
    Json json{
        {"method", figures.method}, {"ours", figures.isOurs}, {"rasterThreads", figures.threads}};
    if (!figures.failure.empty())
    {
        json["failure"] = figures.failure;
        return json;
    }
    json.update({{"by", figures.by},
                 {"rms", NumberOrNull(figures.rms)},
                 {"most", NumberOrNull(figures.most)},
                 {"edgePixels", figures.edgePixels},
                 {"wrong", figures.wrong}});
    for (const RenderWork& work : RenderWorks())
    {
        const RenderTimes& times = figures.*work.times;
        for (const ClockField& field : kClocks)
        {
            if (std::isfinite(times.*field.time))
            {
                json["frames"][work.name][field.kept] = times.*field.time;
            }
        }
    }
    return json;
}

RenderFigures FiguresFrom(const Json& json)
{
    RenderFigures figures;
    figures.method = Text(json, "method");
    figures.by = Text(json, "by");
    figures.isOurs = Member(json, "ours") == true;
    figures.threads = Text(json, "rasterThreads");
    figures.wrong = Text(json, "wrong");
    figures.failure = Text(json, "failure");
    ReadErrors(json, figures);
    ReadTimes(Member(json, "frames"), &ClockField::kept, figures);
    return figures;
}

/// No name, no size or no methods: it is not a case.
RenderResult ResultFrom(const Json& json)
{
    RenderResult result;
    result.info.name = Text(json, "case");
    result.info.what = Text(json, "what");
    bool complete = !result.info.name.empty();
    for (const auto& [name, field] : kSizes)
    {
        result.info.*field = int(std::clamp(Number(json, name, 0.0), 0.0, 1e9));
        complete = complete && result.info.*field > 0;
    }
    for (const auto& [name, field] : kGoals)
    {
        result.info.*field = Number(json, name, 0.0);
    }
    const Json& methods = Member(json, "methods");
    for (const Json& entry : methods.is_array() ? methods : Json::array())
    {
        result.methods.push_back(FiguresFrom(entry));
        const RenderFigures& figures = result.methods.back();
        complete = complete && !figures.method.empty() &&
                   (!figures.failure.empty() || (figures.full.cpu > 0.0 && figures.rms >= 0.0));
    }
    return complete && !result.methods.empty() ? result : RenderResult();
}

} // namespace

Result<std::vector<RenderFigures>> ParseRenderLines(const std::string& output)
{
    std::vector<RenderFigures> methods;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
    {
        if (line.empty() || line.front() != '{')
        {
            continue; // a library may talk
        }
        const Json json = ParseJson(line);
        RenderFigures figures;
        figures.method = Text(json, "method");
        figures.by = Text(json, "by");
        figures.wrong = Text(json, "wrong");
        ReadErrors(json, figures);
        ReadTimes(Member(json, "works"), &ClockField::printed, figures);
        const bool any = figures.full.cpu > 0.0 || figures.rms >= 0.0;
        if (figures.method.empty() || !any)
        {
            return Error{ErrorKind::Failed,
                         "A benchmark program printed no figures: '" + line + "'."};
        }
        methods.push_back(std::move(figures));
    }
    if (methods.empty())
    {
        return Error{ErrorKind::Failed, "A benchmark program printed no figures."};
    }
    return methods;
}

std::string RenderJson(const std::vector<RenderResult>& results)
{
    Json cases = Json::array();
    for (const RenderResult& result : results)
    {
        Json one{{"case", result.info.name}, {"what", result.info.what}};
        for (const auto& [name, field] : kSizes)
        {
            one[name] = result.info.*field;
        }
        for (const auto& [name, field] : kGoals)
        {
            if (result.info.*field > 0.0)
            {
                one[name] = result.info.*field;
            }
        }
        one["methods"] = Json::array();
        for (const RenderFigures& figures : result.methods)
        {
            one["methods"].push_back(FiguresJson(figures));
        }
        for (const RenderGoal& goal : RenderGoals(result))
        {
            one["goalsMet"][goal.what] = goal.IsMet();
        }
        cases.push_back(std::move(one));
    }
    return LinesOf(Json{{"drawing", kDefinition}, {"cases", cases}});
}

Result<std::vector<RenderResult>> ParseRenderJson(const std::string& text, const std::string& name)
{
    const Json json = ParseJson(text);
    if (const Result<void> sound =
            CheckFields(json, kRanges, name, "boxreel bench --render --json");
        !sound)
    {
        return sound.GetError();
    }
    const Json& cases = Member(json, "cases");
    std::vector<RenderResult> results;
    for (const Json& entry : cases.is_array() ? cases : Json::array())
    {
        results.push_back(ResultFrom(entry));
        if (results.back().info.name.empty())
        {
            results.clear();
            break;
        }
    }
    if (results.empty())
    {
        return Error{ErrorKind::Unusable,
                     "'" + name +
                         "' is not what `boxreel bench --render --json` prints; make it again."};
    }
    return results;
}

} // namespace boxreel
