// SPDX-License-Identifier: MIT
#include "Tracks.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// How many tracks or runs are passed over in search of the next pair. Contacts come and go at any
// place of their list, usually a few in a step.
constexpr std::size_t kWindow = 64;

bool IsUsable(const DrawList& list, const DrawItem& item, double farthest)
{
    const auto isNear = [farthest](float value) { return std::abs(value) <= farthest; }; // no NaN
    const auto points = std::span(list.points).subspan(item.first, item.count);
    return item.count > 0 && isNear(item.size) &&
           std::all_of(points.begin(), points.end(),
                       [&](Vec2 p) { return isNear(p.x) && isNear(p.y); });
}

bool Fits(const Track& track, const Run& run)
{
    return track.run.owner == run.owner && track.run.layer == run.layer &&
           track.run.signature == run.signature;
}

bool IsPair(const Track& track, const Run& run, double near)
{
    return Fits(track, run) &&
           (run.owner != kNoOwner || std::hypot(double(track.run.at.x) - run.at.x,
                                                double(track.run.at.y) - run.at.y) <= near);
}

} // namespace

std::uint32_t StyleTable::Find(const DrawItem& item)
{
    const Color& c = item.color;
    const auto [known, isNew] = m_known.try_emplace(
        std::tuple(int(item.layer), int(item.role), int(c.r), int(c.g), int(c.b), int(c.a)),
        std::uint32_t(m_styles.size()));
    if (isNew)
    {
        m_styles.push_back({item.layer, item.Asked()});
    }
    return known->second;
}

std::vector<Run> SplitRuns(const DrawList& list, double farthest, StyleTable& styles,
                           FormTable& forms)
{
    std::vector<Run> runs;
    bool isNext = false; // the item before is the last of the last run
    for (std::size_t i = 0; i < list.items.size(); ++i)
    {
        const DrawItem& item = list.items[i];
        if (!IsUsable(list, item, farthest))
        {
            isNext = false;
            continue;
        }
        const std::uint32_t style = styles.Find(item);
        if (isNext && item.owner != kNoOwner && runs.back().owner == item.owner &&
            runs.back().style == style)
        {
            ++runs.back().items.count;
            continue;
        }
        runs.push_back({{i, 1}, style, item.owner, item.layer, "", list.points[item.first]});
        isNext = true;
    }
    for (Run& run : runs)
    {
        run.signature = forms.Signature(list, run.items);
    }
    return runs;
}

std::vector<std::ptrdiff_t> MatchRuns(const std::vector<Track>& tracks,
                                      const std::vector<Run>& runs, double near)
{
    std::vector<std::ptrdiff_t> matches(runs.size(), -1);
    std::size_t t = 0;
    for (std::size_t r = 0; r < runs.size() && t < tracks.size();)
    {
        // The smallest number of tracks that end, or of runs that begin, before the next pair.
        std::size_t skipped = 0;
        bool endsTracks = false;
        bool found = false;
        for (; skipped <= kWindow && !found; skipped += found ? 0 : 1)
        {
            endsTracks = t + skipped < tracks.size() && IsPair(tracks[t + skipped], runs[r], near);
            found = endsTracks ||
                    (r + skipped < runs.size() && IsPair(tracks[t], runs[r + skipped], near));
        }
        if (!found) // this run is new, or has jumped
        {
            const bool jumped = Fits(tracks[t], runs[r]);
            matches[r] = jumped ? std::ptrdiff_t(t) : -1;
            ++r;
            ++t;
            continue;
        }
        t += endsTracks ? skipped : 0;
        r += endsTracks ? 0 : skipped;
        matches[r++] = std::ptrdiff_t(t++);
    }
    return matches;
}

} // namespace boxreel
