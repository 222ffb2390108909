// SPDX-License-Identifier: MIT
#pragma once

namespace box2d
{

extern bool g_usesWideInstructions; ///< read by the functions below

/// True if this processor and build can solve 8 lanes at a time (AVX2) instead of 4. Results have
/// the same bits.
bool HasWideInstructions();
/// For tests: enables or disables them if available. Not while a world steps.
void UseWideInstructions(bool use);
inline bool UsesWideInstructions()
{
    return g_usesWideInstructions;
}

} // namespace box2d
