// SPDX-License-Identifier: MIT
#include "H264Repeat.h"

#include "H264Bits.h"

#include <algorithm>
#include <utility>

namespace boxreel
{

namespace
{

// Types of units (table 7-1).
constexpr unsigned kSlice = 1;
constexpr unsigned kSliceOfReset = 5; // IDR: the decoder forgets what was before
constexpr unsigned kSequenceSet = 7;
constexpr unsigned kPictureSet = 8;

constexpr std::int64_t kOrderStep = 2; // order counts of two frames, each of which has two fields

constexpr std::uint32_t kImplicitWeights = 2;

/// Returns the bits of order counts in the film. They are whole bytes more than the encoder's, so
/// the rest of a slice keeps its position within a byte. Arithmetic code needs that. At least 12:
/// 1000 pictures between two references.
int WiderOrder(int bits)
{
    return bits == 0 ? 16 : bits <= 8 ? bits + 8 : bits;
}

unsigned TypeOf(std::uint8_t first)
{
    return first & 31u;
}

/// Profiles with the fields of chroma and scaling (7.3.2.1.1).
bool HasChromaFields(std::uint32_t profile)
{
    constexpr std::uint32_t kProfiles[] = {100, 110, 122, 244, 44, 83, 86, 118, 128};
    return std::find(std::begin(kProfiles), std::end(kProfiles), profile) != std::end(kProfiles);
}

/// True if the fields of appearance (annex E) demand that each picture has timing of its own.
bool NamesTimes(BitReader& bits)
{
    constexpr std::uint32_t kOtherAspect = 255;
    if (bits.Flag() && bits.Bits(8) == kOtherAspect) // aspect ratio
    {
        bits.Bits(32);
    }
    if (bits.Flag()) // overscan
    {
        bits.Bits(1);
    }
    if (bits.Flag()) // kind of signal
    {
        bits.Bits(4);
        bits.Bits(bits.Flag() ? 24 : 0);
    }
    if (bits.Flag()) // place of chroma
    {
        bits.Unsigned();
        bits.Unsigned();
    }
    if (bits.Flag()) // time base
    {
        bits.Bits(32);
        bits.Bits(32);
        bits.Bits(1);
    }
    const bool hasBuffers = bits.Bits(2) != 0; // of units and of slices
    const bool hasStructure = !hasBuffers && bits.Flag();
    return hasBuffers || hasStructure;
}

} // namespace

/// Reads a sequence parameter set (7.3.2.1.1) and appends it to the header, with wider order
/// counts of type 0.
bool H264Repeat::ReadSequence(std::span<const std::uint8_t> unit)
{
    const Bytes raw = Unescaped(unit);
    BitReader bits(raw);
    bits.Bits(8);
    const std::uint32_t profile = bits.Bits(8);
    bits.Bits(16);
    bits.Unsigned(); // number of the set
    if (HasChromaFields(profile))
    {
        constexpr std::uint32_t kFullChroma = 3;
        if (bits.Unsigned() == kFullChroma && bits.Flag())
        {
            return false; // each colour is a picture
        }
        bits.Unsigned(); // depth of luma
        bits.Unsigned(); // of chroma
        bits.Flag();     // lossless
        if (bits.Flag())
        {
            return false; // scaling lists, which the encoder has only when asked
        }
    }
    m_sequence.frameNumberBits = int(bits.Unsigned()) + 4;
    const std::size_t order = bits.Position();
    const std::uint32_t orderType = bits.Unsigned();
    m_sequence.orderBits = orderType == 0 ? int(bits.Unsigned()) + 4 : 0;
    const std::size_t rest = bits.Position();
    bits.Unsigned(); // references
    bits.Flag();
    const std::uint32_t columns = bits.Unsigned() + 1;
    m_sequence.macroblocks = columns * (bits.Unsigned() + 1);
    const bool areFrames = bits.Flag();
    bits.Flag();
    for (int i = bits.Flag() ? 4 : 0; i > 0; --i)
    {
        bits.Unsigned(); // pixels at an edge that are not shown
    }
    if (!areFrames || orderType == 1 || (bits.Flag() && NamesTimes(bits)) || bits.HasFailed())
    {
        return false;
    }
    BitWriter written;
    written.Copy(raw, 0, order);
    written.Unsigned(0);
    written.Unsigned(std::uint32_t(WiderOrder(m_sequence.orderBits)) - 4);
    written.Copy(raw, rest, EndOfBits(raw));
    written.End();
    AppendUnit(written.Bytes(), m_header);
    return true;
}

/// Reads a picture parameter set (7.3.2.2).
bool H264Repeat::ReadPicture(std::span<const std::uint8_t> unit)
{
    const Bytes raw = Unescaped(unit);
    BitReader bits(raw);
    bits.Bits(8);
    m_pictureSet = bits.Unsigned();
    bits.Unsigned(); // number of the sequence
    bits.Flag();     // arithmetic code
    const bool hasBottomOrder = bits.Flag();
    const bool hasGroups = bits.Unsigned() != 0;
    const std::uint32_t references = bits.Unsigned() + 1;
    bits.Unsigned();
    bits.Flag(); // weights of P
    // Implicit weights follow from order counts. With one reference they are those of pictures
    // between which none is repeated.
    const bool areWeightsSafe = bits.Bits(2) != kImplicitWeights || references == 1;
    return !hasGroups && !hasBottomOrder && areWeightsSafe && !bits.HasFailed();
}

/// A picture parameter set for repetitions, without arithmetic code: a slice that skips everything
/// is then a single number.
H264Repeat::Bytes H264Repeat::OwnPicture() const
{
    BitWriter bits;
    bits.Bits(3u << 5 | kPictureSet, 8);
    bits.Unsigned(m_pictureSet + 1);
    bits.Unsigned(0); // number of the sequence
    bits.Flag(false); // arithmetic code
    bits.Flag(false); // order of the bottom field
    bits.Unsigned(0); // groups of slices
    bits.Unsigned(0); // references
    bits.Unsigned(0);
    bits.Flag(false); // weights
    bits.Bits(0, 2);
    bits.Signed(0); // quantisers
    bits.Signed(0);
    bits.Signed(0);
    bits.Flag(true);  // a slice can turn deblocking off
    bits.Flag(false); // intra prediction
    bits.Flag(false); // redundant pictures
    bits.End();
    return bits.Bytes();
}

std::optional<H264Repeat> H264Repeat::Create(std::span<const std::uint8_t> header)
{
    H264Repeat repeat;
    int sequences = 0;
    int pictures = 0;
    for (const std::span<const std::uint8_t> unit : SplitUnits(header))
    {
        const unsigned type = TypeOf(unit[0]);
        const bool isRead = type == kSequenceSet  ? repeat.ReadSequence(unit)
                            : type == kPictureSet ? repeat.ReadPicture(unit)
                                                  : true;
        if (!isRead)
        {
            return std::nullopt;
        }
        sequences += type == kSequenceSet ? 1 : 0;
        pictures += type == kPictureSet ? 1 : 0;
        if (type != kSequenceSet)
        {
            AppendEscaped(unit, repeat.m_header);
        }
        if (type == kPictureSet)
        {
            AppendUnit(repeat.OwnPicture(), repeat.m_header);
        }
    }
    return sequences == 1 && pictures == 1 ? std::optional(std::move(repeat)) : std::nullopt;
}

/// Copies a slice (7.3.3) with the film's order count.
bool H264Repeat::PlaceSlice(std::span<const std::uint8_t> unit, std::int64_t index, Bytes& out)
{
    const Bytes raw = Unescaped(unit);
    BitReader bits(raw);
    const bool isReference = bits.Bits(8) >> 5 != 0;
    bits.Unsigned(); // first macroblock
    bits.Unsigned(); // type of the slice
    bits.Unsigned(); // number of the picture set
    const std::uint32_t frameNumber = bits.Bits(m_sequence.frameNumberBits);
    if (TypeOf(raw[0]) == kSliceOfReset)
    {
        bits.Unsigned();
        m_start = index;
        m_shown = -1;
    }
    const std::size_t order = bits.Position();
    bits.Bits(m_sequence.orderBits);
    if (bits.HasFailed())
    {
        return false;
    }
    BitWriter written;
    written.Copy(raw, 0, order);
    WriteOrder(index, written);
    written.Copy(raw, bits.Position(), EndOfBits(raw));
    written.End();
    AppendUnit(written.Bytes(), out);
    if (isReference)
    {
        m_frameNumber = frameNumber;
        m_shownNumber = index >= m_shown ? frameNumber : m_shownNumber;
        m_shown = std::max(m_shown, index);
    }
    return true;
}

void H264Repeat::WriteOrder(std::int64_t index, BitWriter& bits) const
{
    const int count = WiderOrder(m_sequence.orderBits);
    bits.Bits(std::uint32_t((index - m_start) * kOrderStep) & ((1u << count) - 1), count);
}

std::optional<H264Repeat::Bytes> H264Repeat::Place(std::span<const std::uint8_t> packet,
                                                   std::int64_t index)
{
    Bytes out;
    out.reserve(packet.size() + 16);
    for (const std::span<const std::uint8_t> unit : SplitUnits(packet))
    {
        const unsigned type = TypeOf(unit[0]);
        if (type == kSequenceSet || type == kPictureSet)
        {
            continue; // the header has them
        }
        if (type != kSlice && type != kSliceOfReset)
        {
            AppendEscaped(unit, out);
        }
        else if (!PlaceSlice(unit, index, out))
        {
            return std::nullopt;
        }
    }
    return out;
}

std::optional<H264Repeat::Bytes> H264Repeat::Repeat(std::int64_t index, std::int64_t shown) const
{
    if (m_shown != shown)
    {
        return std::nullopt;
    }
    constexpr std::uint32_t kOnlyP = 5; // all slices of the picture are P
    const std::uint32_t numbers = 1u << m_sequence.frameNumberBits;
    const std::uint32_t frameNumber = (m_frameNumber + 1) % numbers;
    const std::uint32_t back = (frameNumber - m_shownNumber + numbers) % numbers;
    BitWriter bits;
    bits.Bits(kSlice, 8); // no reference
    bits.Unsigned(0);     // first macroblock
    bits.Unsigned(kOnlyP);
    bits.Unsigned(m_pictureSet + 1);
    bits.Bits(frameNumber, m_sequence.frameNumberBits);
    WriteOrder(index, bits);
    bits.Flag(false); // number of references: the set's, one
    bits.Flag(back != 1);
    if (back != 1) // not the reference that was decoded last
    {
        bits.Unsigned(0); // back by
        bits.Unsigned(back - 1);
        bits.Unsigned(3); // end
    }
    bits.Signed(0);   // quantiser
    bits.Unsigned(1); // no deblocking
    bits.Unsigned(m_sequence.macroblocks);
    bits.End();
    Bytes out;
    AppendUnit(bits.Bytes(), out);
    return out;
}

} // namespace boxreel
