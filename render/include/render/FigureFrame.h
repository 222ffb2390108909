// SPDX-License-Identifier: MIT
#pragma once

#include <render/Backend.h>
#include <render/Figure.h>
#include <render/Frame.h>
#include <render/Renderer.h>

#include <string>
#include <vector>

/// @file
/// Renders a figure of one or more panels to pixels: the same picture as its SVG and PDF.
namespace boxreel
{

/// Renders each panel exactly as a Renderer of its size does. Panels below are visible through
/// overlapping ones. Panels start on whole pixels. Width and height after scaling are at most 8192.
/// An Error (Absent) when no back end works, (Unusable) for an invalid size or camera. `totals`, if
/// given, receives the statistics, summed over the panels.
Result<Frame> ToFrame(const Figure& figure, Backend backend = Backend::Auto,
                      RenderTotals* totals = nullptr);

/// Returns the characters of the figure's texts that are missing in the font of frames, each once,
/// in order. A PDF has more; an SVG uses the fonts of its viewer.
std::vector<std::string> LettersWithoutPixels(const Figure& figure);

/// Checks that this machine can render, before long work starts. An Error as in Renderer::Create.
Result<void> PrepareFrames(Backend backend = Backend::Auto);

} // namespace boxreel
