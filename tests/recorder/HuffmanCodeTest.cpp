// SPDX-License-Identifier: MIT
#include <HuffmanCode.h>

#include <gmock/gmock.h>

#include <numeric>

namespace
{

using namespace boxreel;
using testing::Each;
using testing::ElementsAre;
using testing::Le;

/// Returns the share of all words that the code uses, in units of 2^-16; 65536 if it is complete.
unsigned UsedOf(const HuffmanCode& code)
{
    return std::accumulate(
        code.lengths.begin(), code.lengths.end(), 0u,
        [](unsigned sum, unsigned length) { return sum + (length > 0 ? 65536u >> length : 0u); });
}

TEST(HuffmanCode, GivesRareSymbolsLongWords)
{
    const HuffmanCode code = MakeHuffmanCode({1, 0, 2, 4, 8}, 15);
    EXPECT_THAT(code.lengths, ElementsAre(3, 0, 3, 2, 1));
}

TEST(HuffmanCode, NumbersWordsAsInTheExampleOfTheFormat)
{
    // RFC 1951, 3.2.2: lengths 3, 3, 3, 3, 3, 2, 4, 4 give 010 to 110, 00, 1110 and 1111.
    const HuffmanCode code = MakeHuffmanCode({10, 10, 10, 10, 10, 20, 5, 5}, 15);
    EXPECT_THAT(code.lengths, ElementsAre(3, 3, 3, 3, 3, 2, 4, 4));
    EXPECT_THAT(code.words, ElementsAre(0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111));
}

TEST(HuffmanCode, StaysWithinTheLimit)
{
    std::vector<std::uint32_t> counts = {1, 1};
    while (counts.size() < 40)
    {
        counts.push_back(counts[counts.size() - 1] + counts[counts.size() - 2]); // the deepest tree
    }
    for (const int limit : {7, 15})
    {
        const HuffmanCode code = MakeHuffmanCode(counts, limit);
        EXPECT_THAT(code.lengths, Each(Le(limit)));
        EXPECT_EQ(UsedOf(code), 65536u);
    }
}

TEST(HuffmanCode, HasTwoWordsForOneSymbolOrNone)
{
    EXPECT_THAT(MakeHuffmanCode({0, 0, 7}, 15).lengths, ElementsAre(1, 0, 1));
    EXPECT_THAT(MakeHuffmanCode({0, 0, 0}, 15).lengths, ElementsAre(1, 1, 0));
}

} // namespace
