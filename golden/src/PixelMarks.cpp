// SPDX-License-Identifier: MIT
#include "PixelMarks.h"

#include "EdgeRule.h"
#include "PairTable.h"
#include "PixelWord.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

class Marker
{
public:
    Marker(const Frame& expected, const Frame& actual, const CompareSettings& settings,
           Comparison& result)
        : m_expected(expected), m_actual(actual), m_settings(settings), m_result(result),
          m_pairs(settings.tolerance)
    {
        m_marks.width = std::max(expected.width, actual.width);
        m_marks.height = std::max(expected.height, actual.height);
        for (const PixelBounds& bounds : settings.ignored)
        {
            m_marks.Ignore(bounds);
        }
        // Rectangles may overlap, so pixels are counted instead of areas.
        m_result.ignored = std::count(m_marks.marks.begin(), m_marks.marks.end(), Mark::Ignored);
        m_hasIgnored = m_result.ignored > 0;
        m_result.compared = std::int64_t(m_marks.width) * m_marks.height - m_result.ignored;
    }

    void MarkRow(int y)
    {
        const int common = y < std::min(m_expected.height, m_actual.height)
                               ? std::min(m_expected.width, m_actual.width)
                               : 0;
        m_row = m_marks.Row(y);
        m_first = m_marks.width;
        m_last = -1;
        m_inRow = m_overInRow = 0;
        if (common > 0)
        {
            const std::uint8_t* p = m_expected.Pixel(0, y);
            const std::uint8_t* q = m_actual.Pixel(0, y);
            m_first = 0;
            m_last = common - 1;
            while (m_last >= 0 && PixelWord(p + 4 * m_last) == PixelWord(q + 4 * m_last))
            {
                --m_last;
            }
            while (m_first < m_last && PixelWord(p + 4 * m_first) == PixelWord(q + 4 * m_first))
            {
                ++m_first;
            }
            MarkCommon(p, q, m_last + 1);
            if (m_settings.edgeShift > 0.0 && m_overInRow > 0)
            {
                const int excused = ExcuseEdges(m_expected, m_actual, y, m_first, m_last + 1,
                                                m_settings.tolerance, m_settings.edgeShift, m_row);
                m_result.excusedAtEdges += excused;
                m_overInRow -= excused;
            }
        }
        if (common < m_marks.width)
        {
            m_first = m_last < 0 ? common : m_first;
            m_last = m_marks.width - 1;
        }
        for (int x = common; x < m_marks.width; ++x)
        {
            if (m_row[x] != Mark::Ignored)
            {
                m_row[x] = Mark::Over;
                ++m_inRow;
                ++m_overInRow;
            }
        }
        if (m_inRow > 0)
        {
            CloseRow(y);
        }
    }

    Marks Finish()
    {
        m_result.largestDistance = m_pairs.LargestDistance();
        return std::move(m_marks);
    }

private:
    void MarkCommon(const std::uint8_t* p, const std::uint8_t* q, int count)
    {
        // Eight pixels at once, because most of a different row is equal.
        constexpr int kBlock = 8;
        int begin = m_first; // pixels to test one by one
        for (int x = m_first; x < count; x += kBlock)
        {
            if (count - x >= kBlock && (std::memcmp(p + 4 * x, q + 4 * x, 4 * kBlock) == 0 ||
                                        MarkUniform(p + 4 * x, q + 4 * x, x, kBlock)))
            {
                MarkEach(p, q, begin, x);
                begin = x + kBlock;
            }
        }
        MarkEach(p, q, begin, count);
        MarkNew(p, q);
    }

    // Marks `count` pixels of one colour in both pictures at once. False if they are not uniform,
    // or must be tested one by one.
    bool MarkUniform(const std::uint8_t* p, const std::uint8_t* q, int x, int count)
    {
        const std::size_t allButOne = std::size_t(count - 1) * 4;
        if (PixelWord(q) != PixelWord(q + 4) || m_hasIgnored ||
            std::memcmp(q, q + 4, allButOne) != 0 || std::memcmp(p, p + 4, allButOne) != 0)
        {
            return false;
        }
        const bool isOver = m_pairs.IsOver(PixelWord(p), PixelWord(q));
        std::fill(m_row + x, m_row + x + count, isOver ? Mark::Over : Mark::Within);
        m_inRow += count;
        m_overInRow += isOver ? count : 0;
        return true;
    }

    // Members are copied to locals, because the compiler assumes that a mark may alias them.
    void MarkEach(const std::uint8_t* p, const std::uint8_t* q, int x, int end)
    {
        static_assert(int(Mark::Over) == int(Mark::Within) + 1);
        Mark* const row = m_row;
        const std::uint64_t* const entries = m_pairs.Entries();
        const bool hasIgnored = m_hasIgnored;
        int different = 0, over = 0;
        for (; x < end; ++x)
        {
            const std::uint32_t a = PixelWord(p + 4 * x), b = PixelWord(q + 4 * x);
            if (a == b || (hasIgnored && row[x] == Mark::Ignored))
            {
                continue;
            }
            ++different;
            const std::uint64_t answer = PairTable::Find(entries, a, b);
            if (answer <= 1)
            {
                row[x] = Mark(int(Mark::Within) + int(answer));
                over += int(answer);
                continue;
            }
            m_new[std::size_t(m_newCount++)] = x;
            if (m_newCount == kLanes)
            {
                MarkNew(p, q);
            }
        }
        m_inRow += different;
        m_overInRow += over;
    }

    // Tests pairs that were not in the table, four at a time.
    void MarkNew(const std::uint8_t* p, const std::uint8_t* q)
    {
        if (m_newCount == 0)
        {
            return;
        }
        Words a{}, b{};
        for (int i = 0; i < m_newCount; ++i)
        {
            a[i] = PixelWord(p + 4 * m_new[std::size_t(i)]);
            b[i] = PixelWord(q + 4 * m_new[std::size_t(i)]);
        }
        const std::array<bool, kLanes> areOver = m_pairs.AreOver(a, b, m_newCount);
        for (int i = 0; i < m_newCount; ++i)
        {
            m_row[m_new[std::size_t(i)]] = areOver[std::size_t(i)] ? Mark::Over : Mark::Within;
            m_overInRow += areOver[std::size_t(i)];
        }
        m_newCount = 0;
    }

    void CloseRow(int y)
    {
        m_result.differentPixels += m_inRow;
        m_result.overTolerance += m_overInRow;
        m_marks.overInRow[std::size_t(y)] = m_overInRow;
        m_marks.different.Include(m_first, y);
        m_marks.different.Include(m_last, y);
        if (m_overInRow == 0)
        {
            return;
        }
        const int firstOver = int(std::find(m_row + m_first, m_row + m_last, Mark::Over) - m_row);
        int lastOver = m_last;
        while (m_row[lastOver] != Mark::Over)
        {
            --lastOver;
        }
        m_marks.over.Include(firstOver, y);
        m_marks.over.Include(lastOver, y);
        if (m_result.firstX < 0)
        {
            m_result.firstX = firstOver;
            m_result.firstY = y;
        }
    }

    const Frame& m_expected;
    const Frame& m_actual;
    const CompareSettings& m_settings;
    Comparison& m_result;
    PairTable m_pairs;
    Marks m_marks;
    bool m_hasIgnored;
    // The current row, and its range of marks.
    Mark* m_row = nullptr;
    int m_first = 0, m_last = -1;
    int m_inRow = 0, m_overInRow = 0;
    std::array<int, kLanes> m_new{}; // columns
    int m_newCount = 0;
};

} // namespace

Marks MarkDifferences(const Frame& expected, const Frame& actual, const CompareSettings& settings,
                      Comparison& result)
{
    Marker marker(expected, actual, settings, result);
    const int width = std::max(expected.width, actual.width);
    const int height = std::max(expected.height, actual.height);
    const std::size_t rowBytes = std::size_t(width) * 4;
    for (int y = 0; y < height && width > 0; ++y)
    {
        if (!result.sameSize ||
            std::memcmp(expected.Pixel(0, y), actual.Pixel(0, y), rowBytes) != 0)
        {
            marker.MarkRow(y);
        }
    }
    return marker.Finish();
}

} // namespace boxreel
