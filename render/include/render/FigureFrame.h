// SPDX-License-Identifier: MIT
#pragma once

#include <render/Backend.h>
#include <render/Figure.h>
#include <render/Frame.h>
#include <render/Renderer.h>

#include <string>
#include <vector>

/// @file
/// A figure of any number of panels as pixels: the picture that its SVG and PDF show.
namespace boxreel
{

/// Each panel is drawn as a Renderer of its size draws it, pixel for pixel; what lies below shows
/// through one that is put over others. Panels begin on whole pixels, and figures with their scale
/// have at most 8192 each way. Absent when no back end works, Unusable for sizes and cameras that
/// cannot be. `totals`, when given, is what was drawn for it, summed over the panels.
Result<Frame> ToFrame(const Figure& figure, Backend backend = Backend::Auto,
                      RenderTotals* totals = nullptr);

/// The letters of the figure's texts that pixels cannot show, for the font of pictures has none of
/// them: each once, as they come. A PDF shows more, and an SVG what its viewer's fonts have.
std::vector<std::string> LettersWithoutPixels(const Figure& figure);

/// Whether this machine can draw: asked before long work is done for a picture. An Error as of
/// Renderer::Create.
Result<void> PrepareFrames(Backend backend = Backend::Auto);

} // namespace boxreel
