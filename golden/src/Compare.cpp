// SPDX-License-Identifier: MIT
#include <golden/Compare.h>

#include "DifferencePicture.h"
#include "OkLab.h"

#include <debugdraw/Nearest.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cstring>
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
    double Get(const std::uint8_t* p, const std::uint8_t* q)
    {
        std::uint32_t a, b;
        std::memcpy(&a, p, 4);
        std::memcpy(&b, q, 4);
        const std::uint64_t key = std::uint64_t(a) << 32 | b;
        // Multiplied by 2^64 over the golden ratio, the top bits mix all the others.
        Entry& entry = m_entries[key * 0x9e3779b97f4a7c15u >> (64 - kBits)];
        if (entry.key != key)
        {
            entry = {key, PixelDistance(p, q)};
        }
        return entry.distance;
    }

private:
    static constexpr int kBits = 10;
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
    Marker(int width, int height, double tolerance, Comparison& result)
        : m_tolerance(tolerance), m_result(result)
    {
        m_marks.width = width;
        m_marks.height = height;
    }

    void MarkRow(const Frame& expected, const Frame& actual, int y)
    {
        const int common = y < std::min(expected.height, actual.height)
                               ? std::min(expected.width, actual.width)
                               : 0;
        if (common > 0)
        {
            MarkCommon(expected.Pixel(0, y), actual.Pixel(0, y), common, y);
        }
        for (int x = common; x < m_marks.width; ++x)
        {
            Set(x, y, Mark::Over);
        }
    }

    const Marks& GetMarks() const { return m_marks; }

private:
    void MarkCommon(const std::uint8_t* p, const std::uint8_t* q, int count, int y)
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
            for (const int end = std::min(x + kBlock, count); x < end; ++x)
            {
                if (std::memcmp(p + 4 * x, q + 4 * x, 4) != 0)
                {
                    MarkDifferent(p + 4 * x, q + 4 * x, x, y);
                }
            }
        }
    }

    void MarkDifferent(const std::uint8_t* p, const std::uint8_t* q, int x, int y)
    {
        const double distance = m_table.Get(p, q);
        m_result.largestDistance = std::max(m_result.largestDistance, distance);
        Set(x, y, m_tolerance > 0.0 && distance <= m_tolerance ? Mark::Within : Mark::Over);
    }

    void Set(int x, int y, Mark mark)
    {
        m_marks.Set(x, y, mark);
        ++m_result.differentPixels;
        if (mark == Mark::Over && m_result.overTolerance++ == 0)
        {
            m_result.firstX = x;
            m_result.firstY = y;
        }
    }

    double m_tolerance;
    Comparison& m_result;
    DistanceTable m_table;
    Marks m_marks;
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

// Most marks over the tolerance in any window of size x size pixels. `inColumn` holds, for each
// column, those of the last `size` rows; a sum slides along it. Windows that stick out of the
// picture need no care: one that lies inside holds the same pixels and more.
std::int64_t WorstWindow(const Marks& marks, int size)
{
    const PixelBox& box = marks.over;
    const int width = box.x1 - box.x0 + 1;
    std::int64_t worst = 0;
    std::vector<int> inColumn(std::size_t(width), 0);
    for (int y = box.y0; y <= box.y1; ++y)
    {
        AddRow(marks, y, 1, inColumn);
        if (y - box.y0 >= size)
        {
            AddRow(marks, y - size, -1, inColumn);
        }
        std::int64_t sum = 0;
        for (int x = 0; x < width; ++x)
        {
            sum += inColumn[std::size_t(x)] - (x >= size ? inColumn[std::size_t(x - size)] : 0);
            worst = std::max(worst, sum);
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
    return settings.preset + " allows " + Pixels(settings.maxPixels) + " over a distance of " +
           Number(settings.tolerance) + ", " + std::to_string(settings.maxInWindow) + " in any " +
           side + "x" + side;
}

std::string Verdict(const Comparison& result, const CompareSettings& settings)
{
    std::string text = result.equal ? "equal: " : "different: ";
    if (result.differentPixels == 0)
    {
        return text + "no bit differs (" + Limits(settings) + ")";
    }
    if (result.overTolerance == 0)
    {
        text += Pixels(result.differentPixels) + " by no more than the tolerance";
    }
    else
    {
        text += Pixels(result.overTolerance) + " over the tolerance, first at " +
                std::to_string(result.firstX) + "," + std::to_string(result.firstY) + ", up to " +
                std::to_string(result.worstWindow) + " in a window";
    }
    return text + ", largest distance " + Rounded(result.largestDistance) + " (" +
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

std::vector<std::string> CompareSettings::PresetNames()
{
    return {Exact().preset, SameMachine().preset};
}

Result<CompareSettings> CompareSettings::Preset(const std::string& option, const std::string& name)
{
    for (const CompareSettings& settings : {Exact(), SameMachine()})
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

    const int width = std::max(expected.width, actual.width);
    const int height = std::max(expected.height, actual.height);
    const std::size_t rowBytes = std::size_t(width) * 4;
    Comparison result;
    result.sameSize = expected.width == actual.width && expected.height == actual.height;
    Marker marker(width, height, settings.tolerance, result);
    for (int y = 0; y < height && width > 0; ++y)
    {
        if (!result.sameSize ||
            std::memcmp(expected.Pixel(0, y), actual.Pixel(0, y), rowBytes) != 0)
        {
            marker.MarkRow(expected, actual, y);
        }
    }
    if (result.overTolerance > 0)
    {
        result.worstWindow = WorstWindow(marker.GetMarks(), std::max(settings.densityWindow, 1));
    }
    result.equal = result.sameSize && result.overTolerance <= settings.maxPixels &&
                   result.worstWindow <= settings.maxInWindow;
    result.verdict =
        result.sameSize ? Verdict(result, settings) : SizeVerdict(expected, actual, settings);
    result.difference = PaintDifference(expected, marker.GetMarks());
    return result;
}

} // namespace boxreel
