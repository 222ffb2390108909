// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// @file
/// Numbers with nouns in singular or plural.
namespace boxreel
{

/// Returns the number with its noun: "1 frame", "2 frames".
template <class Integer>
std::string Counted(Integer count, std::string_view thing)
{
    return std::to_string(count).append(" ").append(thing).append(count == 1 ? "" : "s");
}

} // namespace boxreel
