// SPDX-License-Identifier: MIT
#pragma once

/// An EGL library that draws nothing, for tests of the selection of devices. It reports the devices
/// of the test, and counts the calls on each. FakeEgl.cpp is loaded as a library, like the real
/// one.
namespace boxreel
{

struct FakeDevice
{
    const char* abilities = ""; ///< its EGL_EXTENSIONS
    const char* renderer = "";  ///< GL_RENDERER of its contexts
    bool starts = true;         ///< eglInitialize succeeds
    bool makesContexts = true;  ///< eglCreateContext succeeds
    bool bindsWithoutSurface = true;
    int started = 0;  ///< calls of eglInitialize
    int contexts = 0; ///< that are alive
};

struct FakeEgl
{
    const char* extensions = ""; ///< the client's
    FakeDevice devices[3];
    int deviceCount = 0;
    FakeDevice surfaceless;              ///< what the surfaceless platform chooses
    const FakeDevice* current = nullptr; ///< whose context is
};

/// The library's one state, by the name that it exports.
using GetFakeEgl = FakeEgl* (*)();
inline constexpr const char* kGetFakeEgl = "GetFakeEgl";

} // namespace boxreel
