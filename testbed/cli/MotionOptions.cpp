// SPDX-License-Identifier: MIT
#include "MotionOptions.h"
#include "Declare.h"

namespace boxreel
{
namespace
{

/// Two beside each other are about as wide as a picture alone.
constexpr PixelSize kSmallMultiple{640, 360};

} // namespace

void AddMotion(Command& command, ShotOptions& shot)
{
    MotionLook& look = shot.motion;
    AddValue(command, "--at", "TIME[,...]", shot.at, ParseMoments,
             "Set the simulated time: 3s, 500ms, 2.5. Several, such as 0s,1s,2s,\n"
             "make a grid of pictures with their times")
        .Group("Time");
    AddValue(command, "--step", "N[,...]", shot.steps, ParseSteps,
             "Set the time in simulation steps instead")
        .Group("Time");
    AddValue(
        command, "--columns", "N", look.columns,
        [](const std::string& option, const std::string& text) {
            return ParseWhole(option, text, 1, 64);
        },
        "Set the columns of the grid (chosen by the number of pictures)")
        .Group("Time");
    AddValue(command, "--trail", "BODIES", look.trail, ParseBodyChoice,
             "Draw the paths of centres of mass: of bodies by number (3,17) or by\n"
             "their name in the scene file, or moving for all that can move")
        .Group("Motion");
    AddValue(command, "--trail-seconds", "TIME", look.trailTime, ParseDuration,
             "Limit the trail to its last part (all)")
        .Group("Motion");
    AddValue(command, "--strobe", "EVERY[:BODIES]", look.strobe, ParseStrobe,
             "Draw earlier poses fainter: one every 250ms or 15steps from the\n"
             "start, of all moving bodies. 250ms:3,17: only these bodies")
        .Group("Motion");
    AddValue(command, "--onion", "N[:EVERY]", look.onion, ParseOnion,
             "Draw the last N poses 100ms apart, the older the fainter. 5:50ms or\n"
             "5:3steps sets the interval. 5:50ms:3,17: only these bodies")
        .Group("Motion");
    AddFlag(command, "--axes", look.axes, "Draw axes in metres beside the picture; mark the origin")
        .Group("Annotations");
    AddFlag(command, "--scale-bar", look.scaleBar, "Draw a scale bar in metres below the picture")
        .Group("Annotations");
    AddValues(command, "--dimension", "FROM,TO", look.dimensions, ParseDimension,
              "Show the distance of two bodies (3,17), or of bodies and points\n"
              "(\"0,0 to 4.5,2\", \"3 to 4.5,2\"), in metres; repeatable")
        .Group("Annotations");
    AddValue(
        command, "--caption", "TEXT", look.caption,
        [](const std::string&, const std::string& text) { return Result<std::string>(text); },
        "Write a text below the picture, wrapped to its width")
        .Group("Annotations");
    command.finish = [&command, &shot] {
        if (shot.at.size() + shot.steps.size() > 1 && !command.WasGiven("--size"))
        {
            shot.look.width = kSmallMultiple.width;
            shot.look.height = kSmallMultiple.height;
        }
        return Result<void>();
    };
}

Result<void> CheckMotion(const ShotOptions& options)
{
    const MotionLook& look = options.motion;
    const bool several = options.at.size() + options.steps.size() > 1;
    if (look.strobe && look.onion)
    {
        return Conflict("--strobe", "--onion");
    }
    if (look.trailTime && !look.trail)
    {
        return Requires("--trail-seconds", "--trail");
    }
    if (look.columns > 0 && !several)
    {
        return Requires("--columns", "several moments, such as --at 0s,1s,2s,3s");
    }
    const bool hasPanel = options.look.panels.hud || options.look.panels.testbed;
    if (hasPanel && (several || look.axes || look.scaleBar || !look.caption.empty()))
    {
        return Conflict(options.look.panels.hud ? "--hud" : "--ui",
                        "--axes, --scale-bar, --caption or several moments");
    }
    return {};
}

} // namespace boxreel
