// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>
#include <recorder/StageTimes.h>
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
    bool isLast = false; ///< the film ends with this frame, however many were asked for
    bool stops = false;  ///< the recording stops before this frame, which need not be filled
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
    /// recording early: what was drawn is still encoded.
    std::function<bool(const RecordingProgress&)> progress;
    /// Called on the calling thread with the pixels of each frame, repeated ones too; may be empty.
    std::function<void(std::int64_t frame, const Frame& pixels)> seen;
    /// What drawing, reading, copying and waiting take; null: not timed.
    StageTimes* stages = nullptr;
};

enum class RecordingEnd
{
    Complete, ///< the writer is closed
    Stopped,  ///< by the caller; the writer is open, to be suspended, or destroyed
};

/// Runs to the end and closes the writer. On an Error the writer is left unclosed, so that its
/// destruction leaves no file under the final name. The film does not depend on the timing: a frame
/// whose content equals the one before is repeated instead of drawn, which gives the same pixels.
/// The writer's size must be the renderer's.
Result<RecordingEnd> Record(const RecordingSettings& settings, Renderer& renderer,
                            VideoWriter& writer);

} // namespace boxreel
