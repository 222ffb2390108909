// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/VideoWriter.h>
#include <render/Renderer.h>

#include <cstdint>
#include <functional>

/// The loop that makes a film: step, draw, read, encode, overlapped over bounded queues so that
/// memory does not grow with the film. Knows no engine: the caller fills in what each frame shows.
namespace boxreel
{

/// What the caller fills for one frame. The list and the overlay arrive empty, the camera as it was
/// left.
struct FrameContent
{
    DrawList list;
    Camera camera;
    Overlay overlay;
};

struct RecordingProgress
{
    std::int64_t framesDone = 0; ///< encoded
    std::int64_t framesTotal = 0;
    std::int64_t framesRepeated = 0; ///< so far not drawn, being equal to the one before
};

struct RecordingSettings
{
    std::int64_t frameCount = 600; ///< at least 1
    /// Called for frame 0, 1, 2, … in order, on the calling thread: advance the world, fill the
    /// content. It runs ahead: a frame is filled while the one before is drawn and earlier ones are
    /// encoded.
    std::function<Result<void>(std::int64_t frame, FrameContent& content)> fill;
    /// Called on the calling thread after frames are encoded; may be empty. False stops the
    /// recording early.
    std::function<bool(const RecordingProgress&)> progress;
};

/// Runs to the end and closes the writer. On an Error (or a stop, which is no Error) the writer is
/// left unclosed, so that its destruction leaves no file under the final name. The film does not
/// depend on the timing: a frame whose content equals the one before is repeated instead of drawn,
/// which gives the same pixels. The writer's size must be the renderer's.
Result<void> Record(const RecordingSettings& settings, Renderer& renderer, VideoWriter& writer);

} // namespace boxreel
