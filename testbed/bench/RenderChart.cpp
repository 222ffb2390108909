// SPDX-License-Identifier: MIT
#include "ChartScale.h"
#include "Format.h"
#include "RenderBench.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

/// A curve of each renderer that measured such frames, through the numbers of shapes.
struct Family
{
    ChartStroke stroke;
    RenderTimes RenderFigures::*times;
    const char* legend;
};

constexpr Family kFamilies[] = {
    {ChartStroke::Solid, &RenderFigures::full, "all shapes changed"},
    {ChartStroke::Dashed, &RenderFigures::together, "5 % changed, together"},
    {ChartStroke::Dotted, &RenderFigures::apart, "5 % changed, apart"},
};

constexpr double kNearShare = 0.8; // of the time of a full redraw: no room between the points

bool IsDrawn(const RenderFigures& figures)
{
    return figures.failure.empty() && figures.threads == "0" && figures.rms > 0.0;
}

class RenderPainter
{
public:
    explicit RenderPainter(const std::vector<RenderResult>& results) : m_results(results)
    {
        std::sort(m_results.begin(), m_results.end(),
                  [](const auto& a, const auto& b) { return a.info.count < b.info.count; });
    }

    LineChart Make()
    {
        for (const std::string& method : MethodsToDraw())
        {
            for (const Family& family : kFamilies)
            {
                AppendCurve(method, family);
            }
            m_chart.legend.push_back({{method, m_methods++}, LegendKey::Disc});
        }
        AppendStrokes();
        AppendGoals();
        Frame();
        return std::move(m_chart);
    }

private:
    const RenderFigures* Find(const RenderResult& result, const std::string& method) const
    {
        for (const RenderFigures& figures : result.methods)
        {
            if (figures.method == method && IsDrawn(figures))
            {
                return &figures;
            }
        }
        return nullptr;
    }

    /// In every case the same errors: the one would cover the other.
    bool DrawAlike(const std::string& a, const std::string& b) const
    {
        return std::all_of(m_results.begin(), m_results.end(), [&](const RenderResult& result) {
            const RenderFigures* const one = Find(result, a);
            const RenderFigures* const other = Find(result, b);
            return one != nullptr && other != nullptr && one->rms == other->rms &&
                   one->most == other->most;
        });
    }

    std::vector<std::string> MethodsToDraw()
    {
        std::vector<std::string> methods;
        std::vector<std::string> seen;
        for (const RenderResult& result : m_results)
        {
            for (const RenderFigures& figures : result.methods)
            {
                if (!IsDrawn(figures) ||
                    std::find(seen.begin(), seen.end(), figures.method) != seen.end())
                {
                    continue;
                }
                seen.push_back(figures.method);
                const auto twin =
                    std::find_if(methods.begin(), methods.end(), [&](const std::string& method) {
                        return DrawAlike(method, figures.method);
                    });
                if (twin == methods.end())
                {
                    methods.push_back(figures.method);
                }
                else
                {
                    m_twins.push_back("\"" + figures.method + "\" draws what \"" + *twin +
                                      "\" does and is left out.");
                }
            }
        }
        return methods;
    }

    void AppendCurve(const std::string& method, const Family& family)
    {
        ChartLine line;
        line.series = {method, m_methods, family.stroke};
        for (const RenderResult& result : m_results)
        {
            const RenderFigures* const figures = Find(result, method);
            const double time = figures != nullptr ? (figures->*family.times).cpu : kNoValue;
            if (time > 0.0)
            {
                // All frames of a picture have the same error: where they take as long, one number
                // is enough for all.
                const bool isNear =
                    &family != &kFamilies[0] && time > kNearShare * figures->full.cpu;
                // Of one picture all points have the same number: what has changed tells them
                // apart.
                const std::string label =
                    m_results.size() == 1 ? family.legend : ChartNumber(result.info.count);
                ChartPoint point{time * 1e3, figures->rms, isNear ? "" : label};
                point.mayLackLabel = &family != &kFamilies[0];
                line.points.push_back(point);
            }
        }
        if (!line.points.empty())
        {
            m_chart.lines.push_back(std::move(line));
        }
    }

    void AppendStrokes()
    {
        for (const Family& family : kFamilies)
        {
            const bool isUsed =
                m_results.size() > 1 && // a point has no stroke
                std::any_of(m_chart.lines.begin(), m_chart.lines.end(), [&](const ChartLine& line) {
                    return line.series.stroke == family.stroke;
                });
            if (isUsed)
            {
                m_chart.legend.push_back({{family.legend, 0, family.stroke}, LegendKey::Stroke});
            }
        }
    }

    /// The first rule across and the first upright one bound the corner that is tinted.
    void AppendGoals()
    {
        for (const RenderResult& result : m_results)
        {
            const RenderCase& info = result.info;
            const std::string shapes = ChartNumber(info.count) + " shapes";
            const auto upright = [&](double goal, const char* what) {
                m_chart.rules.push_back(
                    {goal * 1e3, true,
                     "goal, " + shapes + ", " + what + ": " + ChartNumber(goal * 1e3) + " ms"});
            };
            if (info.goalFull > 0.0 && info.goalRms > 0.0)
            {
                m_chart.rules.push_back(
                    {info.goalRms, false, "goal: " + ChartNumber(info.goalRms)});
                upright(info.goalFull, "all");
                m_chart.tintsCorner = true;
            }
            if (info.goalChanged > 0.0)
            {
                upright(info.goalChanged, "5 %");
            }
        }
    }

    void Frame()
    {
        const RenderCase& info = m_results.front().info;
        m_chart.frame.title = Format("Drawing at %d x %d", info.width, info.height);
        m_chart.frame.subtitle =
            std::string("CPU time of a frame, one raster thread, against the error at edges; ") +
            (m_results.size() > 1 ? "along each curve the number of shapes"
                                  : ChartNumber(info.count) + " shapes");
        m_chart.frame.notes = {
            "Error: root mean square of the differences from 16 x 16 samples a pixel, over the red,"
            " green and blue of the pixels whose samples are not all alike,",
            "in steps of 8 bits."};
        for (const std::string& twin : m_twins)
        {
            m_chart.frame.notes.back() += " " + twin;
        }
        m_chart.x = {"CPU time of a frame [ms]", true};
        m_chart.y = {"error at edges [1/255]", true};
    }

    std::vector<RenderResult> m_results;
    LineChart m_chart;
    std::vector<std::string> m_twins; ///< a sentence for each
    int m_methods = 0;
};

} // namespace

Result<LineChart> RenderChart(const std::vector<RenderResult>& results)
{
    const bool any = std::any_of(results.begin(), results.end(), [](const RenderResult& result) {
        return std::any_of(result.methods.begin(), result.methods.end(), IsDrawn);
    });
    if (!any)
    {
        return Error{ErrorKind::Unusable, "No renderer has run, so there is nothing to draw."};
    }
    return RenderPainter(results).Make();
}

} // namespace boxreel
