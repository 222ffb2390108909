// SPDX-License-Identifier: MIT
#pragma once

#include <base/SharedLibrary.h>

#include <string>

/// Loads the shared library of a back end. For Context*.cpp and WindowGlfw.cpp only.
namespace boxreel
{

/// An Error (Unusable) when LP_NATIVE_VECTOR_WIDTH asks llvmpipe, Mesa's software renderer, for
/// vectors that it cannot compile: it would stop the process without a word.
Result<void> CheckVectorWidth();

/// `packages` are Debian's, for the Error (Absent).
Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages);

} // namespace boxreel
