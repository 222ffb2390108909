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

/// What the caller fills for one frame. The list arrives empty, the camera as it was left.
struct FrameContent
{
    DrawList list;
    Camera camera;
    Overlay overlay;
};

struct RecordingProgress
{
    std::int64_t framesDone = 0;
    std::int64_t framesTotal = 0;
};

struct RecordingSettings
{
    std::int64_t frameCount = 600; ///< at least 1
    /// Called for frame 0, 1, 2, … in order, on the calling thread: advance the world, fill the
    /// content.
    std::function<Result<void>(std::int64_t frame, FrameContent& content)> fill;
    /// Called on the calling thread after frames are encoded; may be empty. False stops the
    /// recording early.
    std::function<bool(const RecordingProgress&)> progress;
};

/// Runs to the end and closes the writer. On an Error (or a stop) the writer is left unclosed, so
/// that its destruction leaves no file under the final name.
Result<void> Record(const RecordingSettings& settings, Renderer& renderer, VideoWriter& writer);

} // namespace boxreel
