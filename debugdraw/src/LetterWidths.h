// SPDX-License-Identifier: MIT
#pragma once

/// A table of advance widths in the font of pictures.
namespace boxreel
{

/// Returns the advance width in 1/2048 em; 0 for characters missing in pictures.
int LetterWidth(char32_t letter);

} // namespace boxreel
