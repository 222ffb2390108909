// SPDX-License-Identifier: MIT
#include <debugdraw/Axes.h>

#include <debugdraw/NiceNumbers.h>
#include <debugdraw/Paper.h>
#include <debugdraw/TextWidth.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace boxreel
{
namespace
{

// All lengths in pixels.
constexpr double kBeside = 1.0; // from the picture to an axis, so that nothing is covered
constexpr double kTick = 5.0;
constexpr double kGap = 4.0;         // between a tick and its number
constexpr double kLetterGap = 14.0;  // minimum distance of two numbers
constexpr double kTickHeight = 45.0; // minimum distance of two ticks of the vertical axis

constexpr const char* kUnit = " m"; // of the last number that fits

// Ticks closer to the end than this fraction of a step are included.
constexpr double kRounding = 1e-6;

/// True if numbers in this view are distinct.
bool HasTicks(const Camera& view)
{
    constexpr double kMaxPixels = 1e12; // from the origin; a double resolves a thousand times as
                                        // many
    const double scale = view.pixelsPerMeter;
    return scale > 1e-12 && scale < 1e12 && std::abs(view.centerX) * scale < kMaxPixels &&
           std::abs(view.centerY) * scale < kMaxPixels;
}

struct Range
{
    double lower, upper; // [m]
};

Range Across(const Camera& view)
{
    const double half = 0.5 * view.width / view.pixelsPerMeter;
    return {view.centerX - half, view.centerX + half};
}

Range Upwards(const Camera& view)
{
    const double half = 0.5 * view.height / view.pixelsPerMeter;
    return {view.centerY - half, view.centerY + half};
}

struct Label
{
    double tick; // [m]
    std::string text;
};

/// The last label has the unit.
std::vector<Label> Labels(const Range& range, double step)
{
    std::vector<Label> labels;
    for (const double tick : Ticks(range.lower, range.upper, step))
    {
        labels.push_back({tick, NumberBy(tick, step)});
    }
    if (!labels.empty())
    {
        labels.back().text += kUnit;
    }
    return labels;
}

double WidestOf(const std::vector<Label>& labels)
{
    double widest = 0.0;
    for (const Label& label : labels)
    {
        widest = std::max(widest, TextWidth(label.text));
    }
    return widest;
}

double StepUpwards(const Camera& view)
{
    return NiceAbove(kTickHeight / view.pixelsPerMeter);
}

/// Returns the smallest step whose numbers fit beside each other.
double StepAcross(const Camera& view)
{
    double step = StepUpwards(view);
    while (step * view.pixelsPerMeter < 1.5 * WidestOf(Labels(Across(view), step)) + kLetterGap)
    {
        step = NiceAbove(step * 1.5);
    }
    return step;
}

/// Numbers are centred on their ticks, with or without the unit; those that do not fit are omitted.
void AddAcross(const Paper& paper, const Camera& view, PixelPoint corner)
{
    const double y = corner.y + view.height + kBeside;
    const double right = corner.x + view.width;
    const Range range = Across(view);
    const double step = StepAcross(view);
    const std::vector<double> ticks = Ticks(range.lower, range.upper, step);
    const auto middle = [&](double tick) {
        return corner.x + (tick - range.lower) * view.pixelsPerMeter;
    };
    const auto left = [&](double tick) {
        return middle(tick) - 0.5 * TextWidth(NumberBy(tick, step));
    };
    const auto fits = [&](double tick, const std::string& text) {
        return left(tick) >= corner.x - RoomForAxis(view) &&
               left(tick) + TextWidth(text) <= right + kAxisOver;
    };
    const auto unit = std::find_if(ticks.rbegin(), ticks.rend(), [&](double tick) {
        return fits(tick, NumberBy(tick, step) + kUnit);
    });
    paper.Line({corner.x - kBeside, y}, {right, y}, kNoteInk);
    for (const double& tick : ticks)
    {
        paper.Line({middle(tick), y}, {middle(tick), y + kTick}, kNoteInk);
        const bool hasUnit = unit != ticks.rend() && &tick == &*unit;
        const std::string text = NumberBy(tick, step) + (hasUnit ? kUnit : "");
        if (fits(tick, text))
        {
            paper.Text({left(tick), y + kTick + kGap}, text, {0.0, 0.0}, kNoteInk);
        }
    }
}

void AddUpwards(const Paper& paper, const Camera& view, PixelPoint corner)
{
    const double bottom = corner.y + view.height;
    const Range range = Upwards(view);
    const double x = corner.x - kBeside;
    paper.Line({x, corner.y}, {x, bottom + kBeside}, kNoteInk);
    for (const Label& label : Labels(range, StepUpwards(view)))
    {
        const double y = bottom - (label.tick - range.lower) * view.pixelsPerMeter;
        paper.Line({x - kTick, y}, {x, y}, kNoteInk);
        paper.Text({x - kTick - kGap, y}, label.text, {1.0, 0.5}, kNoteInk);
    }
}

} // namespace

std::vector<double> Ticks(double lower, double upper, double step)
{
    std::vector<double> ticks;
    const double first = std::ceil(lower / step - kRounding);
    const double last = std::floor(upper / step + kRounding);
    // Integers, which are exact. NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter)
    for (double i = first; i <= last; i += 1.0)
    {
        ticks.push_back(i * step);
    }
    return ticks;
}

int RoomForAxis(const Camera& view)
{
    if (!HasTicks(view))
    {
        return 0;
    }
    const double numbers = WidestOf(Labels(Upwards(view), StepUpwards(view)));
    return static_cast<int>(std::ceil(numbers + kTick + 2.0 * kGap));
}

void AddAxes(DrawList& list, const Camera& paper, const Camera& view, Vec2 corner)
{
    if (!HasTicks(view))
    {
        return;
    }
    const Paper sheet(list, paper);
    AddAcross(sheet, view, {corner.x, corner.y});
    AddUpwards(sheet, view, {corner.x, corner.y});
}

void AddOriginMark(DrawList& list, const Camera& view)
{
    constexpr double kArm = 9.0;
    constexpr double kRadius = 4.5;
    const Paper paper(list, view);
    const PixelPoint at{0.5 * view.width - view.centerX * view.pixelsPerMeter,
                        0.5 * view.height + view.centerY * view.pixelsPerMeter};
    paper.Line({at.x - kArm, at.y}, {at.x + kArm, at.y}, kInk);
    paper.Line({at.x, at.y - kArm}, {at.x, at.y + kArm}, kInk);
    paper.Circle(at, kRadius, kInk);
}

} // namespace boxreel
