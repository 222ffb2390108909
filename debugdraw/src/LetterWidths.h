// SPDX-License-Identifier: MIT
#pragma once

/// A table of how wide letters are in the font of pictures.
namespace boxreel
{

/// How far the pen goes on after it, in 2048ths of the font's em square; 0 where pictures lack it.
int LetterWidth(char32_t letter);

} // namespace boxreel
