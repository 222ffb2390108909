// SPDX-License-Identifier: MIT
#include "SceneFileRound.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>

/// The function that libFuzzer calls with its inputs, and the mutator that makes them.
namespace
{

/// About the format's limits and the engine's tolerances.
constexpr const char* kNumbers[] = {
    "0",    "1",     "-1",     "2",   "3",          "0.5",        "-0.0",         "1e-45",
    "1e-7", "0.005", "0.0051", "0.1", "3.14159265", "6.28318531", "16777217",     "1e6",
    "-1e6", "9e5",   "1e12",   "1e9", "1e24",       "1e25",       "\"3F000000\"", "\"49742400\""};

bool IsOfNumber(char c)
{
    return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' || c == 'e' || c == 'E';
}

/// Puts another number in the place of one of the text's, for bytes changed at random rarely make
/// one that means something. False when there is no number or no room.
bool ChangeNumber(std::string& text, std::size_t maximum, std::mt19937& random)
{
    const std::size_t from = text.find_first_of("-0123456789", random() % (text.size() + 1));
    if (from == std::string::npos)
    {
        return false;
    }
    std::size_t end = from;
    while (end < text.size() && IsOfNumber(text[end]))
    {
        ++end;
    }
    text.replace(from, end - from, kNumbers[random() % std::size(kNumbers)]);
    return text.size() <= maximum;
}

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximum);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maximum, unsigned seed)
{
    std::mt19937 random(seed);
    std::string text(reinterpret_cast<const char*>(data), size);
    if (random() % 2 == 0 && ChangeNumber(text, maximum, random))
    {
        std::copy(text.begin(), text.end(), data);
        return text.size();
    }
    return LLVMFuzzerMutate(data, size, maximum);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string why = fuzz::WhyWrong(std::string(reinterpret_cast<const char*>(data), size));
    if (!why.empty())
    {
        std::fprintf(stderr, "%s\n", why.c_str());
        std::abort();
    }
    return 0;
}
