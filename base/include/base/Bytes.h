// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// @file
/// Numbers as bytes, the lowest first on every machine, and checksums of them.
namespace boxreel
{

void PutNumber(std::vector<std::uint8_t>& bytes, std::uint64_t number);

/// Takes eight bytes from the front; 0, and nothing left, when there are fewer.
std::uint64_t TakeNumber(std::span<const std::uint8_t>& bytes);

/// FNV-1a (RFC 9923) in 64 bits: against accidents, not against malice.
/// `before`: the checksum of what stands in front of them, when it is not had in one piece.
std::uint64_t ChecksumOf(std::span<const std::uint8_t> bytes,
                         std::uint64_t before = 0xcbf29ce484222325u);
std::uint64_t ChecksumOf(const std::string& text);

/// 16 lower-case hex digits.
std::string HexText(std::uint64_t number);

} // namespace boxreel
