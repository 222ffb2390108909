// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// @file
/// Little-endian numbers as bytes, and checksums.
namespace boxreel
{

/// Appends eight bytes, the lowest first.
void PutNumber(std::vector<std::uint8_t>& bytes, std::uint64_t number);

/// Removes eight bytes from the front and returns them as a number. With fewer bytes it returns 0
/// and removes all.
std::uint64_t TakeNumber(std::span<const std::uint8_t>& bytes);

/// Returns the 64-bit FNV-1a checksum (RFC 9923). It detects accidental changes, not deliberate
/// ones.
/// `before`: the checksum of the preceding bytes, to process data in pieces.
std::uint64_t ChecksumOf(std::span<const std::uint8_t> bytes,
                         std::uint64_t before = 0xcbf29ce484222325u);
/// Same as above, of a text.
std::uint64_t ChecksumOf(const std::string& text);

/// Returns 16 lower-case hex digits.
std::string HexText(std::uint64_t number);

} // namespace boxreel
