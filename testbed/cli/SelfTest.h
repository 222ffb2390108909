// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The engine on this machine, in a tenth of a second.
namespace boxreel
{

/// The state that a small world of everything, piles, hinges, springs, a spinning box, has after
/// two seconds, with one and with four small steps.
std::uint64_t RunSelfTest();

/// What it is on every machine.
inline constexpr std::uint64_t kSelfTestState = 0xfbcca0e2541249cd;

} // namespace boxreel
