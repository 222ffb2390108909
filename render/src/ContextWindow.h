// SPDX-License-Identifier: MIT
#pragma once

#include "Context.h"

#include <render/Window.h>

namespace boxreel
{

/// The GL context of a window, which must outlive it.
std::unique_ptr<Context> CreateWindowContext(Window& window);

} // namespace boxreel
