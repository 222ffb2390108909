// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/VideoWriter.h>
#include <render/Renderer.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>

/// @file
/// Making a film: draw, read, encode, overlapped with the caller's steps over bounded queues so
/// that memory does not grow with the film. Record is the loop itself, Recording is for programs
/// that have one. Knows no engine: the caller says what each frame shows.
namespace boxreel
{

/// What the caller fills for one frame. The list and the overlay arrive empty, the camera as it was
/// left.
struct FrameContent
{
    DrawList list;       ///< what is drawn
    Camera camera;       ///< which part of it is seen
    Overlay overlay;     ///< drawn above all; empty: nothing
    bool isLast = false; ///< the film ends with this frame, however many were asked for
    bool stops = false;  ///< the recording stops before this frame, which need not be filled
};

/// How far a recording is.
struct RecordingProgress
{
    std::int64_t framesDone = 0;     ///< encoded
    std::int64_t framesTotal = 0;    ///< that were asked for
    std::int64_t framesRepeated = 0; ///< so far not drawn, being equal to the one before
    std::int64_t framesKept = 0;     ///< of those done: they were there before this recording
};

/// What is recorded, and who is told.
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
};

/// Why a recording ended.
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

/// A film of a world with a main loop of its own:
///
///     auto film = boxreel::Recording::Open("film.mp4");   // …
///     film->Add(list, camera);                            // in the loop, once a frame
///     film->Close();                                      // after it
///
/// What is added is drawn while the loop goes on, and encoded on another thread. Pictures that are
/// drawn by something else go to a VideoWriter.
class Recording
{
public:
    /// Begins the film. It is drawn in the film's size, whatever `drawing` says. The Errors of
    /// Renderer::Create and VideoWriter::Open.
    static Result<Recording> Open(const std::filesystem::path& path, const VideoSettings& film = {},
                                  const RendererSettings& drawing = {});
    /// The other may only be assigned to or destroyed.
    Recording(Recording&&) noexcept;
    /// The other may only be assigned to or destroyed.
    Recording& operator=(Recording&&) noexcept;
    ~Recording(); ///< without Close no film is left

    /// Appends the next frame. The camera's size must be the film's. False when this or an earlier
    /// one could not be added; Close says why.
    bool Add(const DrawList& list, const Camera& camera, const Overlay* overlay = nullptr);

    /// Waits for the encoder and gives the film its name. Nothing may follow. The first Error that
    /// there was; then no film is left.
    Result<void> Close();

private:
    struct Impl;
    explicit Recording(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
