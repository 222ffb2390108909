// SPDX-License-Identifier: MIT
#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2BlockAllocator.h>

#include <array>
#include <cstring>

namespace
{
// Sizes that waste at most a third of a block, each a multiple of the strictest alignment.
constexpr std::array<int32, b2_blockSizes> kBlockSizes = {
    16, 32, 64, 96, 128, 160, 192, 224, 256, 320, 384, 448, 512, b2_maxBlockSize};
constexpr int32 kGranule = 16;
// Blocks whose size is a multiple of a cache line are aligned to one.
constexpr int32 kChunkHeader = box2d::kCacheLine;
static_assert(kGranule % alignof(std::max_align_t) == 0);

// Index of the smallest sufficient block for every size, counted in granules and rounded up.
constexpr auto kSizeIndex = [] {
    std::array<uint8, b2_maxBlockSize / kGranule + 1> table = {};
    uint8 index = 0;
    for (int32 granules = 0; granules < static_cast<int32>(table.size()); ++granules)
    {
        index = static_cast<uint8>(index + (granules * kGranule > kBlockSizes[index] ? 1 : 0));
        table[granules] = index;
    }
    return table;
}();

void FillFreed([[maybe_unused]] void* memory, [[maybe_unused]] int32 size)
{
#if BOXREEL_ASSERTS
    std::memset(memory, 0xFD, static_cast<std::size_t>(size));
#endif
}
} // namespace

b2BlockAllocator::~b2BlockAllocator()
{
    Clear();
}

void* b2BlockAllocator::Allocate(int32 size)
{
    if (size <= 0)
    {
        B2_REQUIRE(size == 0, "b2BlockAllocator::Allocate got a negative size.");
        return nullptr;
    }
    if (size > b2_maxBlockSize)
    {
        return b2Alloc(size);
    }
    const int32 index = kSizeIndex[(size + kGranule - 1) / kGranule];
    if (m_freeLists[index] == nullptr)
    {
        AddChunk(index);
    }
    Block* block = m_freeLists[index];
    m_freeLists[index] = block->next;
    return block;
}

void b2BlockAllocator::Free(void* memory, int32 size)
{
    if (memory == nullptr || size <= 0)
    {
        return;
    }
    FillFreed(memory, size);
    if (size > b2_maxBlockSize)
    {
        b2Free(memory);
        return;
    }
    const int32 index = kSizeIndex[(size + kGranule - 1) / kGranule];
    Block* block = static_cast<Block*>(memory);
    block->next = m_freeLists[index];
    m_freeLists[index] = block;
}

void b2BlockAllocator::Clear()
{
    while (m_chunks != nullptr)
    {
        Chunk* chunk = m_chunks;
        m_chunks = chunk->next;
        box2d::FreeInLines(chunk);
    }
    for (Block*& list : m_freeLists)
    {
        list = nullptr;
    }
}

void b2BlockAllocator::AddChunk(int32 sizeIndex)
{
    static_assert(sizeof(Chunk) <= kChunkHeader);
    const int32 blockSize = kBlockSizes[sizeIndex];
    char* memory = static_cast<char*>(box2d::AllocateInLines(b2_chunkSize));
    Chunk* chunk = reinterpret_cast<Chunk*>(memory);
    chunk->next = m_chunks;
    chunk->blockSize = blockSize;
    m_chunks = chunk;

    // Added in reverse, so that blocks are allocated in the order of addresses.
    const int32 count = (b2_chunkSize - kChunkHeader) / blockSize;
    for (int32 i = count - 1; i >= 0; --i)
    {
        Block* block = reinterpret_cast<Block*>(memory + kChunkHeader + i * blockSize);
        block->next = m_freeLists[sizeIndex];
        m_freeLists[sizeIndex] = block;
    }
}
