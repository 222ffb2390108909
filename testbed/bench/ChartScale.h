// SPDX-License-Identifier: MIT
#pragma once

#include "Chart.h"

#include <string>
#include <vector>

/// Numbers as places along an axis, and the numbers that are written there.
namespace boxreel
{

struct ChartTick
{
    double value = 0.0;
    std::string text; ///< empty: only a thin line
};

class ChartScale
{
public:
    /// From the least to the largest of `values`, widened to round numbers, laid from `from` to
    /// `to` [points]. What is not finite is passed over.
    ChartScale(const ChartAxis& axis, const std::vector<double>& values, double from, double to);

    double At(double value) const; ///< [points]
    double Low() const { return m_low; }
    double High() const { return m_high; }
    const std::vector<ChartTick>& Ticks() const { return m_ticks; }

private:
    void MakeLinear();
    void MakeLogarithmic();

    bool m_logarithmic;
    double m_from, m_to;
    double m_low = 0.0, m_high = 1.0;
    std::vector<ChartTick> m_ticks;
};

/// 0.05, 7, 12,500: no more digits than `value` has, thousands apart.
std::string ChartNumber(double value);
/// The same, but powers of ten that would need many digits as 10⁻⁷.
std::string ChartPower(double value);

} // namespace boxreel
