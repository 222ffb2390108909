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

/// Feeds a VideoWriter on a separate thread through a ring of frames. Memory stays constant, and
/// nothing is allocated once the ring is filled. Used by Record; one thread writes to the ring,
/// this one reads.
namespace boxreel
{

class EncoderThread
{
public:
    /// Only the thread may use the writer until Finish or the destructor.
    explicit EncoderThread(VideoWriter& writer);
    ~EncoderThread(); ///< discards frames still in the ring
    EncoderThread(const EncoderThread&) = delete;
    EncoderThread& operator=(const EncoderThread&) = delete;

    /// Waits for space and appends a copy. `frame` differs from the previous one only inside
    /// `changed`. False if the writer failed.
    bool Append(const Frame& frame, std::span<const PixelBounds> changed);

    /// Waits for space and repeats the previous frame. False if the writer failed.
    bool Repeat();

    std::int64_t FramesDone();

    /// Waits until more than `known` frames are done, all are done, or the writer failed. Returns
    /// the number of done frames.
    std::int64_t WaitForMore(std::int64_t known);

    /// Ends the thread after the remaining frames. Returns the writer's Error, if any.
    Result<void> Finish();

private:
    struct Slot
    {
        Frame frame;
        std::vector<PixelBounds> changed; // since the previous frame
        StaleTiles stale;                 // outdated areas of `frame`; used by the caller only
        bool isRepeat = false;
    };
    // Buffers frames that take long to draw or encode; more only costs memory.
    static constexpr std::size_t kDepth = 4;

    Slot* WaitForRoom();
    void HandOver();
    Result<void> Encode(const Slot& slot);
    void Work();
    void End(bool isDropping);

    VideoWriter& m_writer;
    StageTimes* m_stages;
    std::array<Slot, kDepth> m_slots;
    std::mutex m_mutex; // guards the members below; a slot belongs to the thread whose turn it is
    std::condition_variable m_changed;
    std::size_t m_first = 0; // the slot to encode next
    std::size_t m_count = 0; // slots appended and not yet encoded
    std::int64_t m_done = 0;
    std::optional<Error> m_error;
    bool m_isEnding = false;
    bool m_isDropping = false;
    std::thread m_thread;
};

} // namespace boxreel
