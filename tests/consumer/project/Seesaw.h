// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

/// A plank on a pivot, a small box on its left end and a large one that falls on its right.
struct Seesaw
{
    Seesaw();
    void Run(int steps); ///< of 1/60 s

    b2World world{b2Vec2(0.0f, -10.0f)};
};
