// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstddef>
#include <string>
#include <string_view>

/// Text to and from the gzip format (RFC 1952), so that `zcat` reads what is stored. Only Gzip.cpp
/// knows zlib. Works in memory and touches no files; `name` is the culprit of an Error.
namespace boxreel
{

/// Without a time or a name in the header: the same text gives the same bytes.
Result<std::string> Gzip(const std::string& name, std::string_view text);

/// An Error when the bytes are not exactly one whole gzip stream or grow beyond `limit`.
Result<std::string> Gunzip(const std::string& name, std::string_view bytes, std::size_t limit);

} // namespace boxreel
