// SPDX-License-Identifier: MIT
#include "AccuracySweep.h"
#include "Benchmark.h"
#include "ChartScale.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

/// A run that has a place along the axis of time.
bool HasTime(const AccuracyFigures& run)
{
    return run.failure.empty() && run.cpu > 0.0;
}

bool HasError(const AccuracyFigures& run)
{
    return run.held && std::isfinite(run.error);
}

/// Settings that differ in one thing: a curve.
struct Family
{
    ChartStroke stroke;
    int AccuracySettings::*varied;
    const char* legend;
    const char* unit; ///< behind the last value
};

constexpr Family kFamilies[] = {
    {ChartStroke::Solid, &AccuracySettings::subSteps, "1 to 16 sub-steps", " sub-steps"},
    {ChartStroke::Dashed, &AccuracySettings::hz, "60 to 480 Hz", " Hz"},
    {ChartStroke::Dotted, &AccuracySettings::velocityIterations, "4/2 to 50/20 iterations", ""},
};

bool IsIn(const Family& family, const AccuracySettings& s, const AccuracySettings& usual)
{
    const auto same = [&](int AccuracySettings::*number) {
        return number == family.varied || s.*number == usual.*number;
    };
    return same(&AccuracySettings::subSteps) && same(&AccuracySettings::hz) &&
           same(&AccuracySettings::velocityIterations);
}

bool IsSame(const AccuracySettings& a, const AccuracySettings& b)
{
    return a.subSteps == b.subSteps && a.hz == b.hz && a.velocityIterations == b.velocityIterations;
}

std::string LabelOf(const Family& family, const AccuracySettings& s, bool isLast)
{
    if (family.varied == &AccuracySettings::velocityIterations)
    {
        return std::to_string(s.velocityIterations) + "/" + std::to_string(s.positionIterations);
    }
    return std::to_string(s.*family.varied) + (isLast ? family.unit : "");
}

class AccuracyPainter
{
public:
    explicit AccuracyPainter(const AccuracyResult& result)
        : m_result(result), m_floor(FloorOf(result))
    {}

    LineChart Make()
    {
        for (const std::string& engine : EnginesOf(m_result))
        {
            AppendEngine(engine);
        }
        for (ChartLine& others : m_others)
        {
            m_chart.lines.push_back(std::move(others)); // behind the curves
        }
        AppendRules();
        AppendLegend();
        Frame();
        return std::move(m_chart);
    }

private:
    /// Errors from there down are drawn there: nothing has no logarithm.
    static double FloorOf(const AccuracyResult& result)
    {
        const double goal = result.info.goal;
        // Where the goal is none at all, things are counted.
        return goal > 0.0 ? std::pow(10.0, std::floor(std::log10(goal) - 3.5)) : 0.5;
    }
    ChartPoint PointOf(const AccuracyFigures& run)
    {
        ChartPoint point{run.CpuOfAFrame() * 1e6, kNoValue, ""};
        if (HasError(run))
        {
            m_reachesFloor = m_reachesFloor || run.error <= m_floor;
            point.y = std::max(run.error, m_floor);
        }
        if (!HasError(run) || !run.ending.empty() || !MissedRemarks(m_result.info, run).empty())
        {
            point.mark = ChartMark::Cross;
            m_anyCross = true;
        }
        return point;
    }

    void AppendEngine(const std::string& engine)
    {
        const AccuracySettings usual = UsualSettings(m_result, engine);
        ChartLine others;
        others.series = {engine, m_engines, ChartStroke::None};
        std::vector<ChartLine> curves;
        for (const Family& family : kFamilies)
        {
            curves.push_back(CurveOf(engine, family, usual));
        }
        for (const AccuracyFigures& run : m_result.runs)
        {
            bool isOnCurve = false;
            for (std::size_t i = 0; i < curves.size(); ++i)
            {
                isOnCurve = isOnCurve ||
                            (!curves[i].points.empty() && IsIn(kFamilies[i], run.settings, usual));
            }
            if (run.engine == engine && HasTime(run) && !isOnCurve)
            {
                others.points.push_back(PointOf(run));
                ChartMark& mark = others.points.back().mark;
                if (mark == ChartMark::Disc)
                {
                    const bool isUsual = IsSame(run.settings, usual);
                    mark = isUsual ? ChartMark::Ring : ChartMark::Speck;
                    m_anySpeck = m_anySpeck || !isUsual;
                }
            }
        }
        for (ChartLine& curve : curves)
        {
            if (!curve.points.empty())
            {
                m_chart.lines.push_back(std::move(curve));
            }
        }
        m_others.push_back(std::move(others));
        m_chart.legend.push_back({{engine, m_engines}, LegendKey::Disc});
        ++m_engines;
    }

    /// The usual settings are a point of every family; it is marked and named in the first.
    ChartLine CurveOf(const std::string& engine, const Family& family,
                      const AccuracySettings& usual)
    {
        std::vector<const AccuracyFigures*> runs;
        for (const AccuracyFigures& run : m_result.runs)
        {
            if (run.engine == engine && HasTime(run) && IsIn(family, run.settings, usual))
            {
                runs.push_back(&run);
            }
        }
        std::sort(runs.begin(), runs.end(), [&](const auto* a, const auto* b) {
            return a->settings.*family.varied < b->settings.*family.varied;
        });
        ChartLine curve;
        curve.series = {engine, m_engines, family.stroke};
        if (runs.size() < 2)
        {
            return curve;
        }
        const bool isFirst =
            usual.subSteps > 1 ? &family == &kFamilies[0] : &family == &kFamilies[1];
        for (const AccuracyFigures* run : runs)
        {
            ChartPoint point = PointOf(*run);
            const bool isUsual = IsSame(run->settings, usual);
            const bool isLast = run == runs.back();
            if (isUsual && isFirst && point.mark == ChartMark::Disc)
            {
                point.mark = ChartMark::Ring;
            }
            if (!isUsual || isFirst)
            {
                point.label = isUsual && family.varied == &AccuracySettings::hz
                                  ? "usual"
                                  : LabelOf(family, run->settings, isLast);
                point.label += point.mark == ChartMark::Cross && isUsual && !run->ending.empty()
                                   ? " " + run->ending
                                   : "";
                const bool isIterations = family.varied == &AccuracySettings::velocityIterations;
                point.mayLackLabel = !isUsual && (isIterations || !isLast);
            }
            curve.points.push_back(point);
        }
        return curve;
    }

    void AppendRules()
    {
        const AccuracyCase& info = m_result.info;
        m_chart.rules.push_back({std::max(info.goal, m_floor), false,
                                 "goal: " + ChartNumber(info.goal) + " " + info.unit});
        for (const AccuracyFigures& run : m_result.runs)
        {
            if (IsGoalPeer(run.engine) && HasTime(run) &&
                IsSame(run.settings, UsualSettings(m_result, run.engine)))
            {
                m_chart.rules.push_back(
                    {run.CpuOfAFrame() * 1e6, true, "CPU time of " + run.engine});
                m_chart.tintsCorner = true;
                break;
            }
        }
    }

    void AppendLegend()
    {
        for (const Family& family : kFamilies)
        {
            const bool isDrawn =
                std::any_of(m_chart.lines.begin(), m_chart.lines.end(), [&](const ChartLine& line) {
                    return line.series.stroke == family.stroke;
                });
            if (isDrawn)
            {
                m_chart.legend.push_back({{family.legend, 0, family.stroke}, LegendKey::Stroke});
            }
        }
        m_chart.legend.push_back({{"the usual settings"}, LegendKey::Ring});
        if (m_anySpeck)
        {
            m_chart.legend.push_back({{"all other settings"}, LegendKey::Speck});
        }
        if (m_anyCross)
        {
            m_chart.legend.push_back(
                {{m_result.info.remarkGoals.empty() ? "falls or bursts"
                                                    : "falls, bursts or misses another goal"},
                 LegendKey::Cross});
        }
    }

    void Frame()
    {
        const AccuracyCase& info = m_result.info;
        m_chart.frame.title = info.name;
        m_chart.frame.subtitle = info.what;
        m_chart.frame.notes = {
            "Usual: 8 velocity and 3 position iterations, 60 Hz, and 4 sub-steps where there are "
            "any. One thing varies along a curve. The iterations are those of a step,",
            "split over its sub-steps, at least one each; Chipmunk has 10 for 8/3. At 480 Hz the "
            "time is that of eight steps."};
        if (m_chart.tintsCorner)
        {
            m_chart.frame.notes.back() +=
                " Green: the goal is met at no more time than Box2D takes.";
        }
        AppendGoals();
        if (m_reachesFloor)
        {
            const bool isCount = info.goal <= 0.0;
            m_chart.floor = m_floor;
            m_chart.floorText = isCount ? ChartNumber(0.0) : "\u2264 " + ChartPower(m_floor);
        }
        m_chart.x = {"CPU time for 1/60 s [\u00b5s]", true};
        m_chart.y = {"error [" + info.unit + "]", true};
    }

    void AppendGoals()
    {
        for (const RemarkGoal& goal : m_result.info.remarkGoals)
        {
            // Remarks have their unit behind the last line: gap_mm.
            const std::size_t line = goal.name.rfind('_');
            std::string name = goal.name.substr(0, line);
            const std::string unit =
                line == std::string::npos ? std::string() : goal.name.substr(line + 1);
            std::replace(name.begin(), name.end(), '_', ' ');
            m_chart.frame.notes.push_back("The goal is also: " + name + " at " +
                                          (goal.isLeast ? "least " : "most ") +
                                          ChartNumber(goal.bound) + " " + unit + ".");
        }
    }

    const AccuracyResult& m_result;
    LineChart m_chart;
    std::vector<ChartLine> m_others; ///< the settings that are on no curve, by engine
    double m_floor;
    int m_engines = 0;
    bool m_reachesFloor = false, m_anyCross = false, m_anySpeck = false;
};

} // namespace

Result<LineChart> AccuracyChart(const AccuracyResult& result)
{
    const bool any = std::any_of(result.runs.begin(), result.runs.end(),
                                 [](const auto& run) { return HasTime(run) && HasError(run); });
    if (!any)
    {
        return Error{ErrorKind::Unusable,
                     "No run of '" + result.info.name + "' has held, so there is nothing to draw."};
    }
    return AccuracyPainter(result).Make();
}

} // namespace boxreel
