// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Bits of H.264 units: reading, writing, start codes (ITU-T H.264, 7.3, 9.1 and annex B). Used by
/// H264Repeat.
namespace boxreel
{

/// Reads bits, the highest of a byte first. Reading past the end returns zeros and sets HasFailed.
class BitReader
{
public:
    explicit BitReader(std::span<const std::uint8_t> bytes) : m_bytes(bytes) {}

    std::uint32_t Bits(int count);
    bool Flag() { return Bits(1) != 0; }
    std::uint32_t Unsigned(); ///< ue(v), an Exp-Golomb code
    std::int32_t Signed();    ///< se(v)
    std::size_t Position() const { return m_position; }
    bool HasFailed() const { return m_hasFailed; }

private:
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_position = 0; // [bits]
    bool m_hasFailed = false;
};

class BitWriter
{
public:
    void Bits(std::uint32_t value, int count);
    void Flag(bool isSet) { Bits(isSet ? 1 : 0, 1); }
    void Unsigned(std::uint32_t value); ///< ue(v)
    void Signed(std::int32_t value);    ///< se(v)
    /// Appends the bits of `from` from `first` up to `end`.
    void Copy(std::span<const std::uint8_t> from, std::size_t first, std::size_t end);
    /// Appends the bit that ends a unit, and zeros up to the next byte.
    void End();
    /// Appends whole bytes. The position must be at one.
    void Append(std::span<const std::uint8_t> bytes);
    const std::vector<std::uint8_t>& Bytes() const { return m_bytes; }

private:
    std::vector<std::uint8_t> m_bytes;
    int m_free = 0; // bits of the last byte that are not written yet
};

/// Splits a stream at its start codes. The units keep their emulation prevention bytes.
std::vector<std::span<const std::uint8_t>> SplitUnits(std::span<const std::uint8_t> stream);

/// Removes the emulation prevention bytes of a unit.
std::vector<std::uint8_t> Unescaped(std::span<const std::uint8_t> unit);

/// Appends a start code and the unit, with emulation prevention bytes where they are necessary.
void AppendUnit(std::span<const std::uint8_t> raw, std::vector<std::uint8_t>& stream);

/// Appends a start code and a unit that has its emulation prevention bytes.
void AppendEscaped(std::span<const std::uint8_t> unit, std::vector<std::uint8_t>& stream);

/// Returns the position of the bit that ends the unit; 0 if there is none.
std::size_t EndOfBits(std::span<const std::uint8_t> raw);

} // namespace boxreel
