// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// @file
/// Numbers with nouns in singular or plural.
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

} // namespace boxreel
