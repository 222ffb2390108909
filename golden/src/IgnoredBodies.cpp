// SPDX-License-Identifier: MIT
#include "IgnoredBodies.h"

#include "TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace boxreel
{

namespace
{

/// Margin around drawn items [px]: half of the widest line, and the spread of a filter.
constexpr float kMargin = 3.0f;
/// Upper bound of the width of a character [px].
constexpr float kLetterWidth = 12.0f;
constexpr float kLetterHeight = 24.0f;

bool Contains(const std::vector<int>& bodies, int body)
{
    return std::find(bodies.begin(), bodies.end(), body) != bodies.end();
}

/// Returns the owner of a draw list's line: "body 17 …"; -1: the world.
int OwnerOf(std::string_view line)
{
    constexpr std::string_view kBody = "body ";
    int number = -1;
    if (line.starts_with(kBody))
    {
        (void)std::from_chars(line.data() + kBody.size(), line.data() + line.size(), number);
    }
    return number;
}

void LeaveOut(const std::vector<int>& bodies, WorldState& state)
{
    std::erase_if(state.bodies,
                  [&](const BodyState& body) { return Contains(bodies, body.number); });
}

void LeaveOut(const std::vector<int>& bodies, std::string& list)
{
    std::string kept;
    std::string_view text = list;
    while (const std::optional<std::string_view> line = TakeLine(text))
    {
        if (!Contains(bodies, OwnerOf(*line)))
        {
            kept.append(*line).append("\n");
        }
    }
    list = std::move(kept);
}

/// False if bodies have no digits of their own.
bool LeaveOut(const std::vector<int>& bodies, StateTrace& trace)
{
    for (TraceStep& step : trace.steps)
    {
        if (step.bodies.find('/') != std::string::npos)
        {
            return false;
        }
        for (const int body : bodies)
        {
            if (std::size_t(body) < step.bodies.size())
            {
                step.bodies[std::size_t(body)] = '.';
            }
        }
        step.world = step.bodies; // the hash includes all bodies
    }
    return true;
}

/// Parses the number at the start and removes it.
std::optional<float> TakeNumber(std::string_view& text)
{
    float number = 0.0f;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
    {
        return std::nullopt;
    }
    text.remove_prefix(std::size_t(end - text.data()));
    return number;
}

/// Parses "… (x, y) (x, y) radius 0.5" of DrawListText: the bounds of all points with their size.
/// Stops at quotes, because a text may contain anything.
class LineBounds
{
public:
    LineBounds(std::string_view line, const Camera& camera)
    {
        const std::size_t quote = line.find('"');
        std::string_view text = line.substr(0, quote);
        std::vector<Vec2> points;
        for (std::size_t at = text.find('('); at != text.npos; at = text.find('('))
        {
            text.remove_prefix(at + 1);
            const std::optional<float> x = TakeNumber(text);
            text.remove_prefix(std::min<std::size_t>(2, text.size())); // ", "
            const std::optional<float> y = TakeNumber(text);
            if (x && y)
            {
                points.push_back({*x, *y});
            }
        }
        const float meters = float(camera.pixelsPerMeter);
        const float reach = SizeAfter(line, " radius ") * meters +
                            SizeAfter(line, " axes ") * meters + SizeAfter(line, " pixels ");
        const bool isRound = reach > 0.0f; // the second point is a direction
        points.resize(isRound ? std::min<std::size_t>(1, points.size()) : points.size());
        for (const Vec2 point : points)
        {
            const Vec2 pixel = camera.ToPixel(point);
            m_bounds.Include(Vec2{pixel.x - reach, pixel.y - reach});
            m_bounds.Include(Vec2{pixel.x + reach, pixel.y + reach});
            if (quote != line.npos)
            {
                const float width = kLetterWidth * float(line.size() - quote);
                m_bounds.Include(Vec2{pixel.x + width, pixel.y + kLetterHeight});
            }
        }
    }

    const Rect& Bounds() const { return m_bounds; } ///< [px], y down

private:
    static float SizeAfter(std::string_view line, std::string_view name)
    {
        const std::size_t at = line.find(name);
        std::string_view rest =
            at == line.npos ? std::string_view() : line.substr(at + name.size());
        return TakeNumber(rest).value_or(0.0f);
    }

    Rect m_bounds;
};

PixelBounds PixelsAround(const Rect& bounds, const Camera& camera)
{
    const auto pixel = [](float value, int maximum) {
        return int(std::clamp(value, 0.0f, float(maximum)));
    };
    return {pixel(std::floor(bounds.lower.x - kMargin), camera.width),
            pixel(std::floor(bounds.lower.y - kMargin), camera.height),
            pixel(std::ceil(bounds.upper.x + kMargin), camera.width),
            pixel(std::ceil(bounds.upper.y + kMargin), camera.height)};
}

} // namespace

void LeaveOut(const std::vector<int>& bodies, Moment& expected, Moment& actual)
{
    for (Moment* const moment : {&expected, &actual})
    {
        LeaveOut(bodies, moment->bodies);
        if (moment->list)
        {
            LeaveOut(bodies, *moment->list);
        }
        if (moment->trace && !LeaveOut(bodies, *moment->trace))
        {
            expected.trace.reset();
            actual.trace.reset();
        }
    }
    if (expected.bodies.bodies == actual.bodies.bodies)
    {
        actual.state = expected.state;
    }
}

std::vector<PixelBounds> RegionsOf(const std::vector<int>& bodies, const Moment& expected,
                                   const Moment& actual, const Camera& camera)
{
    std::vector<PixelBounds> regions;
    for (const int body : bodies)
    {
        for (const Moment* const moment : {&expected, &actual})
        {
            Rect bounds;
            std::string_view text = moment->list ? std::string_view(*moment->list) : "";
            while (const std::optional<std::string_view> line = TakeLine(text))
            {
                if (OwnerOf(*line) == body)
                {
                    bounds.Include(LineBounds(*line, camera).Bounds());
                }
            }
            if (!bounds.IsEmpty())
            {
                regions.push_back(PixelsAround(bounds, camera));
            }
        }
    }
    return regions;
}

} // namespace boxreel
