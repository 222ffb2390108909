// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// @file
/// The width of text in a picture at scale 1, to centre or place it. It comes from a table of the
/// pictures' font, so that it is the same on every machine, with or without the font. A missing
/// character is as wide as the '?' in its place.
namespace boxreel
{

/// Line height [px].
inline constexpr double kTextHeight = 15.0;

/// Returns the width of one line of UTF-8 [px], the maximum of that in pixels and that in SVG and
/// PDF. They differ by a few hundredths, because a renderer places glyphs on whole pixels. A tab
/// counts as a space.
double TextWidth(std::string_view line);

/// True if pictures have all its characters; otherwise an SVG's viewer uses others of a different
/// width.
bool HasLettersOf(std::string_view line);

/// Wraps the text to `room` [px] at spaces, tabs and line feeds, and inside words that are too
/// long. Returns at least one line, with at least one character per line.
std::vector<std::string> WrapText(std::string_view text, double room);

} // namespace boxreel
