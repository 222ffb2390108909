// SPDX-License-Identifier: MIT
#pragma once

#include <base/SharedLibrary.h>

#include <string>

/// Loads the shared library of a back end. For Context*.cpp and WindowGlfw.cpp only.
namespace boxreel
{

/// An Error (Unusable) if LP_NATIVE_VECTOR_WIDTH requests vectors from llvmpipe, Mesa's software
/// renderer, that it cannot compile. Otherwise llvmpipe would stop the process without a message.
Result<void> CheckVectorWidth();

/// `packages` are Debian's, for the Error (Absent).
Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages);

} // namespace boxreel
