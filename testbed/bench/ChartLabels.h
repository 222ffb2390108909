// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

/// Finds room for words in a plot: beside what they belong to, and not on lines, marks or other
/// words. Knows no letters: whoever asks says how large a word is. Used by line charts only.
namespace boxreel
{

/// An upright rectangle [points].
struct LabelBox
{
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

    double Width() const { return right - left; }
    double Height() const { return bottom - top; }
};

class LabelLayout
{
public:
    /// No word leaves `room`.
    explicit LabelLayout(const LabelBox& room) : m_room(room) {}

    /// A mark of this radius around a point; `weight` 1 is a mark nobody should miss.
    void AvoidMark(double x, double y, double radius, double weight);
    void AvoidLine(double x1, double y1, double x2, double y2);

    /// The best of these places; what is chosen is avoided from then on.
    LabelBox PlaceAtOneOf(const std::vector<LabelBox>& places);
    /// Beside a point and as near as possible. Nothing, when `optional` and no near place is free.
    std::optional<LabelBox> PlaceBeside(double x, double y, double width, double height,
                                        bool optional);

private:
    struct Mark
    {
        LabelBox box;
        double weight;
    };
    using Line = std::pair<std::pair<double, double>, std::pair<double, double>>;

    /// 0: covers nothing.
    double CostOf(const LabelBox& box) const;
    /// The same for the thin line from a word to the point that it stands far from.
    double CostOfPointer(const LabelBox& box, double x, double y) const;

    LabelBox m_room;
    std::vector<Mark> m_marks;
    std::vector<Line> m_lines;
    std::vector<LabelBox> m_words;
};

} // namespace boxreel
