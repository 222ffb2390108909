// SPDX-License-Identifier: MIT
#include "H264Bits.h"

#include <algorithm>
#include <bit>
#include <cassert>

namespace boxreel
{

std::uint32_t BitReader::Bits(int count)
{
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
    {
        const std::size_t byte = m_position / 8;
        m_hasFailed = m_hasFailed || byte >= m_bytes.size();
        const unsigned bit =
            byte < m_bytes.size() ? unsigned(m_bytes[byte]) >> (7 - m_position % 8) & 1u : 0u;
        value = value << 1 | bit;
        ++m_position;
    }
    return value;
}

std::uint32_t BitReader::Unsigned()
{
    int zeros = 0;
    while (!Flag())
    {
        if (++zeros > 31 || m_hasFailed)
        {
            m_hasFailed = true;
            return 0;
        }
    }
    return (1u << zeros) - 1 + Bits(zeros);
}

std::int32_t BitReader::Signed()
{
    const std::uint32_t code = Unsigned();
    const auto half = std::int32_t((code + 1) / 2);
    return code % 2 == 1 ? half : -half;
}

void BitWriter::Bits(std::uint32_t value, int count)
{
    for (int i = count - 1; i >= 0; --i)
    {
        if (m_free == 0)
        {
            m_bytes.push_back(0);
            m_free = 8;
        }
        --m_free;
        m_bytes.back() = std::uint8_t(m_bytes.back() | (value >> i & 1u) << m_free);
    }
}

void BitWriter::Unsigned(std::uint32_t value)
{
    const int bits = int(std::bit_width(value + 1));
    Bits(0, bits - 1);
    Bits(value + 1, bits);
}

void BitWriter::Signed(std::int32_t value)
{
    Unsigned(value > 0 ? std::uint32_t(2 * value - 1) : std::uint32_t(-2 * value));
}

void BitWriter::Copy(std::span<const std::uint8_t> from, std::size_t first, std::size_t end)
{
    for (; first < end && first % 8 != 0; ++first)
    {
        Bits(unsigned(from[first / 8]) >> (7 - first % 8) & 1u, 1);
    }
    if (m_free == 0 && first < end)
    {
        Append(from.subspan(first / 8, (end - first) / 8));
        first += (end - first) / 8 * 8;
    }
    for (; first + 8 <= end; first += 8) // a byte lies in two
    {
        const unsigned byte = from[first / 8];
        m_bytes.back() = std::uint8_t(m_bytes.back() | byte >> (8 - m_free));
        m_bytes.push_back(std::uint8_t(byte << m_free));
    }
    for (; first < end; ++first)
    {
        Bits(unsigned(from[first / 8]) >> (7 - first % 8) & 1u, 1);
    }
}

void BitWriter::End()
{
    Bits(1, 1);
    m_free = 0;
}

void BitWriter::Append(std::span<const std::uint8_t> bytes)
{
    assert(m_free == 0 && "at the start of a byte");
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
}

std::vector<std::span<const std::uint8_t>> SplitUnits(std::span<const std::uint8_t> stream)
{
    std::vector<std::span<const std::uint8_t>> units;
    std::size_t start = 0; // of the current unit; 0: none yet
    for (std::size_t i = 0; i + 3 <= stream.size();)
    {
        if (stream[i + 2] > 1)
        {
            i += 3;
            continue;
        }
        if (stream[i] != 0 || stream[i + 1] != 0 || stream[i + 2] != 1)
        {
            ++i;
            continue;
        }
        if (start > 0)
        {
            units.push_back(stream.subspan(start, i - start));
        }
        i += 3;
        start = i;
    }
    if (start > 0)
    {
        units.push_back(stream.subspan(start));
    }
    for (std::span<const std::uint8_t>& unit : units)
    {
        while (!unit.empty() && unit.back() == 0) // belongs to the next start code
        {
            unit = unit.first(unit.size() - 1);
        }
    }
    std::erase_if(units, [](std::span<const std::uint8_t> unit) { return unit.empty(); });
    return units;
}

std::vector<std::uint8_t> Unescaped(std::span<const std::uint8_t> unit)
{
    std::vector<std::uint8_t> raw;
    raw.reserve(unit.size());
    int zeros = 0;
    for (const std::uint8_t byte : unit)
    {
        if (zeros >= 2 && byte == 3)
        {
            zeros = 0;
            continue;
        }
        zeros = byte == 0 ? zeros + 1 : 0;
        raw.push_back(byte);
    }
    return raw;
}

namespace
{

void AppendStartCode(std::vector<std::uint8_t>& stream)
{
    constexpr std::uint8_t kStartCode[] = {0, 0, 0, 1};
    stream.insert(stream.end(), std::begin(kStartCode), std::end(kStartCode));
}

} // namespace

void AppendUnit(std::span<const std::uint8_t> raw, std::vector<std::uint8_t>& stream)
{
    AppendStartCode(stream);
    int zeros = 0;
    for (const std::uint8_t byte : raw)
    {
        if (zeros >= 2 && byte <= 3)
        {
            stream.push_back(3);
            zeros = 0;
        }
        zeros = byte == 0 ? zeros + 1 : 0;
        stream.push_back(byte);
    }
}

void AppendEscaped(std::span<const std::uint8_t> unit, std::vector<std::uint8_t>& stream)
{
    AppendStartCode(stream);
    stream.insert(stream.end(), unit.begin(), unit.end());
}

std::size_t EndOfBits(std::span<const std::uint8_t> raw)
{
    for (std::size_t size = raw.size(); size > 0; --size)
    {
        if (raw[size - 1] != 0)
        {
            return 8 * size - 1 - std::size_t(std::countr_zero(raw[size - 1]));
        }
    }
    return 0;
}

} // namespace boxreel
