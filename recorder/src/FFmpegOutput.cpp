// SPDX-License-Identifier: MIT
#include "FFmpegOutput.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace boxreel
{

namespace
{

constexpr int kBufferSize = 1 << 16; // a packet or two; larger brings nothing

} // namespace

FFmpegOutput::FFmpegOutput(AtomicFile& file) : m_file(file), m_writing{this}, m_reading{this}
{
    m_context = MakeContext(m_writing, true);
}

FFmpegOwner<AVIOContext> FFmpegOutput::MakeContext(Cursor& cursor, bool forWriting)
{
    auto* buffer = static_cast<unsigned char*>(FFmpeg().av_malloc(kBufferSize));
    return FFmpegOwner<AVIOContext>(FFmpeg().avio_alloc_context(
        buffer, kBufferSize, forWriting ? 1 : 0, &cursor, forWriting ? nullptr : OnRead,
        forWriting ? OnWrite : nullptr, OnSeek));
}

void FFmpegOutput::AttachTo(AVFormatContext& context)
{
    context.pb = m_context.get();
    context.opaque = this;
    context.io_open = OnOpen;
    context.io_close2 = OnClose;
}

void FFmpegOutput::Flush()
{
    FFmpeg().avio_flush(m_context.get());
}

int FFmpegOutput::OnWrite(void* opaque, std::uint8_t* data, int size)
{
    auto& cursor = *static_cast<Cursor*>(opaque);
    FFmpegOutput& output = *cursor.output;
    if (output.HasFailed())
    {
        return AVERROR(EIO);
    }
    if (Result<void> done = output.m_file.WriteAt(cursor.position, {data, std::size_t(size)});
        !done)
    {
        output.m_error = done.GetError();
        return AVERROR(EIO);
    }
    cursor.position += size;
    output.m_size = std::max(output.m_size, cursor.position);
    return size;
}

int FFmpegOutput::OnRead(void* opaque, std::uint8_t* data, int size)
{
    auto& cursor = *static_cast<Cursor*>(opaque);
    Result<std::size_t> got =
        cursor.output->m_file.ReadAt(cursor.position, {data, std::size_t(size)});
    if (!got)
    {
        cursor.output->m_error = got.GetError();
        return AVERROR(EIO);
    }
    cursor.position += std::int64_t(*got);
    return *got > 0 ? int(*got) : AVERROR_EOF;
}

std::int64_t FFmpegOutput::OnSeek(void* opaque, std::int64_t offset, int whence)
{
    auto& cursor = *static_cast<Cursor*>(opaque);
    const std::int64_t size = cursor.output->m_size;
    if ((whence & AVSEEK_SIZE) != 0)
    {
        return size;
    }
    const int from = whence & ~AVSEEK_FORCE;
    const std::int64_t base = from == SEEK_SET ? 0 : from == SEEK_CUR ? cursor.position : size;
    if (base + offset < 0)
    {
        return AVERROR(EINVAL);
    }
    cursor.position = base + offset;
    return cursor.position;
}

int FFmpegOutput::OnOpen(AVFormatContext* context, AVIOContext** io, const char*, int flags,
                         AVDictionary**)
{
    if ((flags & AVIO_FLAG_WRITE) != 0)
    {
        return AVERROR(EPERM); // a film is one file
    }
    auto& output = *static_cast<FFmpegOutput*>(context->opaque);
    output.m_reading.position = 0;
    *io = MakeContext(output.m_reading, false).release();
    return *io != nullptr ? 0 : AVERROR(ENOMEM);
}

int FFmpegOutput::OnClose(AVFormatContext*, AVIOContext* io)
{
    FFmpegOwner<AVIOContext> closing(io);
    return 0;
}

} // namespace boxreel
