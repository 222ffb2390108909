// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2TimeOfImpact.h>

/// Counts of searches for distances and impacts. A search counts into an object of its caller, who
/// adds it to the public numbers (b2_gjkCalls, b2_toiCalls and the others) when it is done. So
/// threads share nothing while they search, and a step without searches does nothing at all.
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
    /// Adds it to the public numbers. Threads may do this at the same time.
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

/// b2TimeOfImpact that counts into `counts`, with its time when `isTimed`.
b2TOIOutput FindImpact(const b2TOIInput& input, bool isTimed, SearchCounts& counts);

} // namespace box2d
