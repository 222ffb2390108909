// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// Memory for small objects.

inline constexpr int32 b2_chunkSize = 16 * 1024; ///< what is asked of b2Alloc at a time [bytes]
inline constexpr int32 b2_maxBlockSize = 640; ///< larger blocks come straight from b2Alloc [bytes]
inline constexpr int32 b2_blockSizes = 14;    ///< how many sizes of block there are

/// Many small objects that live for a few steps to for ever: each size of block has a list of free
/// ones, filled a chunk at a time. For bodies, fixtures, joints and shapes; a block never moves.
/// With asserts on, freed memory is filled with 0xFD. Not for several threads at once.
class b2BlockAllocator
{
public:
    b2BlockAllocator() = default;
    ~b2BlockAllocator();
    b2BlockAllocator(const b2BlockAllocator&) = delete;
    b2BlockAllocator& operator=(const b2BlockAllocator&) = delete;

    /// Memory of so many bytes, aligned for any object; null when size is 0 and, after an assert,
    /// when it is negative. Not initialised.
    void* Allocate(int32 size);

    /// Takes a block back; the size must be the one it was allocated with. Null is allowed.
    void Free(void* memory, int32 size);

    /// Gives all chunks back. Every block from them is gone; blocks above b2_maxBlockSize are not
    /// the allocator's and remain.
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

    /// Threads the blocks of one more chunk onto the free list of that size.
    void AddChunk(int32 sizeIndex);

    Chunk* m_chunks = nullptr;
    Block* m_freeLists[b2_blockSizes] = {};
};
