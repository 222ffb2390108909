// SPDX-License-Identifier: MIT
#include "Predictor.h"

#include <algorithm>
#include <cstdlib>

namespace boxreel
{

void PutVarint(std::string& bytes, std::uint64_t number)
{
    for (; number >= 0x80; number >>= 7)
    {
        bytes += char(number | 0x80);
    }
    bytes += char(number);
}

void Column::Put(std::int64_t difference)
{
    // 0, -1, 1, -2, … become 0, 1, 2, 3, …
    std::uint64_t rest = (std::uint64_t(difference) << 1) ^ std::uint64_t(difference >> 63);
    constexpr std::uint64_t kFirstLarge = 0xf8; // behind it the number of bytes, 1 to 8
    if (rest < kFirstLarge)
    {
        small += char(rest);
        return;
    }
    int count = 0;
    for (; rest > 0; rest >>= 8, ++count)
    {
        large += char(rest);
    }
    small += char(kFirstLarge + std::uint64_t(count) - 1);
}

std::array<std::int64_t, Predictor::kRules> Predictor::Guesses() const
{
    const auto [a, b, c] = m_last;
    return {a, 2 * a - b, 3 * (a - b) + c};
}

std::int64_t Predictor::Guess() const
{
    const auto known = m_errors.begin() + std::ptrdiff_t(m_count);
    const auto best = std::min_element(m_errors.begin(), known);
    return Guesses()[std::size_t(best - m_errors.begin())];
}

void Predictor::Add(std::int64_t number)
{
    const auto guesses = Guesses();
    for (std::size_t rule = 0; rule < m_count; ++rule)
    {
        // Slower decay keeps a rule too long after an impact, faster follows the noise.
        m_errors[rule] += std::abs(number - guesses[rule]) - m_errors[rule] / 4;
    }
    m_last = {number, m_last[0], m_last[1]};
    m_count = std::min(m_count + 1, kRules);
}

} // namespace boxreel
