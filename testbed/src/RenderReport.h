// SPDX-License-Identifier: MIT
#pragma once

#include <render/Renderer.h>

#include <string>

/// What --stats prints: how much of a film or a picture was really drawn.
namespace boxreel
{

/// A few lines for people, without a newline at the end. Of all the frames that a renderer was
/// given.
std::string DescribeDrawing(const RenderTotals& totals);

} // namespace boxreel
