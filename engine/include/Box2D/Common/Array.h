// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <algorithm>
#include <vector>

/// @file
/// The engine's growing arrays: std::vector over b2Alloc, so that a program that replaces the
/// allocator sees all of the engine's memory. Engine code only; a program may use what it likes.
namespace box2d
{
inline constexpr int32 kCacheLine = 64; ///< size of what a processor reads at once [bytes]

/// b2Alloc aligns no further than malloc: these two do to a cache line. What b2Alloc returned is
/// kept in front of the memory.
inline void* AllocateInLines(int32 size)
{
    void* whole = b2Alloc(size + 2 * kCacheLine);
    const std::uintptr_t after = reinterpret_cast<std::uintptr_t>(whole) + sizeof(void*);
    const std::uintptr_t start = (after + kCacheLine - 1) / kCacheLine * kCacheLine;
    // Rounded up. NOLINTNEXTLINE(performance-no-int-to-ptr)
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

/// Room for `count`, and at least for twice as much as before when there was too little: assign and
/// resize by themselves ask for no more than they need, and again for one more.
template <typename T>
void MakeRoom(Array<T>& array, std::size_t count)
{
    if (count > array.capacity())
    {
        array.reserve(std::max(count, 2 * array.capacity()));
    }
}
} // namespace box2d
