// SPDX-License-Identifier: MIT
#pragma once

class b2Draw;

namespace box2d
{

class World;

/// Draws the layers that the flags of `draw` name.
void Draw(const World& world, b2Draw& draw);

} // namespace box2d
