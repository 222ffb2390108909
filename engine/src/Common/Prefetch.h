// SPDX-License-Identifier: MIT
#pragma once

/// Prefetching for loops over objects that are scattered in memory and known in advance. It affects
/// only time.
namespace box2d
{

inline void Prefetch([[maybe_unused]] const void* memory)
{
#if defined(__GNUC__)
    __builtin_prefetch(memory);
#endif
}

} // namespace box2d
