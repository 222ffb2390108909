// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <span>
#include <string_view>

/// What a VideoWriter hands its frames to: one implementation per way of storing them.
namespace boxreel
{

/// NAME.MARK.EXT is what a film that is continued is called until all that was left has been
/// copied. With the program's name in it, for what a killed run left there is replaced.
inline constexpr std::string_view kResumedMark = "boxreel-resumed";

class VideoSink
{
public:
    virtual ~VideoSink() = default;

    /// How many frames of an interrupted film are kept.
    virtual std::int64_t ResumedFrames() const { return 0; }

    /// `changed`: where the frame may differ from the last one; all of it for the first.
    virtual Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) = 0;
    virtual Result<void> Repeat() = 0; ///< the last appended frame once more
    /// Of an animation with VideoSettings::resume: what was appended so far is all that is kept of
    /// what was left, whose place it takes.
    virtual Result<void> TakePlace() { return {}; }

    virtual Result<void> Close() = 0;
    virtual Result<void> Suspend() = 0; ///< ends it so that it can be shown, and continued
};

} // namespace boxreel
