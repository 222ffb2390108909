// SPDX-License-Identifier: MIT
#include "VerdictFile.h"
#include "VerdictText.h"

#include <nlohmann/json.hpp>

#include <tuple>

namespace boxreel
{
namespace
{

using nlohmann::ordered_json;

/// Replaces invalid UTF-8 by U+FFFD, because a draw list may contain any bytes.
std::string Dumped(const ordered_json& object)
{
    return object.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

ordered_json Regions(const std::vector<PixelBounds>& regions)
{
    ordered_json list = ordered_json::array();
    for (const PixelBounds& region : regions)
    {
        list.push_back({region.x0, region.y0, region.x1 - region.x0, region.y1 - region.y0});
    }
    return list;
}

void AddLimits(ordered_json& object, const CompareSettings& limits)
{
    object["limits"] = DescribeLimits(limits);
    object["preset"] = limits.preset;
    object["options"] = limits.options;
    VisitLimits([&object](const char* name, auto value) { object[name] = value; }, limits);
    if (limits.maxPixels == kAnyNumberOfPixels)
    {
        object["maxPixels"] = nullptr;
    }
    object["ignored"] = Regions(limits.ignored);
    object["ignoredBodies"] = limits.ignoredBodies;
}

void AddPixels(ordered_json& object, const Comparison& pixels)
{
    object["pixels"] = pixels.Text();
    VisitCounts([&object](const char* name, auto value) { object[name] = value; }, pixels);
}

void AddSteps(ordered_json& object, const VerdictRecord& record)
{
    const std::vector<TraceStep>& steps = record.candidate.trace.steps;
    if (!steps.empty())
    {
        object["since"] = steps.front().step; // the first compared step
        object["step"] = steps.back().step;
    }
    const auto& [world, film] = std::tie(record.verdict.world, record.verdict.film);
    const TraceDifference* const trace = world && world->inTrace ? &*world->inTrace : nullptr;
    const std::optional<std::int64_t> first = trace  ? std::optional(trace->step)
                                              : film ? film->firstStep
                                                     : std::nullopt;
    if (!first)
    {
        return;
    }
    object["firstStep"] = *first;
    object["firstBodies"] = trace ? trace->bodies : std::vector<int>();
    for (const TraceStep& step : steps)
    {
        if (*first == step.step)
        {
            // Lets a program that repeats the steps verify that its world is the same.
            object["firstHash"] = step.world;
        }
    }
}

/// Adds what the findings say, as data: programs compare verdicts by it.
void AddDifferences(ordered_json& object, const GoldenVerdict& verdict)
{
    if (verdict.status == GoldenStatus::NotCompared)
    {
        object["culprit"] = verdict.problem.culprit.Text();
    }
    if (verdict.world)
    {
        object["state"] = verdict.world->actual;
    }
    if (verdict.list)
    {
        object["line"] = verdict.list->line;
    }
    if (verdict.film && verdict.film->HasOtherMoments())
    {
        object["moments"] = verdict.film->actualMoments;
    }
    if (!verdict.missing.empty())
    {
        object["missing"] = verdict.missing;
    }
}

} // namespace

std::string ToJson(const VerdictRecord& record)
{
    const GoldenVerdict& verdict = record.verdict;
    const GoldenCandidate& candidate = record.candidate;
    ordered_json object{{"verdict", 2}, // version of the format
                        {"name", verdict.name},
                        {"status", StatusWord(verdict.status)},
                        {"findings", verdict.Findings()}};
    if (!verdict.accept.empty())
    {
        object["accept"] = verdict.accept;
    }
    AddDifferences(object, verdict);
    AddLimits(object, record.limits);
    object["limitsChoice"] = LimitsWord(verdict.limits);
    if (verdict.compared.frame)
    {
        AddPixels(object, verdict.pixels);
    }
    object["renderer"] = candidate.renderer;
    object["fingerprint"] = candidate.fingerprint;
    if (candidate.camera && CanBeDrawn(*candidate.camera))
    {
        const Camera& camera = *candidate.camera;
        object["view"] = {camera.width, camera.height, camera.centerX, camera.centerY,
                          camera.pixelsPerMeter};
    }
    AddSteps(object, record);
    return Dumped(object);
}

std::optional<std::string> Accepted(std::string_view json)
{
    ordered_json object = ordered_json::parse(json, nullptr, false);
    if (!object.is_object())
    {
        return std::nullopt;
    }
    object["accepted"] = true;
    return Dumped(object);
}

} // namespace boxreel
