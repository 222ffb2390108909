// SPDX-License-Identifier: MIT
#include <Common/ThreadPool.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

/// Loops that several threads share.
namespace
{

using box2d::ParallelFor;
using box2d::ThreadPool;

std::vector<int> TimesDone(ThreadPool* pool, int32 count, int32 grain)
{
    std::vector<std::atomic<int>> times(std::size_t(count) + 1); // never empty
    ParallelFor(pool, count, grain, [&](int32 begin, int32 end) {
        for (int32 i = begin; i < end; ++i)
        {
            times[std::size_t(i)].fetch_add(1, std::memory_order_relaxed);
        }
    });
    return std::vector<int>(times.begin(), times.end() - 1);
}

TEST(ThreadPool, DoesEveryItemOnce)
{
    for (const int32 threads : {1, 2, 3, 8})
    {
        ThreadPool pool(threads);
        EXPECT_EQ(pool.Count(), threads);
        for (const int32 count : {0, 1, 2, 7, 64, 1000, 10007})
        {
            for (const int32 grain : {1, 8, 5000})
            {
                EXPECT_EQ(TimesDone(&pool, count, grain), std::vector<int>(std::size_t(count), 1))
                    << threads << " threads, " << count << " items by " << grain;
            }
        }
    }
}

TEST(ThreadPool, DoesEveryItemOnceWithoutThreads)
{
    EXPECT_EQ(TimesDone(nullptr, 100, 1), std::vector<int>(100, 1));
}

TEST(ThreadPool, FinishesALoopBeforeTheNextBegins)
{
    ThreadPool pool(4);
    pool.Begin();
    std::vector<int> values(257, 0); // written without atomics: each loop sees the one before
    for (int round = 0; round < 3000; ++round)
    {
        pool.ParallelFor(257, 1, [&](int32 begin, int32 end) {
            for (int32 i = begin; i < end; ++i)
            {
                values[std::size_t(i)] += int(i);
            }
        });
    }
    pool.End();
    for (int i = 0; i < 257; ++i)
    {
        EXPECT_EQ(values[std::size_t(i)], 3000 * i);
    }
}

TEST(ThreadPool, WakesThreadsThatHaveGoneToSleep)
{
    ThreadPool pool(2);
    for (int round = 0; round < 3; ++round)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        // Both threads have to be in the loop at once for it to end.
        std::atomic<int> inside = 0;
        pool.ParallelFor(2, 1, [&](int32, int32) {
            inside.fetch_add(1);
            while (inside.load() < 2)
            {
                std::this_thread::yield();
            }
        });
        EXPECT_EQ(inside.load(), 2);
    }
}

TEST(ThreadPool, EndsWhetherItsThreadsSleepOrWait)
{
    for (int round = 0; round < 50; ++round)
    {
        ThreadPool pool(3);
        if (round % 2 == 0)
        {
            pool.Begin();
        }
        if (round % 3 == 0)
        {
            TimesDone(&pool, 100, 1);
        }
    }
}

} // namespace
