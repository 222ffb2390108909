// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <vector>

/// @file
/// The libraries that draw off-screen. All software back ends give the same bits. A GPU gives its
/// own, so it is used only when requested by name.
namespace boxreel
{

/// The library that draws.
enum class Backend
{
    Auto,   ///< the value of BOXREEL_BACKEND; otherwise the first of these that works
    OSMesa, ///< Mesa's off-screen library
    Egl,    ///< EGL without a surface, software rendering
    EglGpu, ///< EGL without a surface, on a GPU; never selected by Auto
};

/// The environment variable that names what Backend::Auto draws with.
inline constexpr const char* kBackendVariable = "BOXREEL_BACKEND";

/// Returns "auto", "osmesa", "egl", "egl-gpu".
std::vector<std::string> BackendNames();

/// Parses one of these names. `option` is the source of the text, e.g. "--backend", for the Error
/// (Unusable).
Result<Backend> ParseBackend(const std::string& option, const std::string& text);

} // namespace boxreel
