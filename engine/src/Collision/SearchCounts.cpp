// SPDX-License-Identifier: MIT
#include "SearchCounts.h"

#include <atomic>

// Plain integers, because the program reads and sets them.
int32 b2_gjkCalls = 0;
int32 b2_gjkIters = 0;
int32 b2_gjkMaxIters = 0;
int32 b2_toiCalls = 0;
int32 b2_toiIters = 0;
int32 b2_toiMaxIters = 0;
int32 b2_toiRootIters = 0;
int32 b2_toiMaxRootIters = 0;
float32 b2_toiTime = 0.0f;
float32 b2_toiMaxTime = 0.0f;

namespace box2d
{
namespace
{

// Separate atomic loads and stores, as fast as plain ones. Worlds that different threads step may
// lose counts, but there is no data race.

/// Unsigned arithmetic wraps around; signed overflow is undefined.
void AddTo(int32& total, int32 value)
{
    const std::atomic_ref<int32> number(total);
    const auto sum = static_cast<std::uint32_t>(number.load(std::memory_order_relaxed)) +
                     static_cast<std::uint32_t>(value);
    number.store(static_cast<int32>(sum), std::memory_order_relaxed);
}

void AddTo(float32& total, float32 value)
{
    const std::atomic_ref<float32> number(total);
    number.store(number.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
}

template <class T>
void RaiseTo(T& maximum, T value)
{
    const std::atomic_ref<T> number(maximum);
    if (number.load(std::memory_order_relaxed) < value)
    {
        number.store(value, std::memory_order_relaxed);
    }
}

} // namespace

void SearchCounts::Add(const SearchCounts& other)
{
    gjkCalls += other.gjkCalls;
    gjkIters += other.gjkIters;
    gjkMaxIters = b2Max(gjkMaxIters, other.gjkMaxIters);
    toiCalls += other.toiCalls;
    toiIters += other.toiIters;
    toiMaxIters = b2Max(toiMaxIters, other.toiMaxIters);
    toiRootIters += other.toiRootIters;
    toiMaxRootIters = b2Max(toiMaxRootIters, other.toiMaxRootIters);
    toiTime += other.toiTime;
    toiMaxTime = b2Max(toiMaxTime, other.toiMaxTime);
}

void SearchCounts::Publish() const
{
    AddTo(b2_gjkCalls, gjkCalls);
    AddTo(b2_gjkIters, gjkIters);
    RaiseTo(b2_gjkMaxIters, gjkMaxIters);
    if (toiCalls == 0)
    {
        return;
    }
    AddTo(b2_toiCalls, toiCalls);
    AddTo(b2_toiIters, toiIters);
    RaiseTo(b2_toiMaxIters, toiMaxIters);
    AddTo(b2_toiRootIters, toiRootIters);
    RaiseTo(b2_toiMaxRootIters, toiMaxRootIters);
    AddTo(b2_toiTime, toiTime);
    RaiseTo(b2_toiMaxTime, toiMaxTime);
}

} // namespace box2d
