// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The engine by the header name of the 2.4 generation. It is in a separate folder: on file systems
/// that ignore case, box2d/ and Box2D/ are one folder, and <box2d/box2d.h> would find Box2D.h. Only
/// users of boxreel::engine see it, so that Box2d24Draw.h of the toolkit still finds that library.

#include <Box2D/Box2D.h>
