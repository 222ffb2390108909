// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// @file
/// Text to and from the gzip format (RFC 1952), so that `zcat` reads what is stored. Only Gzip.cpp
/// knows zlib. Works in memory and touches no files; `name` is the culprit of an Error. The target
/// is boxreel::gzip, so that boxreel::base needs no library.
namespace boxreel
{

/// Packs a text, without a time or a name in the header: the same text gives the same bytes. An
/// Error (Failed) when memory runs out.
Result<std::string> Gzip(const std::string& name, std::string_view text);

/// Unpacks a text. An Error (Unusable) when the bytes are not exactly one whole gzip stream or grow
/// beyond `limit` [bytes].
Result<std::string> Gunzip(const std::string& name, std::string_view bytes, std::size_t limit);

/// Returns the CRC-32 that gzip and PNG store.
std::uint32_t Crc32(std::span<const std::uint8_t> bytes);

} // namespace boxreel
