// SPDX-License-Identifier: MIT
#pragma once

#include "Context.h"

#include <render/Window.h>

namespace boxreel
{

/// Creates the GL context of a window; the window must outlive it.
std::unique_ptr<Context> CreateWindowContext(Window& window);

} // namespace boxreel
