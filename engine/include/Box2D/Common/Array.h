// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <algorithm>
#include <vector>

/// @file
/// The engine's growing arrays: std::vector over b2Alloc, so that all of the engine's memory comes
/// from a replaced allocator. Internal to the engine.
namespace box2d
{
inline constexpr int32 kCacheLine = 64; ///< size of a cache line [bytes]

/// Allocates memory aligned to a cache line; b2Alloc aligns only as malloc does. The pointer that
/// b2Alloc returned is stored in front of the memory.
inline void* AllocateInLines(int32 size)
{
    void* whole = b2Alloc(size + 2 * kCacheLine);
    const std::uintptr_t after = reinterpret_cast<std::uintptr_t>(whole) + sizeof(void*);
    const std::uintptr_t start = (after + kCacheLine - 1) / kCacheLine * kCacheLine;
    // Rounds up. NOLINTNEXTLINE(performance-no-int-to-ptr)
    void** memory = reinterpret_cast<void**>(start);
    memory[-1] = whole;
    return memory;
}

inline void FreeInLines(void* memory)
{
    if (memory)
    {
        b2Free(static_cast<void**>(memory)[-1]);
    }
}

template <typename T>
struct Allocator
{
    typedef T value_type;
    static_assert(alignof(T) <= std::size_t(kCacheLine));

    static constexpr bool kInLines = alignof(T) > alignof(std::max_align_t);

    Allocator() = default;
    template <typename U>
    Allocator(const Allocator<U>&)
    {}

    T* allocate(std::size_t count)
    {
        b2Assert(count <= std::size_t(INT32_MAX - 2 * kCacheLine) / sizeof(T));
        if constexpr (kInLines)
        {
            return static_cast<T*>(AllocateInLines(static_cast<int32>(count * sizeof(T))));
        }
        return static_cast<T*>(b2Alloc(static_cast<int32>(count * sizeof(T))));
    }
    void deallocate(T* memory, std::size_t) { kInLines ? FreeInLines(memory) : b2Free(memory); }

    template <typename U>
    bool operator==(const Allocator<U>&) const
    {
        return true;
    }
};

template <typename T>
using Array = std::vector<T, Allocator<T>>;

/// Reserves room for `count`. A capacity that grows is at least doubled. assign and resize alone
/// reserve exactly what they need, so they would reallocate for each element.
template <typename T>
void MakeRoom(Array<T>& array, std::size_t count)
{
    if (count > array.capacity())
    {
        array.reserve(std::max(count, 2 * array.capacity()));
    }
}
} // namespace box2d
