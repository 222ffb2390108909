// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// The allocator of memory that lives for one step.

inline constexpr int32 b2_stackSize = 100 * 1024; ///< size of the buffer; larger needs use the heap
                                                  ///< [bytes]
inline constexpr int32 b2_maxStackEntries = 32;   ///< maximum number of blocks at the same time

/// Memory for the duration of one step, freed in reverse order. Blocks that do not fit into the
/// buffer come from b2Alloc. The buffer is allocated with the first block, so an idle allocator
/// needs no memory. With asserts on, freed memory is filled with 0xFD. Not thread-safe.
class b2StackAllocator
{
public:
    b2StackAllocator() = default;
    ~b2StackAllocator();
    b2StackAllocator(const b2StackAllocator&) = delete;
    b2StackAllocator& operator=(const b2StackAllocator&) = delete;

    /// Returns uninitialised memory, aligned for any object.
    void* Allocate(int32 size);

    /// Frees the block that was allocated last.
    void Free(void* memory);

    /// Returns the maximum size in use at the same time [bytes].
    int32 GetMaxAllocation() const { return m_maxAllocation; }

private:
    struct Entry
    {
        char* data;
        int32 size; ///< rounded up to the alignment
        bool fromHeap;
    };

    char* m_data = nullptr;
    int32 m_used = 0;       ///< used part of the buffer
    int32 m_allocation = 0; ///< total in use, heap included
    int32 m_maxAllocation = 0;
    Entry m_entries[b2_maxStackEntries] = {};
    int32 m_entryCount = 0;
};
