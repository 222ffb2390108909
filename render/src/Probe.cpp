// SPDX-License-Identifier: MIT
#include "Probe.h"

#include <base/Bytes.h>
#include <base/ErrorMacros.h>
#include <render/Renderer.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <mutex>

namespace boxreel
{
namespace
{

constexpr int kStripes = 64;
constexpr float kStripe = float(kProbeSide) / kStripes; // width [px]

/// The channels pass through 0 to 255 at different rates.
Color ProbeColor(int i, int alpha)
{
    const auto channel = [i](int factor) { return std::uint8_t(i * factor & 255); };
    return {channel(4), channel(37), channel(91), std::uint8_t(alpha)};
}

/// Each colour under each opacity. The soft edges of lines add more opacities.
void AddBlending(DrawList& list)
{
    for (int i = 0; i < kStripes; ++i)
    {
        const float at = (float(i) + 0.5f) * kStripe;
        list.AddSegment({at, 0.0f}, {at, float(kProbeSide)}, ProbeColor(i, 255));
    }
    for (int i = 0; i < kStripes; ++i)
    {
        const float at = (float(i) + 0.5f) * kStripe;
        list.AddSegment({0.0f, at}, {float(kProbeSide), at}, ProbeColor(i + 32, 4 * i + 3));
    }
}

void AddEdges(DrawList& list)
{
    for (int i = 0; i < 16; ++i)
    {
        const float x = 24.0f + 64.0f * float(i % 4) + 0.1f * float(i);
        const float y = 24.0f + 64.0f * float(i / 4) + 0.2f * float(i);
        // Directions from products, because the sine of the C library differs between machines.
        const float slope = 0.07f * float(i);
        const float length = std::sqrt(1.0f + slope * slope);
        const Vec2 axis{1.0f / length, slope / length};
        list.AddSolidCircle({x, y}, 5.0f + float(i), axis, ProbeColor(3 * i + 1, 255));
        const Vec2 corners[3] = {{x + 20.0f, y},
                                 {x + 20.0f + 24.0f * axis.x, y + 24.0f * axis.y},
                                 {x + 20.0f - 24.0f * axis.y, y + 24.0f * axis.x}};
        list.AddSolidPolygon(corners, 3, ProbeColor(5 * i + 2, 40 + 13 * i));
    }
}

void AddLetters(DrawList& list)
{
    for (int i = 0; i < 8; ++i)
    {
        list.AddText({3.0f + 7.3f * float(i), 250.0f - 31.7f * float(i)}, "Box 0123456789 @#%&",
                     ProbeColor(11 * i + 5, 255 - 20 * i));
    }
}

} // namespace

DrawList ProbeList()
{
    DrawList list;
    AddBlending(list);
    AddEdges(list);
    AddLetters(list);
    return list;
}

Result<Frame> DrawProbe(Backend backend)
{
    Theme theme = Theme::Classic();
    theme.outlineWidth = kStripe;
    ASSIGN_OR_RETURN(
        Renderer renderer,
        Renderer::Create(
            {.width = kProbeSide, .height = kProbeSide, .theme = theme, .backend = backend}));
    constexpr double kMiddle = kProbeSide / 2.0;
    Frame frame;
    const Result<void> drawn =
        renderer.Draw(ProbeList(), {kProbeSide, kProbeSide, kMiddle, kMiddle, 1.0}, frame);
    return drawn ? Result<Frame>(std::move(frame)) : Result<Frame>(drawn.GetError());
}

Result<std::string> ProbeFingerprint(Backend backend, const std::string& description)
{
    static std::mutex mutex;
    static std::map<std::string, std::string> known; // key: description
    const std::lock_guard lock(mutex);
    std::string& fingerprint = known[description];
    if (fingerprint.empty())
    {
        ASSIGN_OR_RETURN(const Frame probe, DrawProbe(backend));
        fingerprint = HexText(ChecksumOf(probe.rgba));
    }
    return fingerprint;
}

} // namespace boxreel
