// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <render/Frame.h>

/// What a VideoWriter hands its frames to: one implementation per way of storing them.
namespace boxreel
{

class VideoSink
{
public:
    virtual ~VideoSink() = default;

    virtual Result<void> Append(const Frame& frame) = 0;
    virtual Result<void> Repeat() = 0; ///< the last appended frame once more
    virtual Result<void> Close() = 0;
};

} // namespace boxreel
