// SPDX-License-Identifier: MIT
#pragma once

#include "FFmpegLibrary.h"

#include <base/AtomicFile.h>

#include <cstdint>
#include <optional>
#include <span>
#include <utility>

/// Connects libav's muxer with an AtomicFile or the standard output. Every file name is valid
/// ("a:b.mp4" is not a protocol), and Errors are reported in full. Used by FFmpegMuxer.
namespace boxreel
{

class FFmpegOutput
{
public:
    explicit FFmpegOutput(AtomicFile* file); ///< must outlive it; null: standard output
    FFmpegOutput(const FFmpegOutput&) = delete;
    FFmpegOutput& operator=(const FFmpegOutput&) = delete;

    /// Sets this output for `context`, which must not outlive it.
    void AttachTo(AVFormatContext& context);

    /// Writes libav's buffer to the file.
    void Flush();

    bool HasFailed() const { return m_error.has_value(); }

    /// Returns the first write error; `fallback` if there is none.
    Error FirstError(Error fallback) const { return m_error.value_or(std::move(fallback)); }

private:
    /// A position in the file. libav opens a second one for reading when it moves an index to the
    /// front.
    struct Cursor
    {
        FFmpegOutput* output = nullptr;
        std::int64_t position = 0;
    };

    FFmpegOwner<AVIOContext> MakeContext(Cursor& cursor, bool forWriting) const;
    static int OnWrite(void* opaque, const std::uint8_t* data, int size);
    static int OnRead(void* opaque, std::uint8_t* data, int size);
    static std::int64_t OnSeek(void* opaque, std::int64_t offset, int whence);
    static int OnOpen(AVFormatContext* context, AVIOContext** io, const char* url, int flags,
                      AVDictionary** options);
    static int OnClose(AVFormatContext* context, AVIOContext* io);

    Result<void> Write(std::int64_t position, std::span<const std::uint8_t> bytes);

    AtomicFile* m_file;
    std::int64_t m_size = 0;
    std::optional<Error> m_error;
    Cursor m_writing;
    Cursor m_reading;
    FFmpegOwner<AVIOContext> m_context;
};

} // namespace boxreel
