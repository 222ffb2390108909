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

// Statistics of b2TimeOfImpact by the names of the 2.3 generation. They cover the calls of
// b2TimeOfImpact and the searches of continuous collision; see b2_gjkCalls.

extern int32 b2_toiCalls;        ///< how often an impact was searched for
extern int32 b2_toiIters;        ///< advances of all these searches
extern int32 b2_toiMaxIters;     ///< advances of the longest of these searches
extern int32 b2_toiRootIters;    ///< iterations of all searches for the length of an advance
extern int32 b2_toiMaxRootIters; ///< iterations for the length of one advance, at most
/// Time of all these searches [ms]. In a step it is measured when b2World::GetProfile was called
/// before.
extern float32 b2_toiTime;
extern float32 b2_toiMaxTime; ///< time of the longest of these searches [ms]; see b2_toiTime
