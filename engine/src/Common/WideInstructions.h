// SPDX-License-Identifier: MIT
#pragma once

namespace box2d
{

extern int g_lanes; ///< read by the function below

/// Returns how many lanes this processor and build can solve at a time: 16 (AVX-512), 8 (AVX2) or
/// 4. Results have the same bits.
int WidestLanes();
/// For tests: solves at most this many, 4, 8 or 16. Not while a world steps.
void UseLanes(int most);
inline int LanesInUse()
{
    return g_lanes;
}

} // namespace box2d
