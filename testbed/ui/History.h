// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace boxreel
{

/// The last values of something, with the mean and the largest since the beginning.
class History
{
public:
    static constexpr std::size_t kLength = 240; ///< four seconds at 60 Hz

    void Add(float value)
    {
        m_values[m_next] = value;
        m_next = (m_next + 1) % kLength;
        ++m_count;
        m_sum += double(value);
        m_largest = m_count == 1 ? value : std::max(m_largest, value);
    }
    void Clear() { *this = History(); }

    bool IsEmpty() const { return m_count == 0; }
    /// Returns the number of stored values.
    std::size_t Count() const { return std::min(m_count, kLength); }
    float Last() const { return m_values[(m_next + kLength - 1) % kLength]; }
    float Mean() const { return m_count == 0 ? 0.0f : float(m_sum / double(m_count)); }
    float Largest() const { return m_largest; }
    /// Returns the values as a ring buffer with the oldest at Oldest(). Unused entries are zero.
    const std::array<float, kLength>& Values() const { return m_values; }
    std::size_t Oldest() const { return m_next; }

private:
    std::array<float, kLength> m_values{};
    std::size_t m_next = 0;
    std::size_t m_count = 0;
    double m_sum = 0.0;
    float m_largest = 0.0f;
};

} // namespace boxreel
