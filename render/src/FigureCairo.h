// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>
#include <render/Frame.h>

/// Renders a figure to pixels with Cairo, by the code that writes the PDF. For tests that compare
/// it with the Renderer's picture.
namespace boxreel
{

Result<Frame> RasterizeFigure(const Figure& figure);

} // namespace boxreel
