// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

/// Turns bytes into choices, so a fuzzer, a seed or a stored file can select the calls. After the
/// last byte every choice is the first possibility, and Done returns true.
namespace fuzz
{

class Choices
{
public:
    /// `wild`: numbers may also be infinite, not a number, or absurdly large.
    Choices(std::span<const std::uint8_t> bytes, bool wild) : m_bytes(bytes), m_wild(wild) {}

    bool Done() const { return m_next >= m_bytes.size(); }
    bool Wild() const { return m_wild; }

    /// From low to high, both included; at most 256 values apart.
    int Number(int low, int high) { return low + Byte() % (high - low + 1); }
    bool Flag() { return Number(0, 1) == 1; }
    /// Once in `times`.
    bool Rarely(int times) { return Number(1, times) == times; }

    float32 Real(float32 low, float32 high)
    {
        const int coarse = Byte();
        if (m_wild && coarse > 247)
        {
            return WildNumber(coarse - 248);
        }
        return low + (high - low) * float32(256 * coarse + Byte()) / 65535.0f;
    }

    b2Vec2 Vector(float32 reach)
    {
        const float32 x = Real(-reach, reach);
        return b2Vec2(x, Real(-reach, reach));
    }

    /// Within the few metres where everything happens.
    b2Vec2 Place()
    {
        const float32 x = Real(-4.0f, 4.0f);
        return b2Vec2(x, Real(-1.0f, 5.0f));
    }

private:
    int Byte() { return Done() ? 0 : m_bytes[m_next++]; }

    static float32 WildNumber(int which)
    {
        using Limits = std::numeric_limits<float32>;
        const float32 numbers[8] = {Limits::quiet_NaN(),
                                    Limits::infinity(),
                                    -Limits::infinity(),
                                    Limits::max(),
                                    -1e30f,
                                    1e6f,
                                    Limits::denorm_min(),
                                    -0.0f};
        return numbers[which];
    }

    std::span<const std::uint8_t> m_bytes;
    std::size_t m_next = 0;
    bool m_wild;
};

} // namespace fuzz
