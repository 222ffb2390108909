// SPDX-License-Identifier: MIT
#include <Box2D/Common/b2Draw.h>

b2Draw::~b2Draw() = default;
