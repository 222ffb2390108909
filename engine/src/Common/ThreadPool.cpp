// SPDX-License-Identifier: MIT
#include "ThreadPool.h"

namespace box2d
{

namespace
{

/// Number of polls before a waiting thread yields the processor.
constexpr int32 kEagerLooks = 200;

constexpr int32 kNoItem = INT32_MAX;

/// Number of parts of a thread's share, so that others can help with it.
constexpr int32 kPartsOfShare = 4;

void Relax(int32 looks)
{
    if (looks < kEagerLooks)
    {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
    }
    else
    {
        std::this_thread::yield();
    }
}

std::uint64_t Claim(std::uint32_t loop, int32 item)
{
    return std::uint64_t(loop) << 32 | std::uint32_t(item);
}

} // namespace

ThreadPool::ThreadPool(int32 count)
    : m_count(b2Clamp(count, 1, kMaxThreads)), m_shares(new Share[std::size_t(m_count)])
{
    for (int32 i = 1; i < m_count; ++i)
    {
        m_threads.emplace_back([this, i] { Main(i); });
    }
}

ThreadPool::~ThreadPool()
{
    m_stop.store(true);
    m_loop.fetch_add(1);
    m_loop.notify_all();
    for (std::thread& thread : m_threads)
    {
        thread.join();
    }
}

void ThreadPool::Begin()
{
    m_ready.store(true);
}

void ThreadPool::End()
{
    m_ready.store(false);
}

void ThreadPool::Run(int32 count, int32 grain, const void* context, Function function)
{
    const std::uint32_t loop = m_loop.load(std::memory_order_relaxed) + 1;
    m_left.store(count, std::memory_order_relaxed);
    m_function.store(function, std::memory_order_relaxed);
    m_context.store(context, std::memory_order_relaxed);
    m_grain.store(b2Max(grain, count / (kPartsOfShare * m_count)), std::memory_order_relaxed);
    for (int32 i = 0; i < m_count; ++i)
    {
        const auto begin = int32(std::int64_t(count) * i / m_count);
        const auto end = int32(std::int64_t(count) * (i + 1) / m_count);
        Share& share = m_shares[std::size_t(i)];
        // Closed while it changes, so that a late thread cannot take an item outside its loop. A
        // thread that sees the new end also sees the new loop.
        share.next.store(Claim(loop, kNoItem), std::memory_order_relaxed);
        share.end.store(end, std::memory_order_release);
        share.next.store(Claim(loop, begin), std::memory_order_release);
    }
    m_loop.store(loop); // sequentially consistent with m_sleeping
    if (m_sleeping.load() > 0)
    {
        m_loop.notify_all();
    }
    Work(0, loop);
    for (int32 looks = 0; m_left.load(std::memory_order_acquire) > 0; ++looks)
    {
        Relax(looks);
    }
}

void ThreadPool::Work(int32 self, std::uint32_t loop)
{
    int32 done = 0;
    for (int32 i = 0; i < m_count; ++i)
    {
        done += WorkOn(m_shares[std::size_t((self + i) % m_count)], loop);
    }
    if (done > 0)
    {
        m_left.fetch_sub(done, std::memory_order_release);
    }
}

/// Works on a share until it is empty or the loop ends. Returns the number of completed items.
int32 ThreadPool::WorkOn(Share& share, std::uint32_t loop)
{
    int32 done = 0;
    std::uint64_t claim = share.next.load(std::memory_order_acquire);
    while (true)
    {
        const auto begin = int32(std::uint32_t(claim));
        const int32 last = share.end.load(std::memory_order_acquire);
        if (std::uint32_t(claim >> 32) != loop || begin >= last)
        {
            return done;
        }
        // Read before the claim, which succeeds only while the loop lasts.
        const int32 end = b2Min(last, begin + m_grain.load(std::memory_order_relaxed));
        const Function function = m_function.load(std::memory_order_relaxed);
        const void* context = m_context.load(std::memory_order_relaxed);
        if (share.next.compare_exchange_weak(claim, Claim(loop, end), std::memory_order_acq_rel,
                                             std::memory_order_acquire))
        {
            function(context, begin, end);
            done += end - begin;
            claim = share.next.load(std::memory_order_acquire);
        }
    }
}

std::uint32_t ThreadPool::AwaitLoop(std::uint32_t last)
{
    for (int32 looks = 0; looks < kEagerLooks || m_ready.load(std::memory_order_relaxed); ++looks)
    {
        const std::uint32_t loop = m_loop.load(std::memory_order_acquire);
        if (loop != last)
        {
            return loop;
        }
        Relax(looks);
    }
    m_sleeping.fetch_add(1);
    m_loop.wait(last);
    m_sleeping.fetch_sub(1);
    return m_loop.load();
}

void ThreadPool::Main(int32 self)
{
    std::uint32_t loop = 0;
    while (true)
    {
        loop = AwaitLoop(loop);
        if (m_stop.load())
        {
            return;
        }
        Work(self, loop);
    }
}

} // namespace box2d
