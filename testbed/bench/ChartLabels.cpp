// SPDX-License-Identifier: MIT
#include "ChartLabels.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// Only their order of size matters: words on words cannot be read, words on lines can.
constexpr double kOutside = 1000.0;
constexpr double kOnWord = 100.0;
constexpr double kOnMark = 8.0;
constexpr double kOnLine = 3.0;
constexpr double kOfDistance = 0.06; // a point of distance
constexpr double kFree = 0.5;        // what covers no more than this covers nothing

/// From a point to the word beside it; the first two are near enough to need no thin line.
constexpr double kDistances[] = {8.0, 12.0, 20.0, 30.0, 42.0, 56.0, 72.0};
constexpr int kNear = 2;
constexpr std::pair<double, double> kDirections[] = {{1.0, 0.0},   {0.8, -0.6}, {0.8, 0.6},
                                                     {0.0, -1.0},  {0.0, 1.0},  {-1.0, 0.0},
                                                     {-0.8, -0.6}, {-0.8, 0.6}};

bool Overlap(const LabelBox& a, const LabelBox& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Clips the segment to the box side by side (Liang and Barsky, 1984).
bool Crosses(const LabelBox& box, std::pair<double, double> from, std::pair<double, double> to)
{
    const double dx = to.first - from.first, dy = to.second - from.second;
    const std::pair<double, double> sides[] = {{-dx, from.first - box.left},
                                               {dx, box.right - from.first},
                                               {-dy, from.second - box.top},
                                               {dy, box.bottom - from.second}};
    double enter = 0.0, leave = 1.0;
    for (const auto& [speed, room] : sides)
    {
        if (speed == 0.0 && room < 0.0)
        {
            return false;
        }
        if (speed != 0.0)
        {
            const double at = room / speed;
            enter = speed < 0.0 ? std::max(enter, at) : enter;
            leave = speed > 0.0 ? std::min(leave, at) : leave;
        }
    }
    return enter < leave;
}

} // namespace

void LabelLayout::AvoidMark(double x, double y, double radius, double weight)
{
    m_marks.push_back({{x - radius, y - radius, x + radius, y + radius}, weight});
}

void LabelLayout::AvoidLine(double x1, double y1, double x2, double y2)
{
    m_lines.push_back({{x1, y1}, {x2, y2}});
}

double LabelLayout::CostOf(const LabelBox& box) const
{
    double cost = 0.0;
    if (box.left < m_room.left || box.right > m_room.right || box.top < m_room.top ||
        box.bottom > m_room.bottom)
    {
        cost += kOutside;
    }
    for (const LabelBox& word : m_words)
    {
        // Two words that nearly touch read as one.
        const LabelBox around{word.left - 5.0, word.top, word.right + 5.0, word.bottom};
        cost += Overlap(box, around) ? kOnWord : 0.0;
    }
    for (const Mark& mark : m_marks)
    {
        cost += Overlap(box, mark.box) ? kOnMark * mark.weight : 0.0;
    }
    for (const auto& [from, to] : m_lines)
    {
        cost += Crosses(box, from, to) ? kOnLine : 0.0;
    }
    return cost;
}

double LabelLayout::CostOfPointer(const LabelBox& box, double x, double y) const
{
    const std::pair<double, double> near{std::clamp(x, box.left, box.right),
                                         std::clamp(y, box.top, box.bottom)};
    double cost = 0.0;
    for (const LabelBox& word : m_words)
    {
        cost += Crosses(word, {x, y}, near) ? kOnWord : 0.0;
    }
    for (const Mark& mark : m_marks)
    {
        // It would point to the wrong one.
        const bool isOwn = std::abs(0.5 * (mark.box.left + mark.box.right) - x) < 0.01 &&
                           std::abs(0.5 * (mark.box.top + mark.box.bottom) - y) < 0.01;
        cost += !isOwn && Crosses(mark.box, {x, y}, near) ? kOnMark * mark.weight : 0.0;
    }
    return cost;
}

LabelBox LabelLayout::PlaceAtOneOf(const std::vector<LabelBox>& places)
{
    LabelBox best = places.front();
    double least = CostOf(best);
    for (const LabelBox& place : places)
    {
        const double cost = CostOf(place);
        best = cost < least ? place : best;
        least = std::min(least, cost);
    }
    m_words.push_back(best);
    return best;
}

std::optional<LabelBox> LabelLayout::PlaceBeside(double x, double y, double width, double height,
                                                 bool optional)
{
    std::optional<LabelBox> best;
    double least = 0.0;
    for (int i = 0; i < (optional ? kNear : int(std::size(kDistances))); ++i)
    {
        const double distance = kDistances[i];
        for (const auto& [dx, dy] : kDirections)
        {
            const double centreX =
                x + dx * distance + std::copysign(dx != 0.0 ? 0.5 : 0.0, dx) * width;
            const double centreY = y + dy * (distance + 0.5 * height);
            const LabelBox box{centreX - 0.5 * width, centreY - 0.5 * height, centreX + 0.5 * width,
                               centreY + 0.5 * height};
            const double cost = CostOf(box) + (i < kNear ? 0.0 : CostOfPointer(box, x, y));
            const double all = cost + kOfDistance * distance;
            if ((!optional || cost <= kFree) && (!best || all < least))
            {
                best = box;
                least = all;
            }
        }
    }
    if (best)
    {
        m_words.push_back(*best);
    }
    return best;
}

} // namespace boxreel
