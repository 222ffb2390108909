// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// Memory for the length of a step.

inline constexpr int32 b2_stackSize = 100 * 1024; ///< what needs no heap [bytes]
inline constexpr int32 b2_maxStackEntries = 32;   ///< how many blocks may be out at once

/// Memory for the length of one step, last out first in. What does not fit its buffer comes from
/// b2Alloc. The buffer itself is asked for with the first block, so an idle one costs nothing. With
/// asserts on, freed memory is filled with 0xFD. Not for several threads at once.
class b2StackAllocator
{
public:
    b2StackAllocator() = default;
    ~b2StackAllocator();
    b2StackAllocator(const b2StackAllocator&) = delete;
    b2StackAllocator& operator=(const b2StackAllocator&) = delete;

    /// Memory aligned for any object. Not initialised.
    void* Allocate(int32 size);

    /// Takes back the block that was allocated last.
    void Free(void* memory);

    /// The most that was ever out at once [bytes].
    int32 GetMaxAllocation() const { return m_maxAllocation; }

private:
    struct Entry
    {
        char* data;
        int32 size; ///< rounded up to the alignment
        bool fromHeap;
    };

    char* m_data = nullptr;
    int32 m_used = 0;       ///< of the buffer
    int32 m_allocation = 0; ///< in all, heap included
    int32 m_maxAllocation = 0;
    Entry m_entries[b2_maxStackEntries] = {};
    int32 m_entryCount = 0;
};
