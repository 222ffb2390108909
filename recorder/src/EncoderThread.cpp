// SPDX-License-Identifier: MIT
#include "EncoderThread.h"

#include <algorithm>

namespace boxreel
{

EncoderThread::EncoderThread(VideoWriter& writer)
    : m_writer(writer), m_stages(writer.Stages()), m_thread([this] { Work(); })
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
        std::for_each(changed.begin(), changed.end(),
                      [&other](const PixelBounds& part) { other.stale.Mark(part); });
    }
    slot->stale.BringUpToDate(frame, slot->frame);
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
