// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>
#include <vector>

/// @file
/// Which library draws off-screen. All software back ends give the same bits; a GPU's are its own,
/// so one is used only when it is asked for by name.
namespace boxreel
{

/// Who draws.
enum class Backend
{
    Auto,   ///< what the variable BOXREEL_BACKEND says; else the first that works, in this order
    OSMesa, ///< Mesa's off-screen library
    Egl,    ///< EGL without a surface, drawing in software
    EglGpu, ///< EGL without a surface, drawing on a GPU; never chosen by Auto itself
};

/// "auto", "osmesa", "egl", "egl-gpu".
std::vector<std::string> BackendNames();

/// One of these names. `option` is where the text comes from, e.g. "--backend",
/// for the sentence of the Error (Unusable).
Result<Backend> ParseBackend(const std::string& option, const std::string& text);

} // namespace boxreel
