// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <string>
#include <string_view>

/// Text to and from the gzip format (RFC 1952), readable by `zcat`. Only Gzip.cpp uses zlib. Works
/// in memory; the caller adds the file name to messages.
namespace boxreel
{

/// Compresses without a time or a name in the header: the same text gives the same bytes.
Result<std::string> Gzip(std::string_view text);

/// Decompresses. An Error when the bytes are not exactly one gzip stream or exceed `limit`.
Result<std::string> Gunzip(std::string_view bytes, std::size_t limit);

} // namespace boxreel
