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
/// Records a film. Drawing, reading and encoding overlap with the caller's steps. Queues are
/// bounded, so memory does not grow with the film. Record is a complete loop; Recording is for
/// programs with their own loop. Independent of the engine: the caller provides the content of each
/// frame.
namespace boxreel
{

/// The content of one frame, filled by the caller. The list and the overlay arrive empty, the
/// camera with its last value.
struct FrameContent
{
    DrawList list;       ///< items to draw
    Camera camera;       ///< visible part
    Overlay overlay;     ///< drawn on top; may be empty
    bool isLast = false; ///< the film ends with this frame, before frameCount
    bool stops = false;  ///< the recording stops before this frame, which may stay empty
};

/// Progress of a recording.
struct RecordingProgress
{
    std::int64_t framesDone = 0;     ///< encoded frames
    std::int64_t framesTotal = 0;    ///< requested frames
    std::int64_t framesRepeated = 0; ///< frames not drawn so far, because they equal the previous
                                     ///< one
    std::int64_t framesKept = 0;     ///< done frames that existed before this recording
};

/// Length and callbacks of a recording.
struct RecordingSettings
{
    std::int64_t frameCount = 600; ///< at least 1
    /// Called for frame 0, 1, 2, … in order, on the calling thread: advances the world and fills
    /// the content. It runs ahead: earlier frames are still drawn and encoded meanwhile.
    std::function<Result<void>(std::int64_t frame, FrameContent& content)> fill;
    /// Called on the calling thread after frames are encoded; may be empty. Returning false stops
    /// the recording early; frames already drawn are still encoded.
    std::function<bool(const RecordingProgress&)> progress;
    /// Called on the calling thread with the pixels of each frame, including repeated ones; may be
    /// empty.
    std::function<void(std::int64_t frame, const Frame& pixels)> seen;
};

/// Why a recording ended.
enum class RecordingEnd
{
    Complete, ///< the writer is closed
    Stopped,  ///< stopped by the caller; the writer is open, to be suspended or destroyed
};

/// Records the film and closes the writer. On an Error the writer stays open, so that its
/// destruction leaves no file under the final name. The film does not depend on timing: a frame
/// with the content of the previous one is repeated instead of drawn, with the same pixels. The
/// sizes of writer and renderer must be equal.
Result<RecordingEnd> Record(const RecordingSettings& settings, Renderer& renderer,
                            VideoWriter& writer);

/// Records a world of a program with its own main loop:
///
///     auto film = boxreel::Recording::Open("film.mp4");   // …
///     film->Add(list, camera);                            // in the loop, once per frame
///     film->Close();                                      // after it
///
/// Drawing overlaps with the loop; encoding runs on another thread. For pictures drawn by other
/// means, use VideoWriter.
class Recording
{
public:
    /// Starts the film. It is drawn in the size of the film; the size in `drawing` is ignored. The
    /// Errors of Renderer::Create and VideoWriter::Open.
    static Result<Recording> Open(const std::filesystem::path& path, const VideoSettings& film = {},
                                  const RendererSettings& drawing = {});
    /// Leaves the source in a moved-from state.
    Recording(Recording&&) noexcept;
    /// Leaves the source in a moved-from state.
    Recording& operator=(Recording&&) noexcept;
    ~Recording(); ///< removes the film unless closed

    /// Appends the next frame. The camera's size must be that of the film. False when this or an
    /// earlier frame failed; Close returns the reason.
    bool Add(const DrawList& list, const Camera& camera, const Overlay* overlay = nullptr);

    /// Waits for the encoder and renames the film to its final name. The object cannot be used
    /// afterwards. Returns the first Error; the film is then removed.
    Result<void> Close();

private:
    struct Impl;
    explicit Recording(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
