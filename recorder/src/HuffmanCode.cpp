// SPDX-License-Identifier: MIT
#include "HuffmanCode.h"

#include <algorithm>
#include <cstddef>

namespace boxreel
{

namespace
{

/// A symbol, or two joined nodes.
struct Node
{
    std::uint64_t count;
    int parent;
};

/// Returns the lengths without a limit. `order`: the symbols that occur, rarest first. Two queues
/// (van Leeuwen, "On the construction of Huffman trees", 1976): leaves, and joined nodes, whose
/// counts never fall.
std::vector<int> DepthsOf(const std::vector<std::uint64_t>& sorted)
{
    const std::size_t leaves = sorted.size();
    std::vector<Node> nodes;
    nodes.reserve(2 * leaves);
    for (const std::uint64_t count : sorted)
    {
        nodes.push_back({count, -1});
    }
    std::size_t leaf = 0, joined = leaves;
    const auto takeRarest = [&]() -> std::size_t {
        const bool isLeaf =
            joined == nodes.size() || (leaf < leaves && nodes[leaf].count <= nodes[joined].count);
        return isLeaf ? leaf++ : joined++;
    };
    while (nodes.size() < 2 * leaves - 1)
    {
        const std::size_t a = takeRarest();
        const std::size_t b = takeRarest();
        nodes[a].parent = nodes[b].parent = int(nodes.size());
        nodes.push_back({nodes[a].count + nodes[b].count, -1});
    }
    std::vector<int> depths(nodes.size());
    for (std::size_t i = nodes.size() - 1; i-- > 0;)
    {
        depths[i] = depths[std::size_t(nodes[i].parent)] + 1;
    }
    depths.resize(leaves);
    return depths;
}

/// Numbers the codes of each length in the order of the symbols (RFC 1951, 3.2.2), and turns them
/// round, because a Deflate stream begins with the lowest bit.
void Number(HuffmanCode& code, int maxBits)
{
    std::uint32_t next = 0;
    for (int length = 1; length <= maxBits; ++length)
    {
        next <<= 1;
        for (std::size_t i = 0; i < code.lengths.size(); ++i)
        {
            if (code.lengths[i] != length)
            {
                continue;
            }
            std::uint32_t reversed = 0;
            for (int bit = 0; bit < length; ++bit)
            {
                reversed |= (next >> bit & 1u) << (length - 1 - bit);
            }
            code.words[i] = std::uint16_t(reversed);
            ++next;
        }
    }
}

} // namespace

HuffmanCode MakeHuffmanCode(const std::vector<std::uint32_t>& counts, int maxBits)
{
    HuffmanCode code;
    code.lengths.assign(counts.size(), 0);
    code.words.assign(counts.size(), 0);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < counts.size(); ++i)
    {
        if (counts[i] > 0)
        {
            order.push_back(i);
        }
    }
    // Some decoders refuse a code of fewer than two symbols.
    for (std::size_t i = 0; order.size() < 2; ++i)
    {
        if (std::find(order.begin(), order.end(), i) == order.end())
        {
            order.push_back(i);
        }
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return counts[a] < counts[b]; });
    std::vector<std::uint64_t> sorted;
    for (const std::size_t symbol : order)
    {
        sorted.push_back(std::max(counts[symbol], 1u));
    }
    std::vector<int> depths = DepthsOf(sorted);
    while (depths.front() > maxBits) // the rarest is the deepest
    {
        // Counts closer to each other make a tree that is less deep; equal ones the flattest.
        for (std::uint64_t& count : sorted)
        {
            count = (count + 1) / 2;
        }
        depths = DepthsOf(sorted);
    }
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        code.lengths[order[i]] = std::uint8_t(depths[i]);
    }
    Number(code, maxBits);
    return code;
}

} // namespace boxreel
