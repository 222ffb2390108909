// SPDX-License-Identifier: MIT
#include "WorldCalls.h"
#include "../base/ReadBytes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <vector>

/// Thousands of calls of the public interface in random order. The invariants of the world are
/// checked after each. Also the inputs that the fuzzer kept because they reached new code.
namespace
{

using Bytes = std::vector<std::uint8_t>;

void Replay(const Bytes& bytes)
{
    fuzz::WorldCalls calls(bytes);
    for (int call = 0; !calls.Done(); ++call)
    {
        const char* name = calls.Call();
        const std::string why = calls.WhyBroken();
        ASSERT_EQ(why, "") << "call " << call << ": " << name;
    }
}

/// Tame when `first` is even, wild when it is odd.
Bytes RandomBytes(unsigned seed, std::uint8_t first)
{
    std::mt19937 random(seed);
    Bytes bytes(6000);
    for (std::uint8_t& byte : bytes)
    {
        byte = std::uint8_t(random());
    }
    bytes[0] = first;
    return bytes;
}

TEST(RandomCalls, KeepTheInvariantsOfTheWorld)
{
    for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
    {
        SCOPED_TRACE(seed);
        Replay(RandomBytes(seed, 0));
    }
}

TEST(RandomCalls, KeepTheWorldFiniteWithAnyNumbersAndCallbacks)
{
#if BOXREEL_ASSERTS
    GTEST_SKIP() << "Asserts are on: the first wild call would end the program with its sentence.";
#endif
    for (unsigned seed = 1; seed <= 40 && !HasFailure(); ++seed)
    {
        SCOPED_TRACE(seed);
        Replay(RandomBytes(seed, 1));
    }
}

TEST(Corpus, IsReplayedWithoutAFinding)
{
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(BOXREEL_CORPUS))
    {
        SCOPED_TRACE(entry.path().filename().string());
        const std::string bytes = ReadBytes(entry.path());
        Replay(Bytes(bytes.begin(), bytes.end()));
        ++count;
    }
    EXPECT_GT(count, 50);
}

} // namespace
