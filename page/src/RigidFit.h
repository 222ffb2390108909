// SPDX-License-Identifier: MIT
#pragma once

#include "Forms.h"

#include <optional>

/// Finds where points that move as one are.
namespace boxreel
{

/// A place in whole quanta, and an angle in units of its form.
struct RigidPlace
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::int64_t angle = 0;
};

/// Where a body is, as the page has it.
struct BodyPlace
{
    double x = 0.0;     ///< of its origin [m]
    double y = 0.0;     ///< of its origin [m]
    double angle = 0.0; ///< [rad]
};

/// Returns the place of the body whose shape has the form, which must have an origin.
BodyPlace BodyPlaceOf(const RigidForm& form, const RigidPlace& place, double quantum);

/// Returns the place that brings the form's points next to `points`, with the angle next to
/// `angleGuess`. None if a coordinate would be off by more than `tolerance` [m].
std::optional<RigidPlace> FitPlace(const RigidForm& form, std::span<const PagePoint> points,
                                   double quantum, std::int64_t angleGuess, double tolerance);

} // namespace boxreel
