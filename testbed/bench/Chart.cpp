// SPDX-License-Identifier: MIT
#include "Chart.h"

#include "ChartCairo.h"
#include "ChartParts.h"

namespace boxreel
{

Result<std::vector<std::uint8_t>> EncodeChart(const Chart& chart, ChartFormat format)
{
    return std::visit(
        [format](const auto& one) {
            return PaintFile(format, one.frame.width, int(std::ceil(HeightOf(one))),
                             [&one](ChartCanvas& canvas) { Paint(canvas, one); });
        },
        chart);
}

} // namespace boxreel
