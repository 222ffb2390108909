// SPDX-License-Identifier: MIT
#pragma once

#include "OkLab.h"

#include <render/Frame.h>

#include <cstdint>
#include <cstring>
#include <vector>

/// What an edge that lies a fraction of a pixel elsewhere may change. Asked by Compare about single
/// pixels that differ; looks at the expected picture around them, never at the actual one.
namespace boxreel
{

/// Debug drawings have few colours, so the same pair of pixels comes again and again: distances are
/// kept in a small table, each pair at one fixed place. A hit has the bits that computing would
/// give.
class DistanceTable
{
public:
    /// Of two pixels' bytes as they lie in memory.
    double Get(std::uint32_t p, std::uint32_t q)
    {
        const std::uint64_t key = std::uint64_t(p) << 32 | q;
        // Multiplied by 2^64 over the golden ratio, the top bits mix all the others.
        Entry& entry = m_entries[key * 0x9e3779b97f4a7c15u >> (64 - kBits)];
        if (entry.key != key)
        {
            std::uint8_t bytes[8];
            std::memcpy(bytes, &p, 4);
            std::memcpy(bytes + 4, &q, 4);
            entry = {key, PixelDistance(bytes, bytes + 4)};
        }
        return entry.distance;
    }

private:
    static constexpr int kBits = 12;
    struct Entry
    {
        std::uint64_t key = 0; // of two equal pixels, at distance 0
        double distance = 0.0;
    };
    std::vector<Entry> m_entries = std::vector<Entry>(std::size_t(1) << kBits);
};

/// Whether `actual` may stand at (x, y), where the expected picture's pixel is `distance` from it,
/// if edges may lie `shift` pixels elsewhere.
bool EdgeExplains(const Frame& expected, int x, int y, const std::uint8_t* actual, double distance,
                  double tolerance, double shift, DistanceTable& table);

} // namespace boxreel
