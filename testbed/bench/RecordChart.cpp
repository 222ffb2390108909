// SPDX-License-Identifier: MIT
#include "Format.h"
#include "RecordBench.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr double kLeastDrawn = 0.02; // a stage below it in all films is left out [ms]

struct Peer
{
    RecordRole role;
    const char* legend;
    double RecordCase::*goal; ///< ours over theirs
};

constexpr Peer kPeers[] = {
    {RecordRole::Encoding, "than ffmpeg, which only encodes", &RecordCase::goalOverEncoding},
    {RecordRole::Immediate, "than immediate mode piped to ffmpeg", &RecordCase::goalOverImmediate},
};

std::string TimesText(double times)
{
    return Format(times < 10.0 ? "%.2f\u00d7" : "%.1f\u00d7", times);
}

ChartBar BarOf(const RecordResult& result, const Peer& peer)
{
    const RecordFigures* const ours = FindRole(result, RecordRole::Ours);
    const RecordFigures* const theirs = FindRole(result, peer.role);
    ChartBar bar;
    if (ours == nullptr || theirs == nullptr)
    {
        bar.label = "not made";
        return bar;
    }
    for (const RecordFigures* const figures : {ours, theirs})
    {
        if (figures->verdict != "sound")
        {
            bar.label = "not compared: " + figures->verdict;
            return bar;
        }
    }
    bar.value = theirs->wall / ours->wall;
    bar.label = TimesText(bar.value);
    const double goal = result.info.*peer.goal;
    bar.mark = goal > 0.0 ? 1.0 / goal : kNoValue;
    return bar;
}

/// "pyramid 600, pictures 300 frames of 1280 x 720": a size is named once.
std::string FilmsOf(const std::vector<RecordResult>& results)
{
    std::string text;
    std::string size;
    for (const RecordResult& result : results)
    {
        const RecordCase& info = result.info;
        const std::string own = Format("%d \u00d7 %d", info.width, info.height);
        text += text.empty() ? "" : own == size ? ", " : " frames of " + size + "; ";
        text += info.name + " " + std::to_string(info.frames);
        size = own;
    }
    return text + " frames of " + size;
}

bool Has(const std::vector<RecordResult>& results, RecordRole role)
{
    return std::any_of(results.begin(), results.end(), [role](const RecordResult& result) {
        return FindRole(result, role) != nullptr;
    });
}

const RecordStage* FindStage(const RecordResult& result, const RecordStage& like)
{
    for (const RecordStage& stage : result.stages)
    {
        if (stage.stage == like.stage && stage.thread == like.thread)
        {
            return &stage;
        }
    }
    return nullptr;
}

/// Those that take time in any film, in the order of the first.
std::vector<RecordStage> StagesOf(const std::vector<RecordResult>& results)
{
    std::vector<RecordStage> stages;
    for (const RecordStage& stage : results.front().stages)
    {
        const bool takesTime =
            std::any_of(results.begin(), results.end(), [&](const RecordResult& result) {
                const RecordStage* const same = FindStage(result, stage);
                return same != nullptr && same->cpu * 1e3 >= kLeastDrawn;
            });
        if (takesTime)
        {
            stages.push_back(stage);
        }
    }
    return stages;
}

} // namespace

Result<BarChart> RecordSpeedChart(const std::vector<RecordResult>& results)
{
    BarChart chart;
    std::vector<Peer> peers;
    for (const Peer& peer : kPeers)
    {
        if (Has(results, peer.role))
        {
            chart.series.push_back({peer.legend, int(chart.series.size()) + 1});
            peers.push_back(peer);
        }
    }
    if (peers.empty())
    {
        return Error{ErrorKind::Unusable, "There is nothing to compare films with in a chart; "
                                          "install ffmpeg and run it again."};
    }
    for (const RecordResult& result : results)
    {
        const RecordFigures* const ours = FindRole(result, RecordRole::Ours);
        ChartGroup group;
        group.name = result.info.name;
        group.detail = result.info.what;
        group.value = ours != nullptr ? Format("%.2f s", ours->wall) : "";
        for (const Peer& peer : peers)
        {
            group.bars.push_back(BarOf(result, peer));
        }
        chart.groups.push_back(std::move(group));
    }
    chart.frame.title = "How many times faster is boxreel record?";
    chart.frame.subtitle =
        "wall time of the other over that of boxreel, from a cold start to a closed film";
    chart.frame.notes = {"The same frames, the same encoder with the same settings. ffmpeg alone "
                         "reads frames that somebody else has simulated and drawn.",
                         "Films: " + FilmsOf(results) + "."};
    chart.axis = {"times faster", true};
    chart.start = 1.0;
    chart.startLabel = "equally fast";
    chart.valueTitle = "boxreel's time";
    chart.markName = "goal";
    return chart;
}

Result<BarChart> RecordStageChart(const std::vector<RecordResult>& results)
{
    if (results.empty() || results.front().stages.empty())
    {
        return Error{ErrorKind::Unusable,
                     "These figures do not say where the time of a frame goes; run it again."};
    }
    BarChart chart;
    for (const RecordResult& result : results)
    {
        chart.series.push_back({result.info.name, int(chart.series.size())});
    }
    for (const RecordStage& stage : StagesOf(results))
    {
        ChartGroup group;
        group.name = stage.stage;
        group.detail = stage.thread == "codec"    ? "threads of the codec's own"
                       : stage.thread == "raster" ? "threads of Mesa's own"
                                                  : stage.thread + " thread";
        for (const RecordResult& result : results)
        {
            const RecordStage* const same = FindStage(result, stage);
            ChartBar bar;
            bar.value = same != nullptr ? same->cpu * 1e3 : kNoValue;
            bar.label = same != nullptr ? Format("%.2f", bar.value) : "none";
            group.bars.push_back(bar);
        }
        chart.groups.push_back(std::move(group));
    }
    chart.frame.title = "Where each millisecond of a frame goes";
    chart.frame.subtitle = "CPU time of boxreel record a frame [ms], by stage and film";
    chart.frame.notes = {
        "The sum over a film, cold start and end included, divided by its frames."};
    chart.axis = {"CPU time of a frame [ms]", false};
    return chart;
}

} // namespace boxreel
