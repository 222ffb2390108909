// SPDX-License-Identifier: MIT
#pragma once

#include "Forms.h"
#include "Predictor.h"

#include <map>
#include <tuple>

/// Tracks: which items of a list are those of the list before. Reads lists only.
namespace boxreel
{

/// What the items of a run have in common but their body.
struct PageStyle
{
    DrawLayer layer = DrawLayer::Shapes;
    Paint paint;
};

/// All styles of a page, by number in the order of their addition.
class StyleTable
{
public:
    std::uint32_t Find(const DrawItem& item);
    const std::vector<PageStyle>& All() const { return m_styles; }

private:
    std::vector<PageStyle> m_styles;
    std::map<std::tuple<int, int, int, int, int, int>, std::uint32_t> m_known;
};

/// Items next to each other in a list that have body and style in common.
struct Run
{
    ItemRun items;
    std::uint32_t style = 0;
    std::uint32_t owner = kNoOwner;
    DrawLayer layer = DrawLayer::Shapes;
    std::string signature; ///< of FormTable
    Vec2 at;               ///< its first point [m]
};

/// Splits a list. Items that are not finite, or farther away than `farthest` [m], are left out.
/// Only items of a body share a run.
std::vector<Run> SplitRuns(const DrawList& list, double farthest, StyleTable& styles,
                           FormTable& forms);

/// A run as it goes on from frame to frame.
struct Track
{
    Run run; ///< in the latest list
    std::uint32_t form = 0;
    bool isRigid = false;
    std::vector<std::int64_t> numbers; ///< where it is: x, y and angle, or x and y of each point
    std::vector<Predictor> predictors; ///< of these
};

/// Returns for each run the index of its track, or -1 for a new one. Indices rise. A run without a
/// body continues a track only within `near` [m], if another is to be had.
std::vector<std::ptrdiff_t> MatchRuns(const std::vector<Track>& tracks,
                                      const std::vector<Run>& runs, double near);

} // namespace boxreel
