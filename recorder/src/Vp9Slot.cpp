// SPDX-License-Identifier: MIT
#include "Vp9Slot.h"

#include "H264Bits.h"

#include <bit>
#include <cstddef>

namespace boxreel
{

namespace
{

constexpr std::uint32_t kFrameMarker = 2;

/// Returns the last frame of a packet, which is the one that is shown (annex B).
std::span<const std::uint8_t> LastFrame(std::span<const std::uint8_t> packet)
{
    const unsigned marker = packet.back();
    if (marker >> 5 != 6)
    {
        return packet;
    }
    const std::size_t sizeBytes = (marker >> 3 & 3u) + 1;
    const std::size_t frames = (marker & 7u) + 1;
    const std::size_t indexBytes = 2 + sizeBytes * frames;
    if (packet.size() < indexBytes || packet[packet.size() - indexBytes] != marker)
    {
        return packet;
    }
    const std::size_t index = packet.size() - indexBytes + 1;
    std::size_t begin = 0;
    std::size_t size = 0;
    for (std::size_t frame = 0; frame < frames; ++frame)
    {
        begin += size;
        size = 0;
        for (std::size_t byte = sizeBytes; byte-- > 0;)
        {
            size = size << 8 | packet[index + frame * sizeBytes + byte];
        }
    }
    return begin + size <= packet.size() ? packet.subspan(begin, size)
                                         : std::span<const std::uint8_t>();
}

} // namespace

std::optional<int> Vp9SlotShownBy(std::span<const std::uint8_t> packet)
{
    if (packet.empty())
    {
        return std::nullopt;
    }
    BitReader bits(LastFrame(packet));
    const bool isFrame = bits.Bits(2) == kFrameMarker;
    const std::uint32_t lowProfile = bits.Bits(1);
    const std::uint32_t profile = lowProfile + 2 * bits.Bits(1);
    bits.Bits(profile == 3 ? 1 : 0);
    if (!isFrame || bits.HasFailed())
    {
        return std::nullopt;
    }
    if (bits.Flag()) // shows a stored picture
    {
        return int(bits.Bits(3));
    }
    const bool isKeyframe = !bits.Flag();
    const bool isShown = bits.Flag();
    const bool isResilient = bits.Flag();
    if (isKeyframe)
    {
        return isShown ? std::optional(0) : std::nullopt; // it is stored in all slots
    }
    const bool isIntra = !isShown && bits.Flag();
    bits.Bits(isResilient ? 0 : 2);
    const std::uint32_t stored = bits.Bits(8);
    if (!isShown || isIntra || bits.HasFailed() || stored == 0)
    {
        return std::nullopt;
    }
    return std::countr_zero(stored);
}

std::uint8_t Vp9PacketShowing(int slot, int profile)
{
    const int low = profile & 1;
    const int high = profile >> 1;
    return std::uint8_t(kFrameMarker << 6 | unsigned(low << 5 | high << 4 | 1 << 3 | slot));
}

} // namespace boxreel
