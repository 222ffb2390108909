// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2DynamicTree.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
b2AABB Box(const b2Vec2& center, float halfWidth, float halfHeight)
{
    b2AABB box;
    box.lowerBound = center - b2Vec2(halfWidth, halfHeight);
    box.upperBound = center + b2Vec2(halfWidth, halfHeight);
    return box;
}

b2AABB RandomBox(Random& random)
{
    const float size = random.Integer(0, 20) == 0 ? 20.0f : 1.0f;
    const b2Vec2 center = random.Point(50.0f);
    const b2Vec2 half = b2Abs(random.Point(size));
    return Box(center, half.x, half.y);
}

std::string Invalid(const b2DynamicTree& tree)
{
    const char* why = tree.WhyInvalid();
    return why == nullptr ? "" : why;
}

struct Collector
{
    bool QueryCallback(int32 proxyId)
    {
        found.insert(proxyId);
        ++calls;
        return true;
    }
    float32 RayCastCallback(const b2RayCastInput&, int32 proxyId)
    {
        found.insert(proxyId);
        ++calls;
        return -1.0f;
    }

    std::set<int32> found;
    int calls = 0;
};

// The nearest of the boxes themselves.
struct Nearest
{
    float32 RayCastCallback(const b2RayCastInput& input, int32 proxyId)
    {
        b2RayCastOutput output;
        if (tree.GetFatAABB(proxyId).RayCast(&output, input))
        {
            fraction = output.fraction;
            return output.fraction;
        }
        return input.maxFraction;
    }

    const b2DynamicTree& tree;
    float32 fraction = 2.0f;
};

void CompareWithList(const b2DynamicTree& tree, const std::map<int32, b2AABB>& list, Random& random)
{
    ASSERT_EQ(Invalid(tree), "");
    ASSERT_EQ(tree.GetProxyCount(), static_cast<int32>(list.size()));
    const b2AABB window = RandomBox(random);
    Collector collector;
    tree.Query(&collector, window);
    std::set<int32> expected;
    for (const auto& [id, box] : list)
    {
        if (b2TestOverlap(box, window))
        {
            expected.insert(id);
        }
    }
    ASSERT_EQ(collector.found, expected);
    ASSERT_EQ(collector.calls, static_cast<int>(expected.size()));

    const b2RayCastInput ray = {random.Point(60.0f), random.Point(60.0f), 1.0f};
    Nearest nearest{tree};
    tree.RayCast(&nearest, ray);
    float32 minimum = 2.0f;
    for (const auto& [id, box] : list)
    {
        b2RayCastOutput output;
        if (box.RayCast(&output, ray))
        {
            minimum = std::min(minimum, output.fraction);
        }
    }
    ASSERT_EQ(nearest.fraction, minimum);
}
} // namespace

TEST(Tree, EqualsAListAfterRandomInsertionsMovesAndRemovals)
{
    Random random(41);
    b2DynamicTree tree;
    std::map<int32, b2AABB> list; // what the tree should have stored
    for (int i = 0; i < 20000; ++i)
    {
        const int what = random.Integer(0, 9);
        if (list.empty() || what < 3)
        {
            const b2AABB box = RandomBox(random);
            list[tree.CreateProxyExact(box, i)] = box;
        }
        else
        {
            auto chosen =
                std::next(list.begin(), random.Integer(0, static_cast<int32>(list.size()) - 1));
            if (what < 5)
            {
                tree.DestroyProxy(chosen->first);
                list.erase(chosen);
            }
            else if (what < 8)
            {
                chosen->second = RandomBox(random);
                tree.SetProxyAABB(chosen->first, chosen->second);
            }
            else
            {
                chosen->second.Combine(RandomBox(random));
                tree.EnlargeProxy(chosen->first, chosen->second);
            }
        }
        if (i % 10 == 0)
        {
            CompareWithList(tree, list, random);
        }
        if (i % 5000 == 4999)
        {
            tree.RebuildBottomUp();
            CompareWithList(tree, list, random);
        }
    }
}

TEST(Tree, ReportsEveryBoxThatARayCrosses)
{
    Random random(42);
    b2DynamicTree tree;
    for (int i = 0; i < 1000; ++i)
    {
        tree.CreateProxyExact(RandomBox(random), i);
    }
    for (int i = 0; i < 500; ++i)
    {
        const b2RayCastInput ray = {random.Point(60.0f), random.Point(60.0f), 1.0f};
        Collector collector;
        tree.RayCast(&collector, ray);
        for (int32 id = 0; id < 2000; ++id)
        {
            b2RayCastOutput output;
            if (tree.IsProxy(id) && tree.GetFatAABB(id).RayCast(&output, ray))
            {
                ASSERT_TRUE(collector.found.contains(id));
            }
        }
        ASSERT_LT(collector.calls, 300);
    }
}

TEST(Tree, ReportsOnlyBoxesNearTheClippedRay)
{
    // Answers that cut the ray at random, as hits would.
    struct Cutter
    {
        float32 RayCastCallback(const b2RayCastInput& input, int32 proxyId)
        {
            const b2Vec2 d = input.p2 - input.p1;
            const b2AABB& box = tree->GetFatAABB(proxyId);
            const float64 nearest = NearestFraction(input, box);
            EXPECT_LE(nearest, input.maxFraction + 1e-4);
            EXPECT_LE(Distance(input.p1, d, nearest, box), 1e-4);
            ++calls;
            return random->Integer(0, 3) == 0 ? 0.9f * input.maxFraction : -1.0f;
        }
        typedef double float64;
        // Returns the fraction between 0 and 1 at which the ray is closest to the box. Found by
        // trisection, because the distance to a convex set is convex along a line.
        static float64 NearestFraction(const b2RayCastInput& input, const b2AABB& box)
        {
            float64 low = 0.0;
            float64 high = input.maxFraction;
            const b2Vec2 d = input.p2 - input.p1;
            for (int i = 0; i < 100; ++i)
            {
                const float64 third = (high - low) / 3.0;
                const bool isInLower = Distance(input.p1, d, low + third, box) <=
                                       Distance(input.p1, d, high - third, box);
                (isInLower ? high : low) = isInLower ? high - third : low + third;
            }
            return low;
        }
        static float64 Distance(const b2Vec2& p, const b2Vec2& d, float64 t, const b2AABB& box)
        {
            const float64 x = p.x + t * d.x;
            const float64 y = p.y + t * d.y;
            const float64 outX = std::max({box.lowerBound.x - x, x - box.upperBound.x, 0.0});
            const float64 outY = std::max({box.lowerBound.y - y, y - box.upperBound.y, 0.0});
            return std::hypot(outX, outY);
        }
        const b2DynamicTree* tree;
        Random* random;
        int calls = 0;
    };
    Random random(44);
    b2DynamicTree tree;
    for (int i = 0; i < 1000; ++i)
    {
        tree.CreateProxyExact(RandomBox(random), i);
    }
    Cutter cutter{&tree, &random};
    for (int i = 0; i < 500; ++i)
    {
        tree.RayCast(&cutter, {random.Point(60.0f), random.Point(60.0f), 1.0f});
    }
    EXPECT_GT(cutter.calls, 1000);
}

TEST(Tree, IsIndependentOfThePreviousTreeWhenRebuilt)
{
    Random random(45);
    std::vector<b2AABB> boxes;
    for (int i = 0; i < 2000; ++i)
    {
        // Many centres on a line, and many alike.
        const bool isAligned = random.Integer(0, 1) == 0;
        const b2Vec2 center(isAligned ? 5.0f : random.Real(-50.0f, 50.0f),
                            static_cast<float>(random.Integer(-20, 20)));
        const b2Vec2 half = b2Abs(random.Point(1.0f));
        boxes.push_back(Box(center, half.x, half.y));
    }
    b2DynamicTree once;
    b2DynamicTree twice;
    for (int32 i = 0; i < 2000; ++i)
    {
        once.CreateProxyExact(boxes[static_cast<std::size_t>(i)], i);
        twice.CreateProxyExact(boxes[static_cast<std::size_t>(i)], i);
    }
    once.RebuildBottomUp();
    twice.RebuildBottomUp();
    twice.RebuildBottomUp();
    EXPECT_EQ(Invalid(once), "");
    std::vector<int32> orders[2];
    for (int k = 0; k < 2; ++k)
    {
        (k == 0 ? once : twice).ForEachOverlap(Box(b2Vec2_zero, 60.0f, 60.0f), [&](int32 id) {
            orders[k].push_back(id);
            return true;
        });
    }
    EXPECT_EQ(orders[0].size(), 2000u);
    EXPECT_EQ(orders[0], orders[1]);
}

TEST(Tree, HasMinimalHeightAndFindsTheSameWhenBuiltEvenly)
{
    Random random(45);
    for (const int32 count : {0, 1, 2, 3, 5, 64, 1000})
    {
        b2DynamicTree tree;
        std::map<int32, b2AABB> list;
        for (int32 i = 0; i < count; ++i)
        {
            const b2AABB box = i % 3 == 0 ? Box(b2Vec2_zero, 1.0f, 1.0f) : RandomBox(random);
            list[tree.CreateProxyExact(box, i)] = box;
        }
        for (int32 round = 0; round < 3; ++round)
        {
            for (auto& [id, box] : list)
            {
                box = id % 2 == 0 ? RandomBox(random) : box;
                tree.SetProxyAABBForRebuild(id, box);
            }
            round == 1 ? tree.RefitAll() : tree.RebuildEvenly();
            ASSERT_EQ(Invalid(tree), "") << count;
            ASSERT_EQ(tree.GetHeight(), std::bit_width(static_cast<unsigned>(b2Max(count, 1) - 1)));
            for (int32 i = 0; i < 20; ++i)
            {
                CompareWithList(tree, list, random);
            }
        }
    }
}

TEST(Tree, ReportsEveryPairOnce)
{
    Random random(47);
    for (const int32 count : {0, 1, 2, 3, 300})
    {
        b2DynamicTree tree;
        std::map<int32, b2AABB> list;
        for (int32 i = 0; i < count; ++i)
        {
            const b2AABB box = RandomBox(random);
            list[tree.CreateProxyExact(box, i)] = box;
        }
        std::set<std::pair<int32, int32>> reported;
        tree.ForEachPair([&](int32 a, int32 b) {
            EXPECT_TRUE(reported.emplace(b2Min(a, b), b2Max(a, b)).second);
        });
        std::set<std::pair<int32, int32>> expected;
        for (const auto& [a, boxA] : list)
        {
            for (const auto& [b, boxB] : list)
            {
                if (a < b && b2TestOverlap(boxA, boxB))
                {
                    expected.emplace(a, b);
                }
            }
        }
        ASSERT_EQ(reported, expected);
        EXPECT_TRUE(count < 300 || expected.size() > 100);
    }
}

TEST(Tree, IsNearlyAsGoodBuiltEvenlyAsBottomUp)
{
    Random random(46);
    b2DynamicTree tree;
    for (int32 i = 0; i < 2000; ++i)
    {
        const b2Vec2 half = b2Abs(random.Point(1.0f));
        tree.CreateProxyExact(Box(random.Point(50.0f), half.x, half.y), i);
    }
    tree.RebuildEvenly();
    const float32 evenly = tree.GetAreaRatio();
    tree.RebuildBottomUp();
    EXPECT_LT(evenly, 1.25f * tree.GetAreaRatio());
}

TEST(Tree, IsBetterWhenRebuiltThanWhenInsertedInRows)
{
    b2DynamicTree tree;
    for (int32 i = 0; i < 2000; ++i)
    {
        const b2Vec2 center(3.0f * static_cast<float>(i % 50), 3.0f * static_cast<float>(i / 50));
        tree.CreateProxyExact(Box(center, 1.0f, 1.0f), i);
    }
    const float32 inserted = tree.GetAreaRatio();
    tree.RebuildBottomUp();
    EXPECT_LT(tree.GetAreaRatio(), 0.9f * inserted);
}

TEST(Tree, MovesAProxyOnlyWhenItLeavesItsFatBox)
{
    b2DynamicTree tree;
    int data = 0;
    const int32 id = tree.CreateProxy(Box(b2Vec2_zero, 1.0f, 1.0f), &data);
    EXPECT_EQ(tree.GetUserData(id), &data);
    EXPECT_FLOAT_EQ(tree.GetFatAABB(id).upperBound.x, 1.0f + b2_aabbExtension);
    EXPECT_FALSE(tree.MoveProxy(id, Box(b2Vec2(0.05f, 0.0f), 1.0f, 1.0f), b2Vec2(0.05f, 0.0f)));
    EXPECT_TRUE(tree.MoveProxy(id, Box(b2Vec2(0.5f, 0.0f), 1.0f, 1.0f), b2Vec2(0.5f, -0.25f)));
    EXPECT_EQ(tree.GetFatAABB(id).lowerBound, b2Vec2(-0.6f, -1.6f));
    EXPECT_EQ(tree.GetFatAABB(id).upperBound, b2Vec2(2.6f, 1.1f));
}

TEST(Tree, StaysLowForAnyOrderOfInsertion)
{
    constexpr int32 count = 4096;
    const int32 log2 = std::bit_width(static_cast<unsigned>(count));
    for (const char* order : {"sorted", "identical", "nested", "giant"})
    {
        b2DynamicTree tree;
        const std::string kind = order;
        // Boxes that each contain all before would be best as a list.
        const int32 limit = kind == "nested" ? 8 * log2 : 2 * log2 + 4;
        for (int32 i = 0; i < count; ++i)
        {
            const float f = static_cast<float>(i);
            const b2AABB box = kind == "sorted"      ? Box(b2Vec2(f, 0.0f), 0.6f, 0.5f)
                               : kind == "identical" ? Box(b2Vec2_zero, 1.0f, 1.0f)
                               : kind == "nested"    ? Box(b2Vec2_zero, f + 1.0f, f + 1.0f)
                               : i == 0              ? Box(b2Vec2_zero, 1.0e4f, 1.0f)
                                                     : Box(b2Vec2(0.1f * f, 0.0f), 0.1f, 0.1f);
            tree.CreateProxyExact(box, i);
        }
        EXPECT_EQ(Invalid(tree), "") << order;
        EXPECT_LE(tree.GetHeight(), limit) << order;
        const float32 before = tree.GetAreaRatio();
        tree.RebuildBottomUp();
        EXPECT_EQ(Invalid(tree), "") << order;
        EXPECT_LE(tree.GetHeight(), limit) << order;
        EXPECT_LE(tree.GetAreaRatio(), 1.05f * before) << order;
        EXPECT_LE(tree.GetMaxBalance(), tree.GetHeight()) << order;
    }
}

TEST(Tree, IsNearlyAsGoodInsertedAsBuiltBottomUp)
{
    Random random(43);
    b2DynamicTree tree;
    for (int32 i = 0; i < 5000; ++i)
    {
        tree.CreateProxyExact(Box(random.Point(100.0f), 0.5f, 0.5f), i);
    }
    const float32 inserted = tree.GetAreaRatio();
    tree.RebuildBottomUp();
    EXPECT_LT(inserted, 1.5f * tree.GetAreaRatio());
}

TEST(Tree, ShiftsWithItsOrigin)
{
    b2DynamicTree tree;
    const int32 id = tree.CreateProxyExact(Box(b2Vec2(100.0f, 50.0f), 1.0f, 1.0f), 0);
    tree.CreateProxyExact(Box(b2Vec2(120.0f, 50.0f), 1.0f, 1.0f), 1);
    tree.ShiftOrigin(b2Vec2(100.0f, 50.0f));
    EXPECT_EQ(tree.GetFatAABB(id).lowerBound, b2Vec2(-1.0f, -1.0f));
    EXPECT_EQ(Invalid(tree), "");
    Collector collector;
    tree.Query(&collector, Box(b2Vec2(20.0f, 0.0f), 0.1f, 0.1f));
    EXPECT_EQ(collector.found.size(), 1u);
}

TEST(Tree, StopsAQueryAndARayOnRequest)
{
    b2DynamicTree tree;
    for (int32 i = 0; i < 10; ++i)
    {
        tree.CreateProxyExact(Box(b2Vec2(static_cast<float>(i), 0.0f), 1.0f, 1.0f), i);
    }
    int visited = 0;
    tree.ForEachOverlap(Box(b2Vec2_zero, 20.0f, 20.0f),
                        [&visited](int32) { return ++visited < 3; });
    EXPECT_EQ(visited, 3);

    struct Once
    {
        float32 RayCastCallback(const b2RayCastInput&, int32)
        {
            ++calls;
            return 0.0f;
        }
        int calls = 0;
    } once;
    tree.RayCast(&once, {{-5.0f, 0.0f}, {20.0f, 0.0f}, 1.0f});
    EXPECT_EQ(once.calls, 1);
}

TEST(Tree, ReturnsNothingWhenEmpty)
{
    b2DynamicTree tree;
    Collector collector;
    tree.Query(&collector, Box(b2Vec2_zero, 1.0f, 1.0f));
    tree.RayCast(&collector, {{0.0f, 0.0f}, {1.0f, 0.0f}, 1.0f});
    EXPECT_EQ(collector.calls, 0);
    EXPECT_EQ(tree.GetHeight(), 0);
    EXPECT_EQ(tree.GetMaxBalance(), 0);
    EXPECT_EQ(tree.GetAreaRatio(), 0.0f);
    tree.RebuildBottomUp();
    tree.ShiftOrigin(b2Vec2(1.0f, 1.0f));
    tree.Validate();
    EXPECT_EQ(Invalid(tree), "");
}

TEST(BoxQuery, OverlapsWhatTestOverlapDoes)
{
    // Every order of equal, smaller and larger bounds, of both signs, and what is not a number.
    const float values[] = {
        -1e30f, -1.0f, -0.0f, 0.0f, 1.0f, b2_maxFloat, std::numeric_limits<float>::quiet_NaN()};
    std::vector<b2AABB> boxes;
    for (const float left : values)
    {
        for (const float right : values)
        {
            for (const float bottom : values)
            {
                for (const float top : values)
                {
                    boxes.push_back({{left, bottom}, {right, top}});
                }
            }
        }
    }
    int different = 0;
    int overlaps = 0;
    for (const b2AABB& one : boxes)
    {
        const box2d::BoxQuery query(one);
        for (const b2AABB& another : boxes)
        {
            different += query.Overlaps(another) != b2TestOverlap(one, another);
            overlaps += query.Overlaps(another);
        }
    }
    EXPECT_EQ(different, 0);
    EXPECT_GT(overlaps, 1000);
}
