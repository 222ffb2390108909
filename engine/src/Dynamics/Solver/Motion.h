// SPDX-License-Identifier: MIT
#pragma once

#include "BodyKick.h"

namespace box2d
{

/// Maximum motion of a body in a step; faster bodies are slowed down.
struct MaxMove
{
    float32 distance; ///< [m]
    float32 turn;     ///< [rad]
};

/// For a step without sub-steps.
inline constexpr MaxMove kMaxMove = {b2_maxTranslation, b2_maxRotation};
/// For a sub-step. Impacts are found for any displacement, and a higher limit loses less energy. At
/// 60 Hz with 2 sub-steps, the limits are 2400 m/s and 7540 rad/s. A tumbling box of 0.3 m at 300
/// m/s rotates with up to 4070 rad/s. With 12 quarters such boxes keep 54 % of their energy in 5 s
/// (docs/notes/tuned-constants.md). At 7500 rad/s the search for an impact with the ground took up
/// to 126 of its 200 steps, so a much higher limit would exceed them.
inline constexpr MaxMove kMaxSmallMove = {10.0f * b2_maxTranslation, 40.0f * b2_maxRotation};

/// Moves and rotates a body for `timeStep`, limiting its velocity.
void MoveByVelocity(SolverBody& body, float32 timeStep, const MaxMove& maximum);
/// The same for consecutive bodies, with the same bits.
void MoveByVelocity(SolverBody* bodies, int32 count, float32 timeStep, const MaxMove& maximum);

/// Gives each of consecutive bodies its kick, with the bits of BodyKick::Give.
void GiveKicks(SolverBody* bodies, const BodyKick* kicks, int32 count, float32 duration);

/// Returns the largest PushOf of consecutive bodies [m].
float32 FarthestPush(const SolverBody* before, const SolverBody* after, const BodyKick* kicks,
                     int32 count);

} // namespace box2d
