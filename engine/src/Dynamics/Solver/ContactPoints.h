// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

class b2Contact;
class b2ContactListener;

namespace box2d
{

/// Calls the listener with the impulses of a contact's manifold.
void ReportImpulse(b2ContactListener& listener, b2Contact& contact);

/// Solves both points together. Of the four cases in which each impulse or its speed is zero,
/// selects the one with no negative value (total enumeration; Murty, "Linear Complementarity",
/// 1988). False if rounding leaves none.
bool EnumerateImpulses(float32 k11, float32 k12, float32 k22, float32 b1, float32 b2, float32& x1,
                       float32& x2);

} // namespace box2d
