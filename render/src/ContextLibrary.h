// SPDX-License-Identifier: MIT
#pragma once

#include <base/SharedLibrary.h>

#include <string>

/// Opening the shared library of a back end. For Context*.cpp and WindowGlfw.cpp only.
namespace boxreel
{

/// `packages` are Debian's, for the Error (Absent).
Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages);

} // namespace boxreel
