// SPDX-License-Identifier: MIT
#pragma once

#include <base/SharedLibrary.h>

#include <string>

/// Loads the shared library of a back end. For Context*.cpp and WindowGlfw.cpp only.
namespace boxreel
{

/// `packages`: Debian package names, for the Error (Absent).
Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages);

} // namespace boxreel
