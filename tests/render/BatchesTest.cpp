// SPDX-License-Identifier: MIT
#include "Batches.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace boxreel;

namespace
{

bool Touch(const PixelBounds& a, const PixelBounds& b)
{
    return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
}

} // namespace

TEST(Batches, MergeNeighboursOfOneKindAcrossOthers)
{
    Batches batches;
    batches.Clear(1280, 720);
    const float data[1] = {0.0f};
    for (int i = 0; i < 1000; ++i)
    {
        const int x = i % 20 * 64;
        const int y = i / 20 % 11 * 64;
        batches.Add(i % 2 ? ProgramKind::Box : ProgramKind::Disc, Form::Quad,
                    {x, y, x + 20, y + 20}, {}, data);
    }
    EXPECT_LE(batches.All().size(), 10u);
}

TEST(Batches, KeepTheOrderOfAllThatOverlaps)
{
    std::mt19937 random(3);
    Batches batches;
    for (int round = 0; round < 20; ++round)
    {
        batches.Clear(333, 200);
        std::vector<PixelBounds> all;
        for (int i = 0; i < 300; ++i)
        {
            const int x = int(random() % 300);
            const int y = int(random() % 180);
            all.push_back({x, y, x + 1 + int(random() % 33), y + 1 + int(random() % 20)});
            batches.Add(ProgramKind(random() % kProgramKinds), Form(random() % kForms), all.back(),
                        {float(i)}, {});
        }
        std::vector<int> order;
        for (const Batch& batch : batches.All())
        {
            EXPECT_EQ(batch.instances * 4, batch.data.size());
            for (std::size_t i = 0; i < batch.data.size(); i += 4)
            {
                order.push_back(int(batch.data[i]));
            }
        }
        ASSERT_EQ(order.size(), all.size()) << "each instance is drawn once";
        for (std::size_t i = 0; i < order.size(); ++i)
        {
            for (std::size_t k = i + 1; k < order.size(); ++k)
            {
                const bool swapped = order[i] > order[k];
                ASSERT_FALSE(swapped &&
                             Touch(all[std::size_t(order[i])], all[std::size_t(order[k])]));
            }
        }
    }
}

TEST(Batches, TellApartNeighboursAtASlantWhoseBoundsOverlap)
{
    Batches batches;
    batches.Clear(200, 200);
    // Two slabs at 45 degrees, 100 px long, 10 px apart: centre, axis, half extents.
    const float slope = 0.70710678f;
    const std::array<float, 6> first{90.0f, 100.0f, slope, slope, 50.0f, 3.0f};
    const std::array<float, 6> second{110.0f, 90.0f, slope, slope, 50.0f, 3.0f};
    const std::array<float, 6> across{100.0f, 95.0f, slope, -slope, 50.0f, 3.0f};
    const PixelBounds bounds{40, 40, 160, 160};
    batches.Add(ProgramKind::Box, Form::Quad, bounds, {}, first);
    batches.Add(ProgramKind::Disc, Form::Quad, {150, 40, 160, 50}, {}, {});
    batches.Add(ProgramKind::Box, Form::Quad, bounds, {}, second);
    EXPECT_EQ(batches.All().size(), 2u) << "the boxes share a draw call";
    batches.Add(ProgramKind::ThinBox, Form::Quad, bounds, {}, across);
    batches.Add(ProgramKind::Box, Form::Quad, bounds, {}, first);
    EXPECT_EQ(batches.All().size(), 4u) << "what crosses keeps its place";
}

TEST(Batches, KeepTheOrderOfMoreDrawCallsThanATileCanCount)
{
    Batches batches;
    batches.Clear(64, 64);
    constexpr int kCount = 1000;
    for (int i = 0; i < kCount; ++i)
    {
        batches.Add(i % 2 ? ProgramKind::Box : ProgramKind::Disc, Form::Quad, {0, 0, 10, 10},
                    {float(i)}, {});
    }
    ASSERT_EQ(batches.All().size(), std::size_t(kCount));
    for (int i = 0; i < kCount; ++i)
    {
        EXPECT_EQ(batches.All()[std::size_t(i)].data[0], float(i));
    }
}
