// SPDX-License-Identifier: MIT
#pragma once

#include <render/Frame.h>

#include <cstdint>
#include <memory>
#include <span>

/// PNG files of opaque frames, for sequences: faster than zlib's fastest level and not larger
/// (docs/notes/png.md). Deflate (RFC 1951) looks for repetitions in general; a drawing repeats the
/// pixel to the left, the row above, or an edge like one before. Only these three places are
/// compared.
namespace boxreel
{

/// Keeps its buffers from frame to frame: allocating megabytes for each is slow
/// (docs/notes/png.md). For one thread.
class PngStream
{
public:
    PngStream();
    ~PngStream();

    /// Returns the bytes of a PNG file (RGB, 8 bits), or none if a pixel is transparent. They stay
    /// until the next call. `frame` has pixels. Same frame, same bytes.
    std::span<const std::uint8_t> Encode(const Frame& frame);

private:
    struct Buffers;
    std::unique_ptr<Buffers> m_buffers;
};

} // namespace boxreel
