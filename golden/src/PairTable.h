// SPDX-License-Identifier: MIT
#pragma once

#include "OkLab.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

/// A cache of which pairs of pixels are over the tolerance, because drawings have few colours. Used
/// by MarkDifferences, one per comparison. Tested by PixelMarksTest.
namespace boxreel
{

class PairTable
{
public:
    explicit PairTable(double tolerance) : m_tolerance(tolerance) {}

    /// Looks up two different pixels, stored as bytes in memory: 1 over, 0 not, larger if unknown.
    /// `entries` is a table.
    static std::uint64_t Find(const std::uint64_t* entries, std::uint32_t p, std::uint32_t q)
    {
        const std::uint64_t product = Product(p, q);
        return entries[product >> (64 - kBits)] ^ product << kBits;
    }
    const std::uint64_t* Entries() const { return m_entries.data(); }

    /// Computes and stores the result.
    bool IsOver(std::uint32_t p, std::uint32_t q)
    {
        const std::uint64_t answer = Find(Entries(), p, q);
        return answer > 1 ? Keep(p, q, Compute(p, q)) : answer == 1;
    }

    /// Same as above, for the first `count` of four pairs.
    std::array<bool, kLanes> AreOver(Words p, Words q, int count);

    double LargestDistance() const { return m_largest; } ///< over all pairs

private:
    static constexpr int kBits = 15; ///< 256 kB, fits in the L2 cache
    /// Only bit 0 of an entry's low bits is used: true if the pair is over.
    static constexpr std::uint64_t kNone = 2;

    // Multiplication by an odd number (2^64 divided by the golden ratio) is bijective and mixes.
    // The top bits select an entry; the others are stored in it as the key.
    static std::uint64_t Product(std::uint32_t p, std::uint32_t q)
    {
        return (std::uint64_t(p) << 32 | q) * 0x9e3779b97f4a7c15u;
    }

    bool Keep(std::uint32_t p, std::uint32_t q, bool isOver)
    {
        const std::uint64_t product = Product(p, q);
        m_entries[product >> (64 - kBits)] = product << kBits | std::uint64_t(isOver);
        return isOver;
    }

    bool Compute(std::uint32_t p, std::uint32_t q)
    {
        std::uint8_t bytes[8];
        std::memcpy(bytes, &p, 4);
        std::memcpy(bytes + 4, &q, 4);
        const double distance = PixelDistance(bytes, bytes + 4);
        m_largest = std::max(m_largest, distance);
        return distance > m_tolerance || m_tolerance <= 0.0;
    }

    double m_tolerance;
    double m_largest = 0.0;
    std::vector<std::uint64_t> m_entries =
        std::vector<std::uint64_t>(std::size_t(1) << kBits, kNone);
};

inline std::array<bool, kLanes> PairTable::AreOver(Words p, Words q, int count)
{
    const Floats distances = NearlyPixelDistance(p, q);
    std::array<bool, kLanes> areOver{};
    for (int i = 0; i < count; ++i)
    {
        const double distance = distances[i];
        const bool isClear = std::abs(distance - m_tolerance) > kNearly || m_tolerance <= 0.0;
        areOver[std::size_t(i)] = Keep(p[i], q[i],
                                       isClear && distance < m_largest - kNearly
                                           ? distance > m_tolerance || m_tolerance <= 0.0
                                           : Compute(p[i], q[i]));
    }
    return areOver;
}

} // namespace boxreel
