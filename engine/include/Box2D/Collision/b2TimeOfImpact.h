// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Distance.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// When two moving shapes first touch.

/// Two shapes and how they move.
struct b2TOIInput
{
    b2DistanceProxy proxyA; ///< the first shape
    b2DistanceProxy proxyB; ///< the second shape
    /// Of the first shape, finite [m, rad]. Only the motion between the two counts, so both sweeps
    /// may share any origin.
    b2Sweep sweepA;
    b2Sweep sweepB;      ///< of the second; see sweepA
    float32 tMax = 1.0f; ///< the sweeps are looked at from 0 to here, 0 to 1
};

/// What b2TimeOfImpact has found.
struct b2TOIOutput
{
    /// How the search ended.
    enum State
    {
        e_unknown,    ///< nothing was asked yet
        e_failed,     ///< the search ended early; up to t they do not touch
        e_overlapped, ///< they overlap at the start
        e_touching,   ///< they come within the target distance at t
        e_separated   ///< they stay apart up to tMax
    };

    State state = e_unknown; ///< how the search ended
    float32 t = 0.0f;        ///< 0 to b2TOIInput::tMax
};

/// When two moving shapes first come so close that their skins overlap by about a slop. With fixed
/// rotations this is a shape cast. However quickly shapes turn, no touch is missed, and nothing
/// counts as touching that does not. Neither pointer is null; of a shape without vertices it
/// asserts, and fails at t = 0.
void b2TimeOfImpact(b2TOIOutput* output, const b2TOIInput* input);
