// SPDX-License-Identifier: MIT
#include "GifLzw.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace boxreel
{

namespace
{

constexpr int kMaxBits = 12;
// The table is reset one code before it is full, because some decoders mishandle the last code.
constexpr std::uint32_t kMaxCodes = (1u << kMaxBits) - 1;

/// Writes numbers of variable width, lowest bit first, in blocks that start with their length.
class BlockWriter
{
public:
    explicit BlockWriter(std::vector<std::uint8_t>& out) : m_out(out) {}

    void Put(std::uint32_t code, int width)
    {
        m_bits |= code << m_count;
        m_count += width;
        while (m_count >= 8)
        {
            PutByte(std::uint8_t(m_bits));
            m_bits >>= 8;
            m_count -= 8;
        }
    }

    void Finish()
    {
        if (m_count > 0)
        {
            PutByte(std::uint8_t(m_bits));
        }
        EndBlock();
        m_out.push_back(0);
    }

private:
    void PutByte(std::uint8_t byte)
    {
        m_block[m_size++] = byte;
        if (m_size == m_block.size())
        {
            EndBlock();
        }
    }

    void EndBlock()
    {
        if (m_size > 0)
        {
            m_out.push_back(std::uint8_t(m_size));
            m_out.insert(m_out.end(), m_block.begin(), m_block.begin() + std::ptrdiff_t(m_size));
            m_size = 0;
        }
    }

    std::vector<std::uint8_t>& m_out;
    std::uint32_t m_bits = 0;
    int m_count = 0;
    std::array<std::uint8_t, 255> m_block{};
    std::size_t m_size = 0;
};

/// The codes of index runs: the code of a run and the next index give the code of the longer run.
class RunTable
{
public:
    RunTable() { Clear(); }

    void Clear() { m_slots.fill(Slot{}); }

    struct Slot
    {
        std::uint32_t key = kNone;
        std::uint32_t code = 0;
        bool IsEmpty() const { return key == kNone; }
    };

    /// Returns the slot of this run, or the empty slot for it.
    Slot& Find(std::uint32_t key)
    {
        std::size_t at = (key * 0x9e3779b1u) >> (32 - kSlotBits);
        while (m_slots[at].key != key && !m_slots[at].IsEmpty())
        {
            at = (at + 1) % m_slots.size();
        }
        return m_slots[at];
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr int kSlotBits = 13; // twice the number of codes, to reduce collisions
    std::array<Slot, 1u << kSlotBits> m_slots;
};

} // namespace

void AppendGifLzw(std::span<const std::uint8_t> indices, int bits, std::vector<std::uint8_t>& out)
{
    assert(!indices.empty() && bits >= 2 && bits <= 8 && "as GIF can hold them");
    const std::uint32_t clear = 1u << bits;
    const std::uint32_t end = clear + 1;
    out.push_back(std::uint8_t(bits));
    BlockWriter writer(out);
    RunTable runs;
    std::uint32_t next = end + 1;
    int width = bits + 1;
    writer.Put(clear, width);
    std::uint32_t run = indices.front();
    for (const std::uint8_t index : indices.subspan(1))
    {
        const std::uint32_t key = run << 8 | index;
        RunTable::Slot& slot = runs.Find(key);
        if (!slot.IsEmpty())
        {
            run = slot.code;
            continue;
        }
        writer.Put(run, width);
        run = index;
        if (next == kMaxCodes)
        {
            writer.Put(clear, width);
            runs.Clear();
            next = end + 1;
            width = bits + 1;
            continue;
        }
        slot = {key, next};
        width += next == 1u << width ? 1 : 0;
        ++next;
    }
    writer.Put(run, width);
    width += next == 1u << width ? 1 : 0; // the decoder has also added a code for this run
    writer.Put(end, width);
    writer.Finish();
}

} // namespace boxreel
