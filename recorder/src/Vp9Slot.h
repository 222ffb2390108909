// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

/// The place in a VP9 decoder of the picture that a packet shows (VP9 bitstream specification 0.6,
/// 6.2 and annex B). Plain bytes, without libav; used by FFmpegRepeat.
namespace boxreel
{

/// Returns the slot that holds the picture after the packet; none if no slot does, or the packet
/// cannot be read.
std::optional<int> Vp9SlotShownBy(std::span<const std::uint8_t> packet);

/// Returns the packet that shows the picture in `slot` again.
std::uint8_t Vp9PacketShowing(int slot, int profile);

} // namespace boxreel
