// SPDX-License-Identifier: MIT
#include <golden/Compare.h>

#include "DifferencePicture.h"
#include "EdgeRule.h"
#include "OkLab.h"

#include <debugdraw/Nearest.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstring>
#include <numeric>
#include <vector>

namespace boxreel
{

namespace
{

[[maybe_unused]] bool IsWhole(const Frame& frame)
{
    return frame.width >= 0 && frame.height >= 0 &&
           frame.rgba.size() == std::size_t(frame.width) * std::size_t(frame.height) * 4;
}

// The shortest text that reads back, whatever the locale.
std::string Number(double value)
{
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

std::string Rounded(double value)
{
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr;
    return {text, end};
}

std::string Pixels(std::int64_t count)
{
    return std::to_string(count) + (count == 1 ? " pixel" : " pixels");
}

// Debug drawings have few colours, so the same pair of pixels comes again and again: distances are
// kept in a small table, each pair at one fixed place. A hit has the bits that computing would
// give.
class DistanceTable
{
public:
    // Of two pixels' bytes as they lie in memory.
    double Get(std::uint32_t p, std::uint32_t q)
    {
        const std::uint64_t key = std::uint64_t(p) << 32 | q;
        // Multiplied by 2^64 over the golden ratio, the top bits mix all the others.
        Entry& entry = m_entries[key * 0x9e3779b97f4a7c15u >> (64 - kBits)];
        if (entry.key != key)
        {
            std::uint8_t bytes[8];
            std::memcpy(bytes, &p, 4);
            std::memcpy(bytes + 4, &q, 4);
            entry = {key, PixelDistance(bytes, bytes + 4)};
        }
        return entry.distance;
    }

private:
    static constexpr int kBits = 12;
    struct Entry
    {
        std::uint64_t key = 0; // of two equal pixels, at distance 0
        double distance = 0.0;
    };
    std::vector<Entry> m_entries = std::vector<Entry>(std::size_t(1) << kBits);
};

// One run over both pictures: counts into the comparison, one mark for every pixel.
class Marker
{
public:
    Marker(const Frame& expected, const Frame& actual, const CompareSettings& settings,
           Comparison& result)
        : m_expected(expected), m_actual(actual), m_settings(settings), m_result(result)
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
        m_row = nullptr;
        m_y = y;
        const int common = y < std::min(m_expected.height, m_actual.height)
                               ? std::min(m_expected.width, m_actual.width)
                               : 0;
        if (common > 0)
        {
            MarkCommon(m_expected.Pixel(0, y), m_actual.Pixel(0, y), common);
        }
        for (int x = common; x < m_marks.width; ++x)
        {
            OpenRow(x);
            if (m_row[x] != Mark::Ignored)
            {
                Set(x, true);
            }
        }
        if (m_row && m_last >= 0)
        {
            CloseRow();
        }
    }

    const Marks& GetMarks() const { return m_marks; }
    double LargestDistance() const { return m_largest; }

private:
    void MarkCommon(const std::uint8_t* p, const std::uint8_t* q, int count)
    {
        // Eight pixels at once, since most of a row that differs is still equal.
        constexpr int kBlock = 8;
        for (int x = 0; x < count;)
        {
            if (count - x >= kBlock && std::memcmp(p + 4 * x, q + 4 * x, 4 * kBlock) == 0)
            {
                x += kBlock;
                continue;
            }
            if (count - x >= kBlock && MarkUniform(p + 4 * x, q + 4 * x, x, kBlock))
            {
                x += kBlock;
                continue;
            }
            for (const int end = std::min(x + kBlock, count); x < end; ++x)
            {
                const std::uint32_t a = Word(p + 4 * x), b = Word(q + 4 * x);
                if (a != b)
                {
                    MarkDifferent(a, b, q + 4 * x, x);
                }
            }
        }
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
        const double distance = m_table.Get(Word(p), Word(q));
        const bool isOver = distance > m_settings.tolerance || m_settings.tolerance <= 0.0;
        if (isOver && m_settings.edgeShift > 0.0)
        {
            return false;
        }
        OpenRow(x);
        m_largest = std::max(m_largest, distance);
        std::fill(m_row + x, m_row + x + count, isOver ? Mark::Over : Mark::Within);
        m_last = x + count - 1;
        m_inRow += count;
        m_overInRow += isOver ? count : 0;
        return true;
    }

    static std::uint32_t Word(const std::uint8_t* pixel)
    {
        std::uint32_t word;
        std::memcpy(&word, pixel, 4);
        return word;
    }

    // Branches that depend on the pixels would be guessed wrong in every other pixel of a noisy
    // picture, so there are none but the last.
    void MarkDifferent(std::uint32_t expected, std::uint32_t actual, const std::uint8_t* q, int x)
    {
        OpenRow(x);
        if (m_hasIgnored && m_row[x] == Mark::Ignored)
        {
            return;
        }
        const double distance = m_table.Get(expected, actual);
        m_largest = std::max(m_largest, distance);
        const bool isOver = distance > m_settings.tolerance || m_settings.tolerance <= 0.0;
        if (isOver && m_settings.edgeShift > 0.0 &&
            EdgeExplains(m_expected, x, m_y, q, m_settings.tolerance, m_settings.edgeShift))
        {
            ++m_result.excusedAtEdges;
            Set(x, false);
            return;
        }
        Set(x, isOver);
    }

    void OpenRow(int x)
    {
        if (!m_row)
        {
            m_row = m_marks.Row(m_y);
            m_first = x;
            m_last = -1;
            m_inRow = m_overInRow = 0;
        }
    }

    void Set(int x, bool isOver)
    {
        static_assert(int(Mark::Over) == int(Mark::Within) + 1);
        m_row[x] = Mark(int(Mark::Within) + int(isOver));
        m_last = x;
        ++m_inRow;
        m_overInRow += isOver;
    }

    void CloseRow()
    {
        m_result.differentPixels += m_inRow;
        m_result.overTolerance += m_overInRow;
        m_marks.different.Include(m_first, m_y);
        m_marks.different.Include(m_last, m_y);
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
        m_marks.over.Include(firstOver, m_y);
        m_marks.over.Include(lastOver, m_y);
        if (m_result.firstX < 0)
        {
            m_result.firstX = firstOver;
            m_result.firstY = m_y;
        }
    }

    const Frame& m_expected;
    const Frame& m_actual;
    const CompareSettings& m_settings;
    Comparison& m_result;
    DistanceTable m_table;
    Marks m_marks;
    bool m_hasIgnored;
    double m_largest = 0.0; // distance
    // The row at hand, and where in it marks lie.
    Mark* m_row = nullptr; // null while it has none
    int m_y = 0;
    int m_first = 0, m_last = -1;
    int m_inRow = 0, m_overInRow = 0;
};

// One row's marks over the tolerance, times `sign`, onto the columns of their box.
void AddRow(const Marks& marks, int y, int sign, std::vector<int>& inColumn)
{
    const Mark* row =
        marks.marks.data() + std::size_t(y) * std::size_t(marks.width) + marks.over.x0;
    for (std::size_t i = 0; i < inColumn.size(); ++i)
    {
        inColumn[i] += row[i] == Mark::Over ? sign : 0;
    }
}

// The largest sum of `size` columns of which the last is one of begin to end - 1. `before`: the sum
// of the `size` columns before these.
std::int64_t WorstEndingIn(const std::vector<int>& inColumn, int begin, int end, int size,
                           std::int64_t before)
{
    std::int64_t sum = before;
    std::int64_t worst = 0;
    for (int x = begin; x < end; ++x)
    {
        sum += inColumn[std::size_t(x)] - (x >= size ? inColumn[std::size_t(x - size)] : 0);
        worst = std::max(worst, sum);
    }
    return worst;
}

// Most marks over the tolerance in any window of size x size pixels. `inColumn` holds, for each
// column, those of the last `size` rows; a sum slides along it. Windows that stick out of the
// picture need no care: one that lies inside holds the same pixels and more.
std::int64_t WorstWindow(const Marks& marks, int size)
{
    const PixelBox& box = marks.over;
    const int width = box.x1 - box.x0 + 1;
    std::int64_t worst = 0;
    std::vector<int> inColumn(std::size_t(width), 0);
    const std::int64_t full = std::int64_t(size) * size; // no window holds more
    for (int y = box.y0; y <= box.y1 && worst < full; ++y)
    {
        AddRow(marks, y, 1, inColumn);
        if (y - box.y0 >= size)
        {
            AddRow(marks, y - size, -1, inColumn);
        }
        // A window ends within one block of columns and begins in it or the one before, so it holds
        // no more than the two together.
        std::int64_t before = 0;
        for (int x = 0; x < width; x += size)
        {
            const int end = std::min(width, x + std::min(size, width - x));
            const std::int64_t block =
                std::accumulate(inColumn.begin() + x, inColumn.begin() + end, std::int64_t(0));
            if (before + block > worst)
            {
                worst = std::max(worst, WorstEndingIn(inColumn, x, end, size, before));
            }
            before = block;
            if (end == width)
            {
                break;
            }
        }
    }
    return worst;
}

std::string Size(const Frame& frame)
{
    return std::to_string(frame.width) + "x" + std::to_string(frame.height);
}

std::string Limits(const CompareSettings& settings)
{
    const std::string side = std::to_string(settings.densityWindow);
    std::string text = settings.preset + " allows ";
    if (settings.maxPixels != kAnyNumberOfPixels)
    {
        text += Pixels(settings.maxPixels);
    }
    if (settings.maxRatio < 1.0 || settings.maxPixels == kAnyNumberOfPixels)
    {
        text += (settings.maxPixels == kAnyNumberOfPixels ? "" : ", ") +
                Rounded(100.0 * settings.maxRatio) + " %";
    }
    text += " over a distance of " + Number(settings.tolerance);
    if (settings.edgeShift > 0.0)
    {
        text += " and edges " + Number(settings.edgeShift) + " px elsewhere";
    }
    return text + ", " + std::to_string(settings.maxInWindow) + " in any " + side + "x" + side;
}

std::string Verdict(const Comparison& result, const CompareSettings& settings)
{
    std::string text = result.equal ? "equal: " : "different: ";
    const std::string ignored =
        result.ignored > 0 ? ", " + Pixels(result.ignored) + " ignored" : std::string();
    if (result.differentPixels == 0)
    {
        return text + "no bit differs" + ignored + " (" + Limits(settings) + ")";
    }
    if (result.overTolerance == 0)
    {
        text += Pixels(result.differentPixels) + " by no more than " +
                (result.excusedAtEdges > 0 ? "tolerance and edges allow" : "the tolerance");
    }
    else
    {
        text += Pixels(result.overTolerance) + " over the tolerance, first at " +
                std::to_string(result.firstX) + "," + std::to_string(result.firstY) + ", up to " +
                std::to_string(result.worstWindow) + " in a window";
    }
    return text + ", largest distance " + Rounded(result.largestDistance) + ignored + " (" +
           Limits(settings) + ")";
}

std::string SizeVerdict(const Frame& expected, const Frame& actual, const CompareSettings& settings)
{
    return "different: the expected picture has " + Size(expected) + " pixels, the actual one " +
           Size(actual) + " (" + Limits(settings) + ")";
}

} // namespace

CompareSettings CompareSettings::Exact()
{
    CompareSettings settings;
    settings.preset = "exact";
    settings.tolerance = 0.0;
    settings.maxPixels = 0;
    settings.maxInWindow = 0;
    return settings;
}

CompareSettings CompareSettings::SameMachine()
{
    return {};
}

CompareSettings CompareSettings::CrossMachine()
{
    CompareSettings settings;
    settings.preset = "cross-machine";
    settings.tolerance = 0.01;
    settings.edgeShift = 0.2;
    settings.maxPixels = kAnyNumberOfPixels;
    settings.maxRatio = 0.0005;
    settings.maxInWindow = 8;
    return settings;
}

std::vector<std::string> CompareSettings::PresetNames()
{
    return {Exact().preset, SameMachine().preset, CrossMachine().preset};
}

Result<CompareSettings> CompareSettings::Preset(const std::string& option, const std::string& name)
{
    for (const CompareSettings& settings : {Exact(), SameMachine(), CrossMachine()})
    {
        if (settings.preset == name)
        {
            return settings;
        }
    }
    return NotOneOf(option, name, PresetNames());
}

Comparison Compare(const Frame& expected, const Frame& actual, const CompareSettings& settings)
{
    assert(IsWhole(expected) && IsWhole(actual) && "a frame holds width * height * 4 bytes");
    assert(settings.densityWindow >= 1 && "a window is at least one pixel");

    Comparison result;
    result.sameSize = expected.width == actual.width && expected.height == actual.height;
    Marker marker(expected, actual, settings, result);
    const Marks& marks = marker.GetMarks();
    const std::size_t rowBytes = std::size_t(marks.width) * 4;
    for (int y = 0; y < marks.height && marks.width > 0; ++y)
    {
        if (!result.sameSize ||
            std::memcmp(expected.Pixel(0, y), actual.Pixel(0, y), rowBytes) != 0)
        {
            marker.MarkRow(y);
        }
    }
    result.largestDistance = marker.LargestDistance();
    if (result.overTolerance > 0)
    {
        result.worstWindow = WorstWindow(marks, std::max(settings.densityWindow, 1));
    }
    result.equal = result.sameSize && result.overTolerance <= settings.maxPixels &&
                   double(result.overTolerance) <= settings.maxRatio * double(result.compared) &&
                   result.worstWindow <= settings.maxInWindow;
    result.verdict =
        result.sameSize ? Verdict(result, settings) : SizeVerdict(expected, actual, settings);
    if (settings.paintsDifference)
    {
        result.difference = PaintDifference(expected, marks);
    }
    return result;
}

} // namespace boxreel
