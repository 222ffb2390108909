// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The engine by the name that programs of the 2.4 generation include. It stands in a folder of its
/// own: where file names have no case, box2d/ and Box2D/ are one folder, and <box2d/box2d.h> finds
/// Box2D.h there. Only users of boxreel::engine see it, so that Box2d24Draw.h of the toolkit still
/// finds the library of that name.

#include <Box2D/Box2D.h>
