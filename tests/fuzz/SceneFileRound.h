// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace fuzz
{

/// Does with a text, which may be anything, what the program does with a scene file: reads it,
/// notes its traps, builds its world, exports that, reads and builds the export, and steps both
/// worlds. A sentence that says what is wrong with the loader, or empty: a text that is refused is
/// refused in one clean sentence, and one that is taken comes back from its export as it was.
std::string WhyWrong(const std::string& text);

} // namespace fuzz
