// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

#include <vector>

/// The engine's growing arrays: std::vector over b2Alloc, so that a program that replaces the
/// allocator sees all of the engine's memory. Engine code only; a program may use what it likes.
namespace box2d
{
template <typename T>
struct Allocator
{
    typedef T value_type;
    static_assert(alignof(T) <= alignof(std::max_align_t), "b2Alloc aligns no further than malloc");

    Allocator() = default;
    template <typename U>
    Allocator(const Allocator<U>&)
    {}

    T* allocate(std::size_t count)
    {
        b2Assert(count <= INT32_MAX / sizeof(T));
        return static_cast<T*>(b2Alloc(static_cast<int32>(count * sizeof(T))));
    }
    void deallocate(T* memory, std::size_t) { b2Free(memory); }

    template <typename U>
    bool operator==(const Allocator<U>&) const
    {
        return true;
    }
};

template <typename T>
using Array = std::vector<T, Allocator<T>>;
} // namespace box2d
