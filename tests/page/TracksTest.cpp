// SPDX-License-Identifier: MIT
#include "Tracks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace boxreel
{
namespace
{

using testing::ElementsAre;

constexpr double kFar = 1e6;
constexpr double kNear = 0.3;

class Tracks : public testing::Test
{
protected:
    std::vector<boxreel::Run> Split(const DrawList& list)
    {
        return SplitRuns(list, kFar, styles, forms);
    }
    std::vector<std::ptrdiff_t> Match(const DrawList& before, const DrawList& after)
    {
        std::vector<Track> tracks;
        for (boxreel::Run& run : Split(before))
        {
            tracks.emplace_back().run = std::move(run);
        }
        return MatchRuns(tracks, Split(after), kNear);
    }
    static DrawList Points(const std::vector<Vec2>& places)
    {
        DrawList list;
        list.layer = DrawLayer::Contacts;
        for (const Vec2 place : places)
        {
            list.AddPoint(place, 4.0f, ColorRole::NewContact);
        }
        return list;
    }

    StyleTable styles;
    FormTable forms{1e-5};
};

TEST_F(Tracks, AreSplitByBodyAndStyle)
{
    DrawList list;
    for (const std::uint32_t owner : {1u, 1u, 2u, kNoOwner, kNoOwner})
    {
        list.owner = owner;
        list.AddSegment({0, 0}, {1, 0}, ColorRole::StaticBody);
    }
    list.owner = 2;
    list.AddSegment({0, 0}, {1, 0}, ColorRole::StaticBody);
    list.AddSegment({0, 0}, {1, 0}, ColorRole::AwakeBody);
    std::vector<std::size_t> counts;
    for (const boxreel::Run& run : Split(list))
    {
        counts.push_back(run.items.count);
    }
    EXPECT_THAT(counts, ElementsAre(2, 1, 1, 1, 1, 1));
    EXPECT_EQ(styles.All().size(), 2u);
}

TEST_F(Tracks, LeaveOutWhatCannotBeDrawn)
{
    DrawList list = Points({{0, 0}, {std::numeric_limits<float>::quiet_NaN(), 0}, {1e30f, 0}});
    list.AddPolygon(nullptr, 0, ColorRole::Pair);
    EXPECT_EQ(Split(list).size(), 1u);
}

TEST_F(Tracks, ContinueForBodiesHoweverFarTheyMove)
{
    DrawList before;
    before.owner = 7;
    before.AddCircle({0, 0}, 1.0f, ColorRole::AwakeBody);
    DrawList after;
    after.owner = 7;
    after.AddCircle({100, 0}, 1.0f, ColorRole::AsleepBody);
    EXPECT_THAT(Match(before, after), ElementsAre(0));
    after.items[0].size = 2.0f;
    EXPECT_THAT(Match(before, after), ElementsAre(-1));
}

TEST_F(Tracks, ContinueForContactsAmongNewOnes)
{
    const DrawList before = Points({{0, 0}, {1, 0}, {2, 0}, {3, 0}});
    EXPECT_THAT(Match(before, Points({{5, 5}, {0, 0}, {1.1f, 0}, {3, 0}, {4, 0}})),
                ElementsAre(-1, 0, 1, 3, -1));
    EXPECT_THAT(Match(before, Points({{3, 0}})), ElementsAre(3));
    EXPECT_THAT(Match(before, Points({})), ElementsAre());
}

} // namespace
} // namespace boxreel
