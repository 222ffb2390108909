// SPDX-License-Identifier: MIT
#include "OptionNames.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <page/PageWriter.h>
#include <recorder/VideoWriter.h>

namespace boxreel
{
namespace
{

constexpr SettingName kNames[] = {
    {BOXREEL_MEMBER(AtomicFileSettings, overwrite), "true", "--force"},
    {BOXREEL_MEMBER(VideoSettings, overwrite), "true", "--force"},
    {BOXREEL_MEMBER(PageSettings, overwrite), "true", "--force"},
    {BOXREEL_MEMBER(VideoSettings, resume), "true", "--resume"},
    {BOXREEL_MEMBER(VideoSettings, resume), "", "--resume"},
    {BOXREEL_MEMBERS(VideoSettings, width, height), "", "--size", " ", "x"},
    {BOXREEL_MEMBER(VideoSettings, framesPerSecond), "", "--fps", " "},
    {BOXREEL_MEMBER(VideoSettings, quality), "Quality::Lossless", "--quality lossless"},
    {BOXREEL_MEMBER(VideoSettings, chroma), "Chroma::Full", "--chroma 444"},
    {BOXREEL_MEMBER(VideoSettings, codec), "", "--codec", " "},
    {BOXREEL_MEMBER(VideoSettings, format), "", "--format", " "},
    {BOXREEL_MEMBER(VideoSettings, codecOptions), "", "--codec-option", " "},
    {BOXREEL_MEMBER(VideoSettings, plays), "", "--loop", " "},
    {BOXREEL_MEMBER(VideoSettings, threads), "", "--threads", " "},
    {BOXREEL_MEMBER(VideoSettings, timing), "FrameTiming::Variable", "--variable-rate"},
    {BOXREEL_MEMBER(VideoSettings, timing), "FrameTiming::Constant", "--constant-rate"},
    {BOXREEL_MEMBER(VideoSettings, groupFrames), "", "--group", " "},
};

} // namespace

SettingNames OptionNames()
{
    return kNames;
}

std::string TextInOptions(const Error& error)
{
    return error.Text(OptionNames());
}

} // namespace boxreel
