// SPDX-License-Identifier: MIT
#pragma once

#include "JsonFields.h"

#include <debugdraw/Result.h>

#include <span>
#include <string>

/// Whether a file of figures, which may be anybody's, holds what can be shown: numbers beyond what
/// a benchmark measures would be no whole numbers, and no places on a chart.
namespace boxreel
{

/// What the number of this name may be, wherever it stands, besides 0.
struct FieldRange
{
    const char* name;
    double least;
    double most;
};

/// Far beyond what is measured, and near enough for the ratio of two to be drawn.
inline constexpr double kSmallest = 1e-18;
inline constexpr double kLargest = 1e18;
inline constexpr double kLongest = 1e9; ///< [s]
inline constexpr double kMostOf = 1e9;  ///< bodies, contacts, frames

/// An Error (Unusable) with the first number that is out of its range, or text that would not stay
/// on its line of a terminal. `name` is the file's, `maker` the command that makes such files.
Result<void> CheckFields(const Json& json, std::span<const FieldRange> ranges,
                         const std::string& name, const std::string& maker);

} // namespace boxreel
