// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

/// Threads that execute loops together with the calling thread. They never call the program and
/// never allocate. The result of a loop must not depend on the assignment of its parts, so that it
/// is the same for any number of threads.
namespace box2d
{

class ThreadPool
{
public:
    /// `count` includes the calling thread, 1 to kMaxThreads.
    explicit ThreadPool(int32 count);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    static constexpr int32 kMaxThreads = 64;
    int32 Count() const { return m_count; }

    /// Calls body(begin, end) for parts of 0 to `count` on all threads, and returns when all are
    /// done. A part has at least `grain` items. Not reentrant.
    template <class Body>
    void ParallelFor(int32 count, int32 grain, const Body& body)
    {
        Run(count, grain, &body, [](const void* context, int32 begin, int32 end) {
            (*static_cast<const Body*>(context))(begin, end);
        });
    }

    /// Between Begin and End the threads poll instead of sleeping.
    void Begin();
    void End();

private:
    /// Distance of data written by different threads [bytes]: processors prefetch cache lines in
    /// pairs.
    static constexpr std::size_t kApart = 128;

    typedef void (*Function)(const void* context, int32 begin, int32 end);

    /// The initial share of a thread; the others help when they have finished their own.
    struct alignas(kApart) Share
    {
        /// The loop's number in the upper half, the next item in the lower. A late thread cannot
        /// take an item of a newer loop.
        std::atomic<std::uint64_t> next{0};
        std::atomic<int32> end{0};
    };

    void Run(int32 count, int32 grain, const void* context, Function function);
    void Work(int32 self, std::uint32_t loop);
    int32 WorkOn(Share& share, std::uint32_t loop);
    void Main(int32 self);
    std::uint32_t AwaitLoop(std::uint32_t last);

    int32 m_count;
    std::unique_ptr<Share[]> m_shares;
    std::vector<std::thread> m_threads;

    // The current loop, in one cache line.
    alignas(kApart) std::atomic<std::uint32_t> m_loop{0}; ///< its number
    std::atomic<int32> m_grain{1};
    std::atomic<Function> m_function{nullptr};
    std::atomic<const void*> m_context{nullptr};
    std::atomic<int32> m_sleeping{0};
    std::atomic<bool> m_ready{false}; ///< between Begin and End
    std::atomic<bool> m_stop{false};
    alignas(kApart) std::atomic<int32> m_left{0}; ///< remaining items
};

/// On the pool's threads, or on this one where there is no pool or little to do.
template <class Body>
void ParallelFor(ThreadPool* pool, int32 count, int32 grain, const Body& body)
{
    if (pool == nullptr || count <= grain)
    {
        if (count > 0)
        {
            body(int32(0), count);
        }
        return;
    }
    pool->ParallelFor(count, grain, body);
}

} // namespace box2d
