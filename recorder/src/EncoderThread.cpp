// SPDX-License-Identifier: MIT
#include "EncoderThread.h"

#include <cstring>

namespace boxreel
{

namespace
{

void CopyPixels(const Frame& from, const PixelBounds& part, Frame& to)
{
    const std::size_t bytes = std::size_t(part.x1 - part.x0) * 4;
    for (int y = part.y0; y < part.y1; ++y)
    {
        std::memcpy(to.Pixel(part.x0, y), from.Pixel(part.x0, y), bytes);
    }
}

/// Makes `to` equal to `from`, from which it differs inside of `stale` only. Parts that come
/// several times are copied several times; when that is more than a whole frame, it is one.
void BringUpToDate(const Frame& from, std::span<const PixelBounds> stale, Frame& to)
{
    std::int64_t area = 0;
    for (const PixelBounds& part : stale)
    {
        area += part.Area();
    }
    const bool isFirst = to.width != from.width || to.height != from.height;
    if (isFirst || area >= std::int64_t(from.width) * from.height)
    {
        to = from;
        return;
    }
    for (const PixelBounds& part : stale)
    {
        CopyPixels(from, part, to);
    }
}

} // namespace

EncoderThread::EncoderThread(VideoWriter& writer, StageTimes* stages)
    : m_writer(writer), m_stages(stages), m_thread([this] { Work(); })
{}

EncoderThread::~EncoderThread()
{
    End(true);
}

void EncoderThread::End(bool isDropping)
{
    if (!m_thread.joinable())
    {
        return;
    }
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
        m_isDropping = isDropping;
    }
    m_changed.notify_all();
    m_thread.join();
}

EncoderThread::Slot* EncoderThread::WaitForRoom()
{
    const StageTimer timer(m_stages, Stage::WaitForEncoder);
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_count < kDepth || m_error; });
    return m_error ? nullptr : &m_slots[(m_first + m_count) % kDepth];
}

void EncoderThread::HandOver()
{
    {
        const std::lock_guard lock(m_mutex);
        ++m_count;
    }
    m_changed.notify_all();
}

bool EncoderThread::Append(const Frame& frame, std::span<const PixelBounds> changed)
{
    Slot* slot = WaitForRoom();
    if (slot == nullptr)
    {
        return false;
    }
    const StageTimer timer(m_stages, Stage::Copy);
    for (Slot& other : m_slots)
    {
        other.stale.insert(other.stale.end(), changed.begin(), changed.end());
    }
    BringUpToDate(frame, slot->stale, slot->frame);
    slot->stale.clear();
    slot->changed.assign(changed.begin(), changed.end());
    slot->isRepeat = false;
    HandOver();
    return true;
}

bool EncoderThread::Repeat()
{
    Slot* slot = WaitForRoom();
    if (slot == nullptr)
    {
        return false;
    }
    slot->isRepeat = true;
    HandOver();
    return true;
}

std::int64_t EncoderThread::FramesDone()
{
    const std::lock_guard lock(m_mutex);
    return m_done;
}

std::int64_t EncoderThread::WaitForMore(std::int64_t known)
{
    const StageTimer timer(m_stages, Stage::WaitForEncoder);
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this, known] { return m_done > known || m_count == 0 || m_error; });
    return m_done;
}

Result<void> EncoderThread::Finish()
{
    End(false);
    return m_error ? Result<void>(*m_error) : Result<void>();
}

Result<void> EncoderThread::Encode(const Slot& slot)
{
    return slot.isRepeat ? m_writer.Repeat() : m_writer.Append(slot.frame, slot.changed);
}

void EncoderThread::Work()
{
    std::unique_lock lock(m_mutex);
    while (true)
    {
        {
            const StageTimer timer(m_stages, Stage::WaitForFrame);
            m_changed.wait(lock, [this] { return m_count > 0 || m_isEnding; });
        }
        if (m_count == 0 || m_isDropping)
        {
            return;
        }
        const Slot& slot = m_slots[m_first];
        lock.unlock();
        const Result<void> done = Encode(slot);
        lock.lock();
        if (!done)
        {
            m_error = done.GetError();
            m_changed.notify_all();
            return;
        }
        m_first = (m_first + 1) % kDepth;
        --m_count;
        ++m_done;
        m_changed.notify_all();
    }
}

} // namespace boxreel
