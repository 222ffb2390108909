// SPDX-License-Identifier: MIT
#include "PixelMarks.h"

#include "EdgeRule.h"
#include "PairTable.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace boxreel
{

namespace
{

std::uint32_t Word(const std::uint8_t* pixel)
{
    std::uint32_t word;
    std::memcpy(&word, pixel, 4);
    return word;
}

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
        // They may overlap, so the pixels are counted, not the areas.
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
        if (common > 0)
        {
            const std::uint8_t* p = m_expected.Pixel(0, y);
            const std::uint8_t* q = m_actual.Pixel(0, y);
            m_first = 0;
            m_last = common - 1;
            for (; m_last >= 0 && Word(p + 4 * m_last) == Word(q + 4 * m_last); --m_last)
            {}
            for (; m_first < m_last && Word(p + 4 * m_first) == Word(q + 4 * m_first); ++m_first)
            {}
            MarkCommon(p, q, m_last + 1);
            if (m_settings.edgeShift > 0.0 && m_last >= 0)
            {
                m_result.excusedAtEdges +=
                    ExcuseEdges(m_expected, m_actual, y, m_first, m_last + 1, m_settings.tolerance,
                                m_settings.edgeShift, m_row);
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
            }
        }
        if (m_last >= 0)
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
        // Eight pixels at once, since most of a row that differs is still equal.
        constexpr int kBlock = 8;
        int begin = m_first; // of those to be looked at one by one
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
    }

    // Fills that differ as a whole: `count` pixels of one colour, in either picture, at once. False
    // when they are not, or have to be looked at one by one.
    bool MarkUniform(const std::uint8_t* p, const std::uint8_t* q, int x, int count)
    {
        const std::size_t allButOne = std::size_t(count - 1) * 4;
        if (m_hasIgnored || std::memcmp(q, q + 4, allButOne) != 0 ||
            std::memcmp(p, p + 4, allButOne) != 0)
        {
            return false;
        }
        std::fill(m_row + x, m_row + x + count,
                  m_pairs.IsOver(Word(p), Word(q)) ? Mark::Over : Mark::Within);
        return true;
    }

    void MarkEach(const std::uint8_t* p, const std::uint8_t* q, int x, int end)
    {
        static_assert(int(Mark::Over) == int(Mark::Within) + 1);
        Mark* const row = m_row;
        int unknown[kLanes];
        int count = 0;
        for (; x < end; ++x)
        {
            const std::uint32_t a = Word(p + 4 * x), b = Word(q + 4 * x);
            if (a == b || row[x] == Mark::Ignored)
            {
                continue;
            }
            const PairTable::Answer answer = m_pairs.Find(a, b);
            row[x] = Mark(int(Mark::Within) + int(answer));
            if (answer == PairTable::Answer::Unknown)
            {
                unknown[count++] = x;
                if (count == kLanes)
                {
                    MarkNew(p, q, unknown, count);
                    count = 0;
                }
            }
        }
        if (count > 0)
        {
            MarkNew(p, q, unknown, count);
        }
    }

    void MarkNew(const std::uint8_t* p, const std::uint8_t* q, const int* columns, int count)
    {
        Words a{}, b{};
        for (int i = 0; i < count; ++i)
        {
            a[i] = Word(p + 4 * columns[i]);
            b[i] = Word(q + 4 * columns[i]);
        }
        const std::array<bool, kLanes> areOver = m_pairs.AreOver(a, b, count);
        for (int i = 0; i < count; ++i)
        {
            m_row[columns[i]] = areOver[std::size_t(i)] ? Mark::Over : Mark::Within;
        }
    }

    void CloseRow(int y)
    {
        Mark* const end = m_row + m_last + 1;
        const std::int64_t within = std::count(m_row + m_first, end, Mark::Within);
        const std::int64_t over = std::count(m_row + m_first, end, Mark::Over);
        m_result.differentPixels += within + over;
        m_result.overTolerance += over;
        m_marks.overInRow[std::size_t(y)] = int(over);
        m_marks.different.Include(m_first, y);
        m_marks.different.Include(m_last, y);
        if (over == 0)
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
    // The row at hand, and where in it marks lie.
    Mark* m_row = nullptr;
    int m_first = 0, m_last = -1;
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
