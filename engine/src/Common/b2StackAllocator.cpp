// SPDX-License-Identifier: MIT
#include <Box2D/Common/b2StackAllocator.h>

#include <Box2D/Common/b2Math.h>

#include <cstring>

namespace
{
constexpr int32 kAlignment = static_cast<int32>(alignof(std::max_align_t));
} // namespace

b2StackAllocator::~b2StackAllocator()
{
    B2_REQUIRE(m_entryCount == 0, "A b2StackAllocator was destroyed with blocks still out.");
    if (m_data != nullptr)
    {
        b2Free(m_data);
    }
}

void* b2StackAllocator::Allocate(int32 size)
{
    if (!B2_REQUIRE(size >= 0 && m_entryCount < b2_maxStackEntries,
                    "b2StackAllocator has b2_maxStackEntries blocks out; free some first."))
    {
        return nullptr;
    }
    if (m_data == nullptr)
    {
        m_data = static_cast<char*>(b2Alloc(b2_stackSize));
    }

    Entry& entry = m_entries[m_entryCount++];
    entry.size = (size + kAlignment - 1) / kAlignment * kAlignment;
    entry.fromHeap = entry.size > b2_stackSize - m_used;
    if (entry.fromHeap)
    {
        entry.data = static_cast<char*>(b2Alloc(entry.size));
    }
    else
    {
        entry.data = m_data + m_used;
        m_used += entry.size;
    }
    m_allocation += entry.size;
    m_maxAllocation = b2Max(m_maxAllocation, m_allocation);
    return entry.data;
}

void b2StackAllocator::Free(void* memory)
{
    const bool isLast = m_entryCount > 0 && m_entries[m_entryCount - 1].data == memory;
    if (!B2_REQUIRE(isLast, "b2StackAllocator::Free takes the block that was allocated last."))
    {
        return;
    }
    const Entry& entry = m_entries[--m_entryCount];
#if BOXREEL_ASSERTS
    std::memset(entry.data, 0xFD, static_cast<std::size_t>(entry.size));
#endif
    m_allocation -= entry.size;
    if (entry.fromHeap)
    {
        b2Free(entry.data);
    }
    else
    {
        m_used -= entry.size;
    }
}
