// SPDX-License-Identifier: MIT
#include "EncoderThread.h"

namespace boxreel
{

EncoderThread::EncoderThread(VideoWriter& writer) : m_writer(writer), m_thread([this] { Work(); })
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

Frame* EncoderThread::BeginFrame()
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_count < kDepth || m_error; });
    return m_error ? nullptr : &m_slots[(m_first + m_count) % kDepth].frame;
}

void EncoderThread::EndFrame(bool isRepeat)
{
    {
        const std::lock_guard lock(m_mutex);
        m_slots[(m_first + m_count) % kDepth].isRepeat = isRepeat;
        ++m_count;
    }
    m_changed.notify_all();
}

std::int64_t EncoderThread::FramesDone()
{
    const std::lock_guard lock(m_mutex);
    return m_done;
}

std::int64_t EncoderThread::WaitForMore(std::int64_t known)
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this, known] { return m_done > known || m_count == 0 || m_error; });
    return m_done;
}

Result<void> EncoderThread::Finish()
{
    End(false);
    return m_error ? Result<void>(*m_error) : Result<void>();
}

void EncoderThread::Work()
{
    std::unique_lock lock(m_mutex);
    while (true)
    {
        m_changed.wait(lock, [this] { return m_count > 0 || m_isEnding; });
        if (m_count == 0 || m_isDropping)
        {
            return;
        }
        const Slot& slot = m_slots[m_first];
        lock.unlock();
        const Result<void> done = slot.isRepeat ? m_writer.Repeat() : m_writer.Append(slot.frame);
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
