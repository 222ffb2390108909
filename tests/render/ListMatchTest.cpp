// SPDX-License-Identifier: MIT
#include "ListMatch.h"

#include <gtest/gtest.h>

#include <limits>

using namespace boxreel;

namespace
{

DrawList Points(const std::vector<int>& places)
{
    DrawList list;
    for (const int x : places)
    {
        list.AddPoint({float(x), 0}, 3, {});
    }
    return list;
}

std::vector<std::size_t> Matches(const DrawList& last, const DrawList& next)
{
    std::vector<std::size_t> matches;
    MatchItems(last, next, matches);
    return matches;
}

using Expected = std::vector<std::size_t>;

} // namespace

TEST(MatchItems, FindsUnchangedItems)
{
    const DrawList last = Points({1, 2, 3, 4});
    EXPECT_EQ(Matches(last, last), (Expected{0, 1, 2, 3}));
    EXPECT_EQ(Matches(last, Points({1, 2, 9, 4})), (Expected{0, 1, kNoMatch, 3}));
    EXPECT_EQ(Matches(last, Points({1, 3, 4})), (Expected{0, 2, 3}));
    EXPECT_EQ(Matches(last, Points({8, 9, 1, 2, 3, 4})),
              (Expected{kNoMatch, kNoMatch, 0, 1, 2, 3}));
    EXPECT_EQ(Matches(last, Points({})), Expected{});
    EXPECT_EQ(Matches(Points({}), Points({1})), Expected{kNoMatch});
}

TEST(MatchItems, KeepsTheOrderOfMatches)
{
    const Expected matches = Matches(Points({1, 2, 3, 4, 5}), Points({5, 4, 3, 2, 1}));
    std::size_t last = 0;
    for (const std::size_t match : matches)
    {
        if (match != kNoMatch)
        {
            EXPECT_GE(match, last);
            last = match + 1;
        }
    }
}

TEST(MatchItems, ComparesVisiblePropertiesOnly)
{
    DrawList last;
    last.AddText({1, 1}, "a", {});
    last.AddSolidCircle({1, 2}, 3, {1, 0}, {1, 2, 3, 255});
    DrawList next = last;
    next.items[0].layer = DrawLayer::Labels;
    next.items[1].owner = 7;
    EXPECT_EQ(Matches(last, next), (Expected{0, 1}));
    next.texts[0] += "b";
    next.items[1].size = -3;
    EXPECT_EQ(Matches(last, next), (Expected{kNoMatch, kNoMatch}));
    next = last;
    next.points[2].y = -0.0f; // not the same bits
    next.items[0].color.a = 9;
    EXPECT_EQ(Matches(last, next), (Expected{kNoMatch, kNoMatch}));
}
