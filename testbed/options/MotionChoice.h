// SPDX-License-Identifier: MIT
#pragma once

#include "BodyRef.h"
#include "Values.h"

#include <debugdraw/DrawList.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Additional content of a still: past paths of bodies, and annotations. Bodies are named by their
/// number or name.
namespace boxreel
{

struct BodyChoice
{
    bool moving = true;          ///< all that can move …
    std::vector<BodyRef> bodies; ///< … or these
    friend bool operator==(const BodyChoice&, const BodyChoice&) = default;
};

/// A time, or a number of steps.
struct Interval
{
    Duration time;
    std::int64_t steps = 0; ///< above 0: used instead of the time
    friend bool operator==(const Interval&, const Interval&) = default;
};

/// Poses every so often, from the start.
struct StrobeChoice
{
    Interval every;
    BodyChoice of;
    friend bool operator==(const StrobeChoice&, const StrobeChoice&) = default;
};

/// The last poses, fading.
struct OnionChoice
{
    std::int64_t count = 0;
    Interval every{{100'000'000}, 0};
    BodyChoice of;
    friend bool operator==(const OnionChoice&, const OnionChoice&) = default;
};

/// A body's centre of mass, or a point of the world [m].
using MeasuredEnd = std::variant<BodyRef, Vec2>;

struct DimensionChoice
{
    MeasuredEnd from, to;
    friend bool operator==(const DimensionChoice&, const DimensionChoice&) = default;
};

struct MotionLook
{
    std::optional<BodyChoice> trail;
    std::optional<Duration> trailTime; ///< none: since the start
    std::optional<StrobeChoice> strobe;
    std::optional<OnionChoice> onion; ///< not together with a strobe
    std::vector<DimensionChoice> dimensions;
    bool axes = false;
    bool scaleBar = false;
    std::string caption; ///< empty: none
    int columns = 0;     ///< of several moments; 0: as many as suit their number
};

// A failure is Unusable, one sentence that names `option`.

/// "moving", "3,17", "left wheel,17".
Result<BodyChoice> ParseBodyChoice(const std::string& option, const std::string& text);

/// "250ms", "15steps", "250ms:3,17".
Result<StrobeChoice> ParseStrobe(const std::string& option, const std::string& text);

/// "5", "5:100ms", "5:6steps:3,17".
Result<OnionChoice> ParseOnion(const std::string& option, const std::string& text);

/// "3,17", "0,0 to 4.5,2", "3 to 4.5,2".
Result<DimensionChoice> ParseDimension(const std::string& option, const std::string& text);

/// "0s,500ms,2": times that grow, 64 at most.
Result<std::vector<Duration>> ParseMoments(const std::string& option, const std::string& text);

/// "0,30,120": numbers of steps that grow, 64 at most.
Result<std::vector<std::int64_t>> ParseSteps(const std::string& option, const std::string& text);

} // namespace boxreel
