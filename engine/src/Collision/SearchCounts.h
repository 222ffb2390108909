// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2TimeOfImpact.h>

/// Counts of distance and impact searches. A search counts into an object of its caller, which adds
/// the counts to the public numbers afterwards (b2_gjkCalls, b2_toiCalls and others). Threads
/// therefore share no counters while they search, and a step without searches has no cost.
namespace box2d
{

struct SearchCounts
{
    int32 gjkCalls = 0, gjkIters = 0, gjkMaxIters = 0;
    int32 toiCalls = 0, toiIters = 0, toiMaxIters = 0;
    int32 toiRootIters = 0, toiMaxRootIters = 0;
    float32 toiTime = 0.0f, toiMaxTime = 0.0f; ///< [ms]

    void AddDistance(int32 iterations);
    void AddAdvance(int32 rootIterations);
    void Add(const SearchCounts& other);
    /// Adds the counts to the public numbers. Thread-safe.
    void Publish() const;
};

inline void SearchCounts::AddDistance(int32 iterations)
{
    ++gjkCalls;
    gjkIters += iterations;
    gjkMaxIters = b2Max(gjkMaxIters, iterations);
}

inline void SearchCounts::AddAdvance(int32 rootIterations)
{
    toiRootIters += rootIterations;
    toiMaxRootIters = b2Max(toiMaxRootIters, rootIterations);
}

/// Calls b2TimeOfImpact and counts into `counts`, with its time if `isTimed`.
b2TOIOutput FindImpact(const b2TOIInput& input, bool isTimed, SearchCounts& counts);

} // namespace box2d
