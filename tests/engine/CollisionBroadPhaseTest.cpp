// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2BroadPhase.h>
#include <Box2D/Dynamics/b2Fixture.h>
#include <Dynamics/State/Proxies.h>

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace
{
struct Proxy
{
    int number;
    int32 id;
    b2AABB box;
    bool hasMoved;
};

struct Pairs
{
    void AddPair(void* a, void* b)
    {
        Proxy* pa = static_cast<Proxy*>(a);
        Proxy* pb = static_cast<Proxy*>(b);
        reported.emplace_back(pa->id, pb->id);
    }
    std::vector<std::pair<int32, int32>> reported;
};

b2AABB RandomBox(Random& random)
{
    b2AABB box;
    box.lowerBound = random.Point(10.0f);
    box.upperBound = box.lowerBound + b2Vec2{random.Real(0.1f, 2.0f), random.Real(0.1f, 2.0f)};
    return box;
}
} // namespace

TEST(BroadPhase, ReportsEveryPairOfMovedProxiesOnceAndInOrder)
{
    Random random(51);
    b2BroadPhase broadPhase;
    std::vector<std::unique_ptr<Proxy>> proxies;
    for (int round = 0; round < 300; ++round)
    {
        for (int k = 0; k < 5; ++k)
        {
            auto proxy = std::make_unique<Proxy>(Proxy{round, 0, RandomBox(random), true});
            proxy->id = broadPhase.CreateProxy(proxy->box, proxy.get());
            proxies.push_back(std::move(proxy));
        }
        for (int k = 0; k < 20; ++k)
        {
            Proxy& proxy = *proxies[static_cast<std::size_t>(
                random.Integer(0, static_cast<int32>(proxies.size()) - 1))];
            const b2Vec2 d = random.Point(0.2f);
            proxy.box.lowerBound += d;
            proxy.box.upperBound += d;
            const b2AABB before = broadPhase.GetFatAABB(proxy.id);
            broadPhase.MoveProxy(proxy.id, proxy.box, d);
            proxy.hasMoved = proxy.hasMoved || !before.Contains(proxy.box);
        }
        if (proxies.size() > 60)
        {
            for (int k = 0; k < 5; ++k)
            {
                const std::size_t which = static_cast<std::size_t>(
                    random.Integer(0, static_cast<int32>(proxies.size()) - 1));
                broadPhase.DestroyProxy(proxies[which]->id);
                proxies.erase(proxies.begin() + static_cast<std::ptrdiff_t>(which));
            }
        }
        if (round % 7 == 0)
        {
            broadPhase.TouchProxy(proxies[0]->id);
            proxies[0]->hasMoved = true;
        }

        std::set<std::pair<int32, int32>> expected;
        for (const auto& a : proxies)
        {
            for (const auto& b : proxies)
            {
                if (a->id < b->id && (a->hasMoved || b->hasMoved) &&
                    broadPhase.TestOverlap(a->id, b->id))
                {
                    expected.emplace(a->id, b->id);
                }
            }
        }
        Pairs pairs;
        broadPhase.UpdatePairs(&pairs);
        ASSERT_EQ(pairs.reported,
                  (std::vector<std::pair<int32, int32>>(expected.begin(), expected.end())));
        ASSERT_EQ(broadPhase.GetProxyCount(), static_cast<int32>(proxies.size()));
        for (const auto& proxy : proxies)
        {
            proxy->hasMoved = false;
        }
        Pairs again;
        broadPhase.UpdatePairs(&again);
        ASSERT_TRUE(again.reported.empty());
    }
    EXPECT_GT(broadPhase.GetTreeHeight(), 4);
    EXPECT_GT(broadPhase.GetTreeQuality(), 1.0f);
    EXPECT_GE(broadPhase.GetTreeBalance(), 0);
}

TEST(WorldProxies, ReportThePairsOfManyThatMoveTogether)
{
    Random random(53);
    std::vector<b2FixtureProxy> every(300);
    box2d::Proxies all;
    typedef std::set<std::pair<const b2FixtureProxy*, const b2FixtureProxy*>> Pairs;
    const auto inOrder = [](const b2FixtureProxy* a, const b2FixtureProxy* b) {
        return std::less<>()(a, b) ? std::pair(a, b) : std::pair(b, a);
    };
    for (std::size_t i = 0; i < every.size(); ++i)
    {
        every[i].aabb = RandomBox(random);
        every[i].proxyId =
            all.Create(every[i].aabb, static_cast<box2d::Mobility>(b2Min(i % 10, 2ul)), &every[i]);
    }
    const auto tell = [&] {
        Pairs reported;
        all.FindPairs(
            nullptr, [](const b2FixtureProxy*, box2d::Mobility) { return true; },
            [](int32, int32) { return false; },
            [&](const b2FixtureProxy* a, const b2FixtureProxy* b) {
                EXPECT_TRUE(reported.insert(inOrder(a, b)).second);
            });
        return reported;
    };
    tell();
    for (const std::size_t share : {1ul, 2ul, 5ul, 1ul, 1ul, 30ul, 2ul})
    {
        std::set<const b2FixtureProxy*> moved;
        const auto count = static_cast<int32>(every.size() / share);
        all.BeginMoves(count, share == 5 ? count : 0);
        for (std::size_t i = 0; i < every.size(); i += share)
        {
            every[i].aabb = RandomBox(random);
            all.Move(every[i].proxyId, every[i].aabb);
            moved.insert(&every[i]);
        }
        all.EndMoves();
        b2FixtureProxy& grown = every[2]; // a dynamic one
        grown.aabb.Combine(RandomBox(random));
        all.Grow(grown.proxyId, grown.aabb);
        moved.insert(&grown);
        Pairs expected;
        for (const b2FixtureProxy& a : every)
        {
            for (const b2FixtureProxy& b : every)
            {
                const bool dynamic =
                    box2d::Proxies::MobilityOf(a.proxyId) == box2d::Mobility::Dynamic ||
                    box2d::Proxies::MobilityOf(b.proxyId) == box2d::Mobility::Dynamic;
                if (&a != &b && dynamic && (moved.contains(&a) || moved.contains(&b)) &&
                    b2TestOverlap(a.aabb, b.aabb))
                {
                    expected.insert(inOrder(&a, &b));
                }
            }
        }
        ASSERT_GT(expected.size(), 20u);
        ASSERT_EQ(tell(), expected) << share;
        ASSERT_EQ(all.TreeOf(box2d::Mobility::Dynamic).WhyInvalid(), nullptr);
    }
}

TEST(WorldProxies, ReportTheSamePairsAfterTheStaticTreeIsRebuilt)
{
    Random random(52);
    std::vector<b2FixtureProxy> every(3200);
    const std::span<b2FixtureProxy> moving(every.begin(), 200);
    const std::span<b2FixtureProxy> fixed(every.begin() + 200, 3000);
    box2d::Proxies all;
    const auto pairs = [&all] {
        std::set<std::pair<const b2FixtureProxy*, const b2FixtureProxy*>> reported;
        const auto isKnown = [](int32, int32) { return false; };
        const auto isWanted = [](const b2FixtureProxy*, box2d::Mobility) { return true; };
        all.FindPairs(
            nullptr, isWanted, isKnown, [&](const b2FixtureProxy* a, const b2FixtureProxy* b) {
                const bool isFirst = std::less<>()(a, b); // either may have been the one that moved
                EXPECT_TRUE(reported.emplace(isFirst ? a : b, isFirst ? b : a).second);
            });
        return reported;
    };
    for (b2FixtureProxy& m : moving)
    {
        m.aabb = RandomBox(random);
        m.proxyId = all.Create(m.aabb, box2d::Mobility::Dynamic, &m);
    }
    pairs();

    const auto ratio = [&all] { return all.TreeOf(box2d::Mobility::Static).GetAreaRatio(); };
    int rebuilt = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i)
    {
        // In rows, for which insertion makes a poor tree.
        const b2Vec2 corner(0.2f * static_cast<float>(i % 100) - 10.0f,
                            0.6f * static_cast<float>(i / 100) - 10.0f);
        fixed[i].aabb.lowerBound = corner;
        fixed[i].aabb.upperBound = corner + b2Vec2(0.1f, 0.1f);
        fixed[i].proxyId = all.Create(fixed[i].aabb, box2d::Mobility::Static, &fixed[i]);
        if (i % 100 == 99)
        {
            const float32 before = ratio();
            for (const b2FixtureProxy& proxy : moving)
            {
                all.Touch(proxy.proxyId);
            }
            std::size_t expected = 0;
            const auto reported = pairs();
            for (const b2FixtureProxy& m : moving)
            {
                for (std::size_t k = 0; k <= i; ++k)
                {
                    expected += b2TestOverlap(m.aabb, fixed[k].aabb);
                    ASSERT_EQ(reported.contains({&m, &fixed[k]}),
                              b2TestOverlap(m.aabb, fixed[k].aabb));
                }
            }
            ASSERT_GT(expected, 0u);
            rebuilt += ratio() < before;
        }
    }
    EXPECT_EQ(all.TreeOf(box2d::Mobility::Static).WhyInvalid(), nullptr);
    // At 1000 and 2000: each time half of what there is was added since.
    EXPECT_EQ(rebuilt, 2);
}
