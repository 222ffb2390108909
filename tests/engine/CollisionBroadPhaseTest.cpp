// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Collision/b2BroadPhase.h>

#include <gtest/gtest.h>

#include <set>
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
        told.emplace_back(pa->id, pb->id);
    }
    std::vector<std::pair<int32, int32>> told;
};

b2AABB RandomBox(Random& random)
{
    b2AABB box;
    box.lowerBound = random.Point(10.0f);
    box.upperBound = box.lowerBound + b2Vec2{random.Real(0.1f, 2.0f), random.Real(0.1f, 2.0f)};
    return box;
}
} // namespace

TEST(BroadPhase, TellsEveryPairOfMovedProxiesOnceAndInOrder)
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
        ASSERT_EQ(pairs.told,
                  (std::vector<std::pair<int32, int32>>(expected.begin(), expected.end())));
        ASSERT_EQ(broadPhase.GetProxyCount(), static_cast<int32>(proxies.size()));
        for (const auto& proxy : proxies)
        {
            proxy->hasMoved = false;
        }
        Pairs again;
        broadPhase.UpdatePairs(&again);
        ASSERT_TRUE(again.told.empty());
    }
    EXPECT_GT(broadPhase.GetTreeHeight(), 4);
    EXPECT_GT(broadPhase.GetTreeQuality(), 1.0f);
    EXPECT_GE(broadPhase.GetTreeBalance(), 0);
}
