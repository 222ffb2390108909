// SPDX-License-Identifier: MIT
#include "VerdictText.h"

#include <base/Counting.h>
#include <base/Words.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace boxreel
{
namespace
{

constexpr std::array kStatuses{
    StatusWords{GoldenStatus::NotCompared, "error", "not compared",
                "the reference is damaged, or a body to leave out is not there", false},
    StatusWords{GoldenStatus::State, "state", "state",
                "the worlds differ: some body is elsewhere or moves otherwise", false},
    StatusWords{GoldenStatus::DrawList, "drawlist", "geometry",
                "the same world draws something else", false},
    StatusWords{GoldenStatus::Pixels, "pixels", "pixels", "the same geometry, other pixels", false},
    StatusWords{GoldenStatus::Missing, "missing", "missing", "never approved", false},
    StatusWords{std::nullopt, "accepted", "accepted",
                "became the reference in this run; look at it before you commit it", true},
    StatusWords{GoldenStatus::Same, "same", "as approved", "within the limits", true},
};

} // namespace

std::span<const StatusWords> AllStatusWords()
{
    return kStatuses;
}

const StatusWords* FindStatus(std::string_view word)
{
    const auto* const found =
        std::find_if(kStatuses.begin(), kStatuses.end(),
                     [&](const StatusWords& status) { return word == status.word; });
    return found == kStatuses.end() ? nullptr : found;
}

const char* StatusWord(std::optional<GoldenStatus> status)
{
    return std::find_if(kStatuses.begin(), kStatuses.end(),
                        [&](const StatusWords& row) { return row.status == status; })
        ->word;
}

const char* LimitsWord(LimitsChoice choice)
{
    switch (choice)
    {
    case LimitsChoice::AsGiven:
        return "as given";
    case LimitsChoice::SameRenderer:
        return "same renderer";
    case LimitsChoice::OtherRenderer:
        break;
    }
    return "other renderer";
}

namespace
{

// The shortest text that reads back, independent of the locale.
std::string Number(auto value)
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

/// A share as a percentage that, read again, is this share: a limit is never rounded.
std::string Percent(double share)
{
    for (int digits = 3; digits < 17; ++digits)
    {
        char text[32];
        const auto end = std::to_chars(text, text + sizeof text, 100.0 * share,
                                       std::chars_format::general, digits)
                             .ptr;
        double percent = 0.0;
        std::from_chars(text, end, percent);
        if (percent / 100.0 == share)
        {
            return {text, end};
        }
    }
    return Number(100.0 * share);
}

std::string Size(const std::array<int, 2>& size)
{
    return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

/// "exact", "exact, with --max-pixels," or "exact, with another tolerance, maxPixels,": a program
/// can change each of them.
std::string Origin(const CompareSettings& settings)
{
    if (!settings.options.empty())
    {
        return settings.preset + ", with " + JoinedBy(", ", settings.options) + ",";
    }
    for (const CompareSettings& preset : {CompareSettings::Exact(), CompareSettings::SameMachine(),
                                          CompareSettings::CrossMachine()})
    {
        const std::vector<std::string> changed = DifferentLimits(preset, settings);
        if (preset.preset == settings.preset && !changed.empty())
        {
            return settings.preset + ", with another " + JoinedBy(", ", changed) + ",";
        }
    }
    return settings.preset;
}

std::string Exact(float value)
{
    return Number(value == 0.0f ? 0.0f : value); // not -0
}

std::string Instead(const char* quantity, float expected, float actual)
{
    return std::string(" (") + quantity + " " + Exact(actual) + " instead of " + Exact(expected) +
           ")";
}

/// Describes the largest difference: positions first, then angles, then velocities.
std::string DescribeBody(const BodyState& expected, const BodyState& actual)
{
    const double dx = double(actual.x) - double(expected.x);
    const double dy = double(actual.y) - double(expected.y);
    if (std::abs(dy) > 0.0 && std::abs(dy) >= std::abs(dx))
    {
        return Rounded(std::abs(dy)) + (dy < 0.0 ? " m lower" : " m higher") +
               Instead("y", expected.y, actual.y);
    }
    if (dx != 0.0)
    {
        return Rounded(std::abs(dx)) + " m further to the " + (dx < 0.0 ? "left" : "right") +
               Instead("x", expected.x, actual.x);
    }
    if (expected.angle != actual.angle)
    {
        const double turned = double(actual.angle) - double(expected.angle);
        return "turned by " + Rounded(turned) + " rad more" +
               Instead("angle", expected.angle, actual.angle);
    }
    if (expected.velocityX != actual.velocityX)
    {
        return "at the same place with another velocity" +
               Instead("x", expected.velocityX, actual.velocityX);
    }
    if (expected.velocityY != actual.velocityY)
    {
        return "at the same place with another velocity" +
               Instead("y", expected.velocityY, actual.velocityY);
    }
    return "at the same place with another angular velocity" +
           Instead("rad/s", expected.angularVelocity, actual.angularVelocity);
}

std::string Numbers(const std::vector<int>& numbers, const char* what)
{
    return numbers.size() == 1 ? "body " + std::to_string(numbers.front()) + " is " + what
                               : Counted(numbers.size(), "body") + " are " + what + " (number " +
                                     std::to_string(numbers.front()) + " first)";
}

std::string DescribeLine(const LineDifference& difference)
{
    const std::string line = "line " + std::to_string(difference.line);
    if (!difference.actual && !difference.expected)
    {
        return "only the newline at the end differs";
    }
    if (!difference.actual)
    {
        return line + " is missing: \"" + *difference.expected + "\"";
    }
    if (!difference.expected)
    {
        return line + " is one too many: \"" + *difference.actual + "\"";
    }
    return line + " is \"" + *difference.actual + "\" instead of \"" + *difference.expected + "\"";
}

} // namespace

std::string DescribeLimits(const CompareSettings& settings)
{
    const std::string side = std::to_string(settings.densityWindow);
    std::string text = Origin(settings) + " allows ";
    if (settings.maxPixels != kAnyNumberOfPixels)
    {
        text += Counted(settings.maxPixels, "pixel");
    }
    if (settings.maxRatio < 1.0 || settings.maxPixels == kAnyNumberOfPixels)
    {
        text += (settings.maxPixels == kAnyNumberOfPixels ? "" : ", ") +
                Percent(settings.maxRatio) + " %";
    }
    text += " over a distance of " + Number(settings.tolerance);
    if (settings.edgeShift > 0.0)
    {
        text += " and edges " + Number(settings.edgeShift) + " px elsewhere";
    }
    return text + ", " + std::to_string(settings.maxInWindow) + " in any " + side + "x" + side;
}

std::string Comparison::Text() const
{
    const std::string end = " (" + DescribeLimits(limits) + ")";
    if (!sameSize)
    {
        return "different: the expected picture has " + Size(expectedSize) +
               " pixels, the actual one " + Size(actualSize) + end;
    }
    const std::string without =
        ignored > 0 ? ", " + Counted(ignored, "pixel") + " ignored" : std::string();
    const std::string text = equal ? "equal: " : "different: ";
    if (IsAllIgnored())
    {
        return text + "nothing was compared" + without + end;
    }
    if (differentPixels == 0)
    {
        return text + "no pixel differs" + without + end;
    }
    const std::string largest = ", largest distance " + Rounded(largestDistance) + without + end;
    if (overTolerance == 0)
    {
        return text + Counted(differentPixels, "pixel") + " by no more than " +
               (excusedAtEdges > 0 ? "tolerance and edges allow" : "the tolerance") + largest;
    }
    return text + Counted(overTolerance, "pixel") + " over the tolerance, first at " +
           std::to_string(firstX) + "," + std::to_string(firstY) + ", up to " +
           std::to_string(worstWindow) + " in a window" + largest;
}

std::string Describe(const StateDifference& difference)
{
    std::vector<std::string> parts;
    if (!difference.missing.empty())
    {
        parts.push_back(Numbers(difference.missing, "missing"));
    }
    if (!difference.extra.empty())
    {
        parts.push_back(Numbers(difference.extra, "one too many"));
    }
    if (difference.different > 0)
    {
        parts.push_back(std::to_string(difference.different) + " of " +
                        std::to_string(difference.compared) +
                        (difference.different == 1 ? " bodies differs, body "
                                                   : " bodies differ, most of all body ") +
                        std::to_string(difference.expected.number) + ": " +
                        DescribeBody(difference.expected, difference.actual));
    }
    return JoinedBy(", ", parts);
}

std::string Describe(const TraceDifference& difference)
{
    const std::string number = std::to_string(difference.step);
    const std::string step = difference.isFirst ? "at step " + number + ", if not before"
                                                : "from step " + number + " on";
    const std::vector<int>& bodies = difference.bodies;
    if (difference.isOfOne)
    {
        return step + ", which only one of them has";
    }
    if (bodies.empty())
    {
        return step;
    }
    constexpr std::size_t kNamed = 4;
    std::string names = PluralOf(bodies.size(), "body") + " ";
    for (std::size_t i = 0; i < std::min(bodies.size(), kNamed); ++i)
    {
        names.append(i == 0 ? "" : ", ").append(std::to_string(bodies[i]));
    }
    return step + ", " + names +
           (bodies.size() > kNamed ? " and " + std::to_string(bodies.size() - kNamed) + " more"
                                   : "") +
           (difference.isFirst ? "" : " first");
}

std::string Describe(const LineDifference& difference)
{
    const std::string text = DescribeLine(difference);
    return difference.expectedLines == difference.actualLines
               ? text
               : text + ", and there are " + std::to_string(difference.actualLines) +
                     " lines instead of " + std::to_string(difference.expectedLines);
}

namespace
{

/// "3 pictures instead of 4, ", "pictures of 160x90 instead of 320x180, ", or nothing.
std::string OtherLayout(const SheetLayout& expected, const SheetLayout& actual)
{
    if (expected.width != actual.width || expected.height != actual.height)
    {
        return "pictures of " + Size({actual.width, actual.height}) + " instead of " +
               Size({expected.width, expected.height}) + ", ";
    }
    return expected.pictures == actual.pictures
               ? ""
               : Counted(actual.pictures, "picture") + " instead of " +
                     std::to_string(expected.pictures) + ", ";
}

/// Since when the worlds differ, and by how much at this moment.
std::string DescribeWorld(const WorldDifference& world)
{
    if (world.expected == world.actual)
    {
        return "the worlds differ on the way, " + Describe(*world.inTrace) +
               ", and come to the same state";
    }
    const std::string now = world.now ? Describe(*world.now) : "";
    return "the worlds differ" + (world.inTrace ? " " + Describe(*world.inTrace) : "") +
           " (state " + world.actual + " instead of " + world.expected +
           (now.empty() ? ")" : "; now " + now + ")");
}

std::string DescribeList(const GoldenVerdict& verdict)
{
    return verdict.list ? "the draw list differs (" + Describe(*verdict.list) + ")"
                        : "the draw list is the same";
}

std::string DescribePixels(const GoldenVerdict& verdict)
{
    std::string text = verdict.compared.list ? "same geometry, other pixels: " : "other pixels: ";
    if (verdict.film)
    {
        text += OtherLayout(verdict.film->expected, verdict.film->actual);
        text += verdict.film->firstStep
                    ? "from step " + std::to_string(*verdict.film->firstStep) + " on: "
                    : "";
    }
    return text + "pixels " + verdict.pixels.Text();
}

std::string DescribeMissing(const GoldenVerdict& verdict)
{
    const std::string files =
        " (" + JoinedBy(", ", verdict.missing) + " missing in " + verdict.references + ")";
    switch (verdict.absence)
    {
    case GoldenAbsence::OwnPicture:
        return "this renderer had no picture of its own";
    case GoldenAbsence::Part:
        return "a part of the reference is not there" + files + ", and the rest is the same";
    default:
        return "there is no reference" + files;
    }
}

std::string DescribeSame(const GoldenVerdict& verdict)
{
    return std::string("same") + (verdict.compared.state ? ", state" : "") +
           (verdict.compared.list ? ", draw list" : "") +
           (verdict.compared.frame ? ", pixels " + verdict.pixels.Text() : "");
}

/// Returns the first depth that differs, then the depths below it.
std::vector<std::string> Differing(const GoldenVerdict& verdict)
{
    std::vector<std::string> findings;
    switch (verdict.status)
    {
    case GoldenStatus::State:
        findings.push_back(DescribeWorld(*verdict.world));
        if (verdict.compared.list)
        {
            findings.push_back(DescribeList(verdict));
        }
        break;
    case GoldenStatus::DrawList:
        findings.push_back(
            (verdict.compared.state ? "same world, other geometry: " : "other geometry: ") +
            DescribeList(verdict));
        break;
    default:
        if (!verdict.film || !verdict.film->HasOtherMoments())
        {
            return {DescribePixels(verdict)};
        }
        findings.push_back("other moments of a film: " + verdict.film->actualMoments +
                           " instead of " + verdict.film->expectedMoments);
    }
    if (verdict.compared.frame)
    {
        findings.push_back("pixels " + verdict.pixels.Text());
    }
    return findings;
}

} // namespace

std::vector<std::string> GoldenVerdict::Findings() const
{
    if (status == GoldenStatus::NotCompared)
    {
        return {(accept.empty() ? "" : "its reference is damaged: ") + problem.Text()};
    }
    if (status == GoldenStatus::Missing)
    {
        return {DescribeMissing(*this)};
    }
    std::vector<std::string> findings =
        status == GoldenStatus::Same ? std::vector{DescribeSame(*this)} : Differing(*this);
    if (!missing.empty())
    {
        findings.push_back(JoinedBy(", ", missing) + " missing in " + references);
    }
    if (status == GoldenStatus::Pixels && limits == LimitsChoice::OtherRenderer)
    {
        findings.emplace_back("these limits hold because another renderer drew the reference");
    }
    return findings;
}

std::string GoldenVerdict::AcceptedText() const
{
    if (status != GoldenStatus::Missing)
    {
        return Text();
    }
    const bool isNew = absence == GoldenAbsence::All;
    return name + ": " + (isNew ? "there was no reference" : DescribeMissing(*this)) + ".";
}

std::string GoldenVerdict::Text(const std::string& remedy) const
{
    std::string text = name + ": " + JoinedBy("; ", Findings()) + ".";
    for (const std::string& file : look)
    {
        text.append(&file == look.data() ? " Look at " : ", ").append(file);
    }
    text += look.empty() ? "" : ".";
    const bool wouldHelp =
        status != GoldenStatus::Same && (!accept.empty() || status != GoldenStatus::NotCompared);
    const std::string usual = accept.empty() ? "" : "run `" + accept + "`";
    const std::string& what = remedy.empty() ? usual : remedy;
    return text + (wouldHelp && !what.empty() ? " If it is right, " + what + "." : "");
}

} // namespace boxreel
