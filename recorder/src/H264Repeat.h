// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// Pictures of an H.264 stream that equal the one before, written without an encoder (ITU-T H.264).
/// Such a picture is a slice in which every macroblock is skipped: a dozen bytes. It is not a
/// reference, so it does not affect the encoder's pictures. Only their picture order counts are
/// written again, with more bits, because the encoder counts its own pictures alone. Plain bytes,
/// without libav; used by FFmpegRepeat.
namespace boxreel
{

class BitWriter;

class H264Repeat
{
public:
    using Bytes = std::vector<std::uint8_t>;

    /// `header`: the encoder's parameter sets, with start codes. None if the stream has fields,
    /// timing that names each picture, or weights that depend on the order counts of pictures
    /// farther apart.
    static std::optional<H264Repeat> Create(std::span<const std::uint8_t> header);

    /// The parameter sets of the film.
    const Bytes& Header() const { return m_header; }

    /// Gives the next packet of the encoder its place: its picture is shown as number `index`. None
    /// if the packet cannot be read.
    std::optional<Bytes> Place(std::span<const std::uint8_t> packet, std::int64_t index);

    /// Returns a picture, shown as number `index`, that equals picture `shown`: the last one placed
    /// that others refer to, at `shown`. None if it cannot be referred to.
    std::optional<Bytes> Repeat(std::int64_t index, std::int64_t shown) const;

private:
    struct Sequence
    {
        int frameNumberBits = 4;
        int orderBits = 4; ///< in the encoder's slices; 0 unless of type 0
        std::uint32_t macroblocks = 0;
    };
    bool ReadSequence(std::span<const std::uint8_t> unit);
    bool ReadPicture(std::span<const std::uint8_t> unit);
    Bytes OwnPicture() const;
    void WriteOrder(std::int64_t index, BitWriter& bits) const;
    bool PlaceSlice(std::span<const std::uint8_t> unit, std::int64_t index, Bytes& out);

    Sequence m_sequence;
    std::uint32_t m_pictureSet = 0; ///< its number
    Bytes m_header;
    std::int64_t m_start = 0;        ///< index of the last picture that resets the decoder
    std::uint32_t m_frameNumber = 0; ///< of the last reference in decoding order
    std::int64_t m_shown = -1;       ///< index of the reference that is shown last
    std::uint32_t m_shownNumber = 0; ///< the frame number of m_shown
};

} // namespace boxreel
