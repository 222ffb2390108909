// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// The output of a VideoWriter: one implementation per kind of storage.
namespace boxreel
{

/// A resumed film is called NAME.MARK.EXT until all kept frames have been copied. The mark contains
/// the program's name, because the leftover of a killed run is replaced.
inline constexpr std::string_view kResumedMark = "boxreel-resumed";

class VideoSink
{
public:
    virtual ~VideoSink() = default;

    /// Returns the number of frames kept from an interrupted film.
    virtual std::int64_t ResumedFrames() const { return 0; }

    /// Returns the number of frames in the file so far, with those kept; none if each appended
    /// frame is stored.
    virtual std::optional<std::int64_t> StoredFrames() const { return std::nullopt; }

    /// `changed`: where the frame may differ from the last one; the whole frame for the first.
    virtual Result<void> Append(const Frame& frame, std::span<const PixelBounds> changed) = 0;
    virtual Result<void> Repeat() = 0; ///< repeats the last frame
    /// For an animation with VideoSettings::resume: the frames so far are all that is kept. The
    /// film then replaces the interrupted one.
    virtual Result<void> TakePlace() { return {}; }

    virtual Result<void> Close() = 0;
    virtual Result<void> Suspend() = 0; ///< ends it so that it can be played and resumed
};

} // namespace boxreel
