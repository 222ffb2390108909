// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

/// The engine on this machine, in a tenth of a second.
namespace boxreel
{

/// Returns the state hash of a small world (stacks, hinges, springs, a spinning box) after two
/// seconds, with one and with four sub-steps.
std::uint64_t RunSelfTest();

/// The result of RunSelfTest on every machine.
inline constexpr std::uint64_t kSelfTestState = 0x1fa1e5ea724252e1;

} // namespace boxreel
