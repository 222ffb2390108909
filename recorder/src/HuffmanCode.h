// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

/// Prefix codes of least total length (Huffman, "A Method for the Construction of
/// Minimum-Redundancy Codes", 1952), as Deflate wants them: canonical and of limited length. Used
/// by PngStream.
namespace boxreel
{

struct HuffmanCode
{
    std::vector<std::uint8_t> lengths; ///< by symbol; 0: it does not occur
    std::vector<std::uint16_t> words;  ///< by symbol, the first bit lowest
};

/// Returns the code for symbols that occur so often. At least one bit, also for a single symbol or
/// for none, because a decoder wants a code. `maxBits`: 2^maxBits is at least twice the number of
/// symbols. Depends on nothing else, so the same counts give the same code everywhere.
HuffmanCode MakeHuffmanCode(const std::vector<std::uint32_t>& counts, int maxBits);

} // namespace boxreel
