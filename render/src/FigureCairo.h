// SPDX-License-Identifier: MIT
#pragma once

#include <render/Figure.h>
#include <render/Frame.h>

/// A figure as Cairo itself turns it into pixels: the same code that writes the PDF. For tests,
/// which compare it with the Renderer's picture.
namespace boxreel
{

Result<Frame> RasterizeFigure(const Figure& figure);

} // namespace boxreel
