// SPDX-License-Identifier: MIT
#include "CollisionSupport.h"

#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2BlockAllocator.h>
#include <Box2D/Common/b2GrowableStack.h>
#include <Box2D/Common/b2StackAllocator.h>
#include <Box2D/Common/b2Timer.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace
{
int g_allocated = 0;
int g_freed = 0;
std::string g_logged;

void* CountingAlloc(std::size_t size)
{
    ++g_allocated;
    return std::malloc(size);
}

void CountingFree(void* memory)
{
    ++g_freed;
    std::free(memory);
}

struct CountedMemory : testing::Test
{
    CountedMemory()
    {
        g_allocated = 0;
        g_freed = 0;
        b2SetAllocator(CountingAlloc, CountingFree);
    }
    ~CountedMemory() override { b2SetAllocator(nullptr, nullptr); }
};
} // namespace

TEST(Log, CallsTheFunctionThatIsSet)
{
    g_logged.clear();
    b2SetLog([](const char* text) { g_logged += text; });
    b2Log("body %d at %.1f\n", 3, 1.5);
    b2SetLog(nullptr);
    EXPECT_EQ(g_logged, "body 3 at 1.5\n");
}

TEST(Timer, IsNotNegative)
{
    b2Timer timer;
    EXPECT_GE(timer.GetMilliseconds(), 0.0f);
}

TEST_F(CountedMemory, AllocatesLargeBlocksByReplaceableFunctions)
{
    {
        b2BlockAllocator blocks;
        blocks.Free(blocks.Allocate(100), 100);
        blocks.Free(blocks.Allocate(b2_maxBlockSize + 1), b2_maxBlockSize + 1);
        b2StackAllocator stack;
        stack.Free(stack.Allocate(b2_stackSize + 1));
        box2d::Array<int> array(100);
    }
    EXPECT_EQ(g_allocated, 5);
    EXPECT_EQ(g_freed, 5);
}

TEST_F(CountedMemory, SharesAChunkAmongBlocksAndReusesThem)
{
    b2BlockAllocator blocks;
    void* first = blocks.Allocate(50);
    for (int i = 0; i < 100; ++i)
    {
        blocks.Allocate(64);
    }
    EXPECT_EQ(g_allocated, 1);
    blocks.Free(first, 50);
    EXPECT_EQ(blocks.Allocate(64), first);
    EXPECT_EQ(blocks.Allocate(0), nullptr);
}

TEST(BlockAllocator, AlignsBlocksOfWholeCacheLines)
{
    b2BlockAllocator blocks;
    for (int i = 0; i < 200; ++i)
    {
        for (const int32 size : {64, 256, 320})
        {
            const auto address = reinterpret_cast<std::uintptr_t>(blocks.Allocate(size));
            EXPECT_EQ(address % std::uintptr_t(box2d::kCacheLine), 0u) << size;
        }
    }
}

struct alignas(64) Line
{
    int numbers[16];
};

TEST_F(CountedMemory, AlignsCacheLineArraysAndFreesAll)
{
    {
        box2d::Array<Line> lines;
        for (int i = 0; i < 100; ++i)
        {
            lines.push_back(Line{{i}});
            EXPECT_EQ(reinterpret_cast<std::uintptr_t>(lines.data()) % 64u, 0u);
        }
        EXPECT_EQ(lines[77].numbers[0], 77);
    }
    EXPECT_GT(g_allocated, 1);
    EXPECT_EQ(g_allocated, g_freed);
}

TEST(BlockAllocator, ReturnsNoOverlappingBlocksUnderRandomUse)
{
    struct Held
    {
        unsigned char* memory;
        int32 size;
        unsigned char mark;
    };
    b2BlockAllocator blocks;
    std::vector<Held> held;
    Random random(3);
    for (int i = 0; i < 20000; ++i)
    {
        if (held.size() < 200 || random.Integer(0, 1) == 0)
        {
            const int32 size = random.Integer(1, 700);
            const unsigned char mark = static_cast<unsigned char>(i);
            unsigned char* memory = static_cast<unsigned char*>(blocks.Allocate(size));
            ASSERT_EQ(reinterpret_cast<std::uintptr_t>(memory) % alignof(std::max_align_t), 0u);
            std::memset(memory, mark, static_cast<std::size_t>(size));
            held.push_back({memory, size, mark});
            continue;
        }
        const std::size_t which =
            static_cast<std::size_t>(random.Integer(0, static_cast<int32>(held.size()) - 1));
        const Held gone = held[which];
        for (int32 k = 0; k < gone.size; ++k)
        {
            ASSERT_EQ(gone.memory[k], gone.mark);
        }
        blocks.Free(gone.memory, gone.size);
        held[which] = held.back();
        held.pop_back();
    }
    for (const Held& h : held)
    {
        blocks.Free(h.memory, h.size);
    }
}

#if BOXREEL_ASSERTS
TEST(BlockAllocator, FillsFreedBlocksWithFD)
{
    b2BlockAllocator blocks;
    unsigned char* memory = static_cast<unsigned char*>(blocks.Allocate(64));
    std::memset(memory, 1, 64);
    blocks.Free(memory, 64);
    // The first bytes hold the list of free blocks.
    for (int i = static_cast<int>(sizeof(void*)); i < 64; ++i)
    {
        EXPECT_EQ(memory[i], 0xFD);
    }
    blocks.Clear();
}

TEST(StackAllocatorDeathTest, RefusesToFreeOutOfOrder)
{
    b2StackAllocator stack;
    void* first = stack.Allocate(10);
    void* second = stack.Allocate(10);
    EXPECT_DEATH(stack.Free(first), "allocated last");
    stack.Free(second);
    stack.Free(first);
}

TEST(AssertDeathTest, PrintsTheConditionOrTheMessage)
{
    EXPECT_DEATH(b2Assert(1 + 1 == 3), "1 \\+ 1 == 3");
    EXPECT_DEATH(B2_REQUIRE(false, "A box needs a size."), "A box needs a size.");
}
#else
TEST(Assert, DoesNothingWhenOffAndRequirementsReturnFalse)
{
    b2Assert(1 + 1 == 3);
    EXPECT_FALSE(B2_REQUIRE(false, "A box needs a size."));
    EXPECT_TRUE(B2_REQUIRE(true, "A box needs a size."));
}

TEST(StackAllocator, IgnoresFreesOutOfOrder)
{
    b2StackAllocator stack;
    void* first = stack.Allocate(10);
    void* second = stack.Allocate(10);
    stack.Free(first);
    stack.Free(second);
    stack.Free(first);
    EXPECT_EQ(stack.GetMaxAllocation(), 32);
}
#endif

TEST(StackAllocator, ReusesMemoryAndTracksItsMaximum)
{
    b2StackAllocator stack;
    void* a = stack.Allocate(100);
    void* b = stack.Allocate(2 * b2_stackSize); // more than the buffer: from the heap
    void* c = stack.Allocate(100);
    EXPECT_NE(a, c);
    stack.Free(c);
    stack.Free(b);
    stack.Free(a);
    EXPECT_EQ(stack.Allocate(100), a);
    EXPECT_GE(stack.GetMaxAllocation(), 2 * b2_stackSize + 200);
    stack.Free(a);
}

TEST(GrowableStack, KeepsItsOrderWhenItGrows)
{
    b2GrowableStack<int32, 4> stack;
    for (int32 i = 0; i < 1000; ++i)
    {
        stack.Push(i);
    }
    EXPECT_EQ(stack.GetCount(), 1000);
    for (int32 i = 999; i >= 0; --i)
    {
        ASSERT_EQ(stack.Pop(), i);
    }
}
