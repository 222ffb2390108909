// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// @file
/// Numbers with nouns in singular or plural, and sizes.
namespace boxreel
{

/// Returns "frame" for 1 and "frames" otherwise; "body" and "bodies".
template <class Integer>
std::string PluralOf(Integer count, std::string_view thing)
{
    if (count == 1)
    {
        return std::string(thing);
    }
    return thing == "body" ? "bodies" : std::string(thing) + "s";
}

/// Returns the number with its noun: "1 frame", "2 frames".
template <class Integer>
std::string Counted(Integer count, std::string_view thing)
{
    return std::to_string(count) + " " + PluralOf(count, thing);
}

/// Returns a limit of size: "64 MB" (of 2^20 bytes, rounded down) or "100 bytes".
inline std::string SizeText(std::uintmax_t bytes)
{
    return bytes >> 20 > 0 ? std::to_string(bytes >> 20) + " MB" : Counted(bytes, "byte");
}

} // namespace boxreel
