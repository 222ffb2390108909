// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// @file
/// How much room text takes in a picture at scale 1, for whoever puts it in the middle of something
/// or beside it. A table of the pictures' font, so that it is the same on every machine, with the
/// font or without; a letter that pictures lack is as wide as the '?' in its place.
namespace boxreel
{

/// Of a line [px]; a text's next line begins this much lower.
inline constexpr double kTextHeight = 15.0;

/// Of one line of UTF-8 [px]: in pixels or in SVG and PDF, whichever is the wider; they differ by a
/// few hundredths, for a renderer puts letters on whole pixels. A tab is a space.
double TextWidth(std::string_view line);

/// Whether pictures have all its letters. If not, an SVG's viewer has others of another width.
bool HasLettersOf(std::string_view line);

/// The text in lines of at most `room` [px], parted at spaces, tabs and line feeds, and within a
/// word that is longer than that. At least one line, and at least a letter a line.
std::vector<std::string> WrapText(std::string_view text, double room);

} // namespace boxreel
