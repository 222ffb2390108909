// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fuzz
{

/// Handles any text like a scene file: reads it, notes its traps, builds its world, exports that,
/// reads and builds the export, and steps both worlds. A refused text must produce one clean
/// sentence. An accepted text must come back unchanged from its export. Returns the error of the
/// loader as a sentence; empty if there is none.
std::string WhyWrong(const std::string& text);

} // namespace fuzz
