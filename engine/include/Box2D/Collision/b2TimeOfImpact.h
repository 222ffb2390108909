// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Distance.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// The time of impact of two moving shapes.

/// The input of b2TimeOfImpact: two shapes and their motion.
struct b2TOIInput
{
    b2DistanceProxy proxyA; ///< the first shape
    b2DistanceProxy proxyB; ///< the second shape
    /// Motion of the first shape, finite [m, rad]. Only the relative motion matters, so both sweeps
    /// may use any common origin.
    b2Sweep sweepA;
    b2Sweep sweepB;      ///< motion of the second shape; see sweepA
    float32 tMax = 1.0f; ///< end of the searched interval [0, tMax], 0 to 1
};

/// The output of b2TimeOfImpact.
struct b2TOIOutput
{
    /// The result of the search.
    enum State
    {
        e_unknown,    ///< not computed
        e_failed,     ///< the search ended early; the shapes do not touch up to t
        e_overlapped, ///< the shapes overlap at the start
        e_touching,   ///< the shapes reach the target distance at t
        e_separated   ///< the shapes stay apart up to tMax
    };

    State state = e_unknown; ///< result of the search
    float32 t = 0.0f;        ///< 0 to b2TOIInput::tMax
};

/// Computes the time at which the skins of two moving shapes overlap by about b2_linearSlop. With
/// fixed rotations this is a shape cast. No impact is missed at any angular velocity, and separated
/// shapes are never reported as touching. Pointers are not null. A shape without vertices asserts,
/// and the search fails at t = 0.
void b2TimeOfImpact(b2TOIOutput* output, const b2TOIInput* input);

// Statistics of b2TimeOfImpact by the names of the 2.3 generation. They cover the calls of
// b2TimeOfImpact and the searches of continuous collision; see b2_gjkCalls.

extern int32 b2_toiCalls;        ///< number of calls
extern int32 b2_toiIters;        ///< advances in all calls
extern int32 b2_toiMaxIters;     ///< maximum advances in a call
extern int32 b2_toiRootIters;    ///< root finder iterations in all calls
extern int32 b2_toiMaxRootIters; ///< maximum root finder iterations of one advance
/// Time of all calls [ms]. A step measures it only after b2World::GetProfile was called.
extern float32 b2_toiTime;
extern float32 b2_toiMaxTime; ///< maximum time of a call [ms]; see b2_toiTime
