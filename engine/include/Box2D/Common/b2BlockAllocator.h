// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// The allocator of small objects.

inline constexpr int32 b2_chunkSize = 16 * 1024; ///< size of a request to b2Alloc [bytes]
inline constexpr int32 b2_maxBlockSize = 640; ///< larger blocks come directly from b2Alloc [bytes]
inline constexpr int32 b2_blockSizes = 14;    ///< number of block sizes

/// Allocates small objects of any lifetime: bodies, fixtures, joints and shapes. Each block size
/// has a free list, filled one chunk at a time. A block never moves. With asserts on, freed memory
/// is filled with 0xFD. Not thread-safe.
class b2BlockAllocator
{
public:
    b2BlockAllocator() = default;
    ~b2BlockAllocator();
    b2BlockAllocator(const b2BlockAllocator&) = delete;
    b2BlockAllocator& operator=(const b2BlockAllocator&) = delete;

    /// Returns `size` bytes of uninitialised memory, aligned for any object. Null for a size of 0;
    /// a negative size asserts and returns null.
    void* Allocate(int32 size);

    /// Frees a block; the size must be the one of the allocation. Null is allowed.
    void Free(void* memory, int32 size);

    /// Frees all chunks and thereby every block in them. Blocks above b2_maxBlockSize remain.
    void Clear();

private:
    struct Block
    {
        Block* next;
    };
    struct Chunk
    {
        Chunk* next;
        int32 blockSize;
    };

    /// Adds the blocks of one more chunk to the free list of that size.
    void AddChunk(int32 sizeIndex);

    Chunk* m_chunks = nullptr;
    Block* m_freeLists[b2_blockSizes] = {};
};
