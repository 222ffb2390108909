// SPDX-License-Identifier: MIT
#include "FFmpegOutput.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include <unistd.h>

namespace boxreel
{

namespace
{

constexpr int kBufferSize = 1 << 16; // one or two packets; a larger buffer is not faster

/// Writes all bytes, waiting for a slow reader.
Result<void> WriteToStandardOutput(std::span<const std::uint8_t> bytes)
{
    while (!bytes.empty())
    {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
        {
            return Error{ErrorKind::Failed, "standard output",
                         errno == EPIPE ? "the program that reads the film has stopped"
                                        : "the film cannot be written: " +
                                              std::generic_category().message(errno),
                         errno == EPIPE ? "check its messages" : "check its destination"};
        }
        bytes = bytes.subspan(std::size_t(written < 0 ? 0 : written));
    }
    return {};
}

} // namespace

FFmpegOutput::FFmpegOutput(AtomicFile* file) : m_file(file), m_writing{this}, m_reading{this}
{
    m_context = MakeContext(m_writing, true);
}

FFmpegOwner<AVIOContext> FFmpegOutput::MakeContext(Cursor& cursor, bool forWriting) const
{
    auto* buffer = static_cast<unsigned char*>(FFmpeg().av_malloc(kBufferSize));
    // libav's buffer is const since FFmpeg 7, and was not const before.
    const auto onWrite = [](void* opaque, auto* data, int size) {
        return OnWrite(opaque, data, size);
    };
    return FFmpegOwner<AVIOContext>(
        FFmpeg().avio_alloc_context(buffer, kBufferSize, forWriting ? 1 : 0, &cursor, OnRead,
                                    onWrite, m_file != nullptr ? OnSeek : nullptr));
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

Result<void> FFmpegOutput::Write(std::int64_t position, std::span<const std::uint8_t> bytes)
{
    return m_file != nullptr ? m_file->WriteAt(position, bytes) : WriteToStandardOutput(bytes);
}

int FFmpegOutput::OnWrite(void* opaque, const std::uint8_t* data, int size)
{
    auto& cursor = *static_cast<Cursor*>(opaque);
    FFmpegOutput& output = *cursor.output;
    if (output.HasFailed())
    {
        return AVERROR(EIO);
    }
    if (Result<void> done = output.Write(cursor.position, {data, std::size_t(size)}); !done)
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
        cursor.output->m_file->ReadAt(cursor.position, {data, std::size_t(size)});
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
    *io = output.MakeContext(output.m_reading, false).release();
    return *io != nullptr ? 0 : AVERROR(ENOMEM);
}

int FFmpegOutput::OnClose(AVFormatContext*, AVIOContext* io)
{
    FFmpegOwner<AVIOContext> closing(io);
    return 0;
}

} // namespace boxreel
