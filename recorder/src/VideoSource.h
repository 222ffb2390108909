// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/VideoReader.h>
#include <render/Frame.h>

/// What a VideoReader takes its frames from: one implementation per way of storing them.
namespace boxreel
{

class VideoSource
{
public:
    virtual ~VideoSource() = default;

    virtual Result<bool> Next(Frame& frame, double& seconds) = 0;

    VideoInfo info;
};

} // namespace boxreel
