// SPDX-License-Identifier: MIT
#pragma once

#include "StaleTiles.h"

#include <recorder/VideoWriter.h>

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

/// Feeds a VideoWriter on a thread of its own through a ring of frames, so that memory stays flat
/// and nothing is allocated once the ring is warm. Used by Record; one thread fills, this one
/// empties.
namespace boxreel
{

class EncoderThread
{
public:
    /// The writer belongs to the thread until Finish or the destructor.
    explicit EncoderThread(VideoWriter& writer);
    ~EncoderThread(); ///< what still waits is dropped
    EncoderThread(const EncoderThread&) = delete;
    EncoderThread& operator=(const EncoderThread&) = delete;

    /// Waits for room and hands over a copy. `frame` differs from the one handed over before inside
    /// of `changed` only. False when the writer has failed.
    bool Append(const Frame& frame, std::span<const PixelBounds> changed);

    /// Waits for room; the frame before comes once more. False when the writer has failed.
    bool Repeat();

    std::int64_t FramesDone();

    /// Waits until more than `known` frames are done, all are, or the writer has failed.
    std::int64_t WaitForMore(std::int64_t known);

    /// Ends the thread after what waits is done. What the writer said when it failed.
    Result<void> Finish();

private:
    struct Slot
    {
        Frame frame;
        std::vector<PixelBounds> changed; // since the frame before
        StaleTiles stale;                 // where `frame` shows an older one; the caller's
        bool isRepeat = false;
    };
    // Evens out frames that take long to draw or to encode; more only costs memory.
    static constexpr std::size_t kDepth = 4;

    Slot* WaitForRoom();
    void HandOver();
    Result<void> Encode(const Slot& slot);
    void Work();
    void End(bool isDropping);

    VideoWriter& m_writer;
    StageTimes* m_stages;
    std::array<Slot, kDepth> m_slots;
    std::mutex m_mutex; // guards what follows; a slot belongs to whose turn it is
    std::condition_variable m_changed;
    std::size_t m_first = 0; // the slot to encode next
    std::size_t m_count = 0; // slots handed over and not yet encoded
    std::int64_t m_done = 0;
    std::optional<Error> m_error;
    bool m_isEnding = false;
    bool m_isDropping = false;
    std::thread m_thread;
};

} // namespace boxreel
