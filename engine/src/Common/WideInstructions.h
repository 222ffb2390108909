// SPDX-License-Identifier: MIT
#pragma once

namespace box2d
{

extern bool g_usesWideInstructions; ///< use the functions

/// Whether this processor and build can solve 8 lanes at a time (AVX2) instead of 4. The results
/// have the same bits.
bool HasWideInstructions();
/// For tests: whether to use them where there are any. Not while a world steps.
void UseWideInstructions(bool use);
inline bool UsesWideInstructions()
{
    return g_usesWideInstructions;
}

} // namespace box2d
