// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

/// Whole numbers that change from step to step, as few bytes. decode.js has the same arithmetic.
namespace boxreel
{

/// Appends 7 bits per byte, low bits first; the top bit says that more follow.
void PutVarint(std::string& bytes, std::uint64_t number);

/// Differences of predictions. Small ones are one byte of `small`; of larger ones `small` has the
/// number of bytes, and `large` these bytes. Apart from each other both compress better.
struct Column
{
    std::string small;
    std::string large;

    void Put(std::int64_t difference);
};

/// Guesses a number from those before: that it stays, moves on at its speed, or at its
/// acceleration. Takes the rule that was best lately.
class Predictor
{
public:
    bool IsEmpty() const { return m_count == 0; }
    std::int64_t Guess() const; ///< only if it is not empty
    void Add(std::int64_t number);

private:
    static constexpr std::size_t kRules = 3;
    std::array<std::int64_t, kRules> Guesses() const;

    std::array<std::int64_t, kRules> m_last{};   // the latest first
    std::array<std::int64_t, kRules> m_errors{}; // of each rule, decaying sums
    std::size_t m_count = 0;                     // of numbers known, at most kRules
};

} // namespace boxreel
