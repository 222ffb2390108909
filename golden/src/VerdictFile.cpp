// SPDX-License-Identifier: MIT
#include "VerdictFile.h"

#include <array>
#include <charconv>

namespace boxreel
{

namespace
{

constexpr std::string_view kBegin = "{\n";

template <class Number>
std::string Text(Number number)
{
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return std::string(digits.data(), end);
}

/// RFC 8259, section 7. What is no UTF-8 stays as it is: a reader shows it as well as it can.
std::string Quoted(std::string_view text)
{
    constexpr const char* kDigits = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text)
    {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
        {
            quoted += {'\\', c};
        }
        else if (byte < 32)
        {
            quoted += {'\\', 'u', '0', '0', kDigits[byte >> 4], kDigits[byte & 15]};
        }
        else
        {
            quoted += c;
        }
    }
    return quoted + '"';
}

class Object
{
public:
    void Add(const char* name, const std::string& json)
    {
        m_text += (m_text.empty() ? "  \"" : ",\n  \"") + std::string(name) + "\": " + json;
    }
    std::string Whole() const { return std::string(kBegin) + m_text + "\n}\n"; }

private:
    std::string m_text;
};

std::string List(const std::vector<int>& numbers)
{
    std::string text;
    for (const int number : numbers)
    {
        text += (text.empty() ? "" : ", ") + Text(number);
    }
    return "[" + text + "]";
}

std::string Regions(const std::vector<PixelBounds>& regions)
{
    std::string text;
    for (const PixelBounds& region : regions)
    {
        text += (text.empty() ? "" : ", ") +
                List({region.x0, region.y0, region.x1 - region.x0, region.y1 - region.y0});
    }
    return "[" + text + "]";
}

void AddLimits(Object& object, const CompareSettings& limits)
{
    object.Add("limits", Quoted(DescribeLimits(limits)));
    object.Add("preset", Quoted(limits.preset));
    object.Add("tolerance", Text(limits.tolerance));
    object.Add("edgeShift", Text(limits.edgeShift));
    object.Add("maxPixels",
               limits.maxPixels == kAnyNumberOfPixels ? "null" : Text(limits.maxPixels));
    object.Add("maxRatio", Text(limits.maxRatio));
    object.Add("maxInWindow", Text(limits.maxInWindow));
    object.Add("window", Text(limits.densityWindow));
    object.Add("ignored", Regions(limits.ignored));
    object.Add("ignoredBodies", List(limits.ignoredBodies));
}

void AddPixels(Object& object, const Comparison& pixels)
{
    object.Add("pixels", Quoted(pixels.verdict));
    object.Add("compared", Text(pixels.compared));
    object.Add("different", Text(pixels.differentPixels));
    object.Add("overTolerance", Text(pixels.overTolerance));
    object.Add("excusedAtEdges", Text(pixels.excusedAtEdges));
    object.Add("worstWindow", Text(pixels.worstWindow));
    object.Add("largestDistance", Text(pixels.largestDistance));
}

void AddView(Object& object, const Camera& camera)
{
    std::string numbers = Text(camera.width) + ", " + Text(camera.height);
    for (const double number : {camera.centerX, camera.centerY, camera.pixelsPerMeter})
    {
        numbers += ", " + Text(number);
    }
    object.Add("view", "[" + numbers + "]");
}

} // namespace

const char* StatusWord(GoldenStatus status)
{
    switch (status)
    {
    case GoldenStatus::Same:
        return "same";
    case GoldenStatus::Missing:
        return "missing";
    case GoldenStatus::State:
        return "state";
    case GoldenStatus::DrawList:
        return "drawlist";
    case GoldenStatus::Pixels:
        return "pixels";
    case GoldenStatus::NotCompared:
        break;
    }
    return "error";
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

std::string ToJson(const VerdictRecord& record)
{
    Object object;
    object.Add("verdict", "1"); // the format's version
    object.Add("name", Quoted(record.name));
    object.Add("status", Quoted(record.status));
    object.Add("message", Quoted(record.message));
    if (!record.accept.empty())
    {
        object.Add("accept", Quoted(record.accept));
    }
    if (record.limits != nullptr)
    {
        AddLimits(object, *record.limits);
        object.Add("limitsChoice", Quoted(LimitsWord(record.limitsChoice)));
    }
    if (record.pixels != nullptr && !record.pixels->verdict.empty())
    {
        AddPixels(object, *record.pixels);
    }
    if (record.candidate != nullptr)
    {
        const GoldenCandidate& candidate = *record.candidate;
        object.Add("renderer", Quoted(candidate.renderer));
        object.Add("fingerprint", Quoted(candidate.fingerprint));
        if (candidate.camera && CanBeDrawn(*candidate.camera))
        {
            AddView(object, *candidate.camera);
        }
        const std::vector<TraceStep>& steps = candidate.trace.steps;
        if (!steps.empty())
        {
            object.Add("since", Text(steps.front().step)); // the first that was compared
            object.Add("step", Text(steps.back().step));
        }
        for (const TraceStep& step : steps)
        {
            if (record.firstStep == step.step)
            {
                // By which a program that goes the steps again sees that it does the same.
                object.Add("firstHash", Quoted(step.world));
            }
        }
    }
    if (record.firstStep)
    {
        object.Add("firstStep", Text(*record.firstStep));
        object.Add("firstBodies", List(record.firstBodies));
    }
    return object.Whole();
}

std::optional<std::string> Accepted(std::string_view json)
{
    if (!json.starts_with(kBegin))
    {
        return std::nullopt;
    }
    return std::string(kBegin) + "  \"accepted\": true,\n" +
           std::string(json.substr(kBegin.size()));
}

} // namespace boxreel
