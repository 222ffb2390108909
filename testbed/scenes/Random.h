// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <cstdint>

namespace boxreel
{

/// Random numbers for scenes: the same seed gives the same bits on every machine and compiler,
/// which the standard library's distributions do not promise. Used by scenes only; not for secrets.
///
/// SplitMix64: a counter in steps of the golden ratio, scrambled by two multiply-xorshift rounds.
/// G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014; the
/// multipliers are D. Stafford's variant 13, as the authors recommend.
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_counter(seed) {}

    std::uint64_t Next()
    {
        m_counter += 0x9E3779B97F4A7C15u;
        std::uint64_t bits = m_counter;
        bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
        bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
        return bits ^ (bits >> 31);
    }

    /// Evenly spread over [low, high). 24 bits are what a float holds, so the fraction is exact.
    float32 Between(float32 low, float32 high)
    {
        const float32 fraction = static_cast<float32>(Next() >> 40) * (1.0f / 16777216.0f);
        return low + (high - low) * fraction;
    }

    /// One of 0, 1, …, count - 1; count is at least 1. The bias of the high-bits product is below
    /// count / 2^32, far under what a scene could show.
    std::int32_t Below(std::int32_t count)
    {
        const std::uint64_t scaled = (Next() >> 32) * static_cast<std::uint64_t>(count);
        return static_cast<std::int32_t>(scaled >> 32);
    }

    /// All of its state, for SceneState.
    std::uint64_t& Counter() { return m_counter; }

private:
    std::uint64_t m_counter;
};

} // namespace boxreel
