// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Backend.h>

#include <memory>
#include <mutex>
#include <string>

/// A GL 3.3 core context behind one interface. Each back end is one Context*.cpp; a window's
/// context is in WindowGlfw.cpp. They load their libraries at run time: GL is never linked.
/// A context is current in one thread at a time, and destroyed there. In a window, only finished
/// pictures are copied to the default framebuffer.
namespace boxreel
{

class Context
{
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    /// Makes this context current in this thread; cheap when it already is.
    Result<void> MakeCurrent();

    /// Returns the address of a GL function; null if the library does not have it.
    virtual void* ProcAddress(const char* name) const = 0;

    /// Returns the display name of the back end, e.g. "OSMesa".
    virtual const char* BackEnd() const = 0;

    /// Shows the default framebuffer, if there is one.
    virtual void SwapBuffers() {}

protected:
    /// True if the library reports this context as current; another back end's library may have
    /// changed that.
    virtual bool IsCurrent() const = 0;
    virtual Result<void> Bind() = 0;
    virtual void Unbind() = 0;

    /// Releases the context in the library. Every destructor calls it first.
    void Leave();
};

/// Held while contexts are created, used and destroyed: by one thread of the process at a time. The
/// contexts of a library share a screen. llvmpipe inspects the scenes of all contexts (to see if a
/// buffer is in use) while other threads change them, which can crash. Its raster threads keep
/// running.
[[nodiscard]] std::unique_lock<std::recursive_mutex> LockGl();

/// Names of the libraries to load; tests use other names.
struct ContextLibraries
{
    std::string osMesa = "libOSMesa.so.8";
    std::string egl = "libEGL.so.1";
};

/// Creates the requested back end, or the first that works. If none does, returns an Error (Absent)
/// with one line per back end: its library, the problem, the remedy. An Error (Unusable) for an
/// environment variable that names no back end or stops Mesa.
Result<std::unique_ptr<Context>> CreateContext(Backend backend,
                                               const ContextLibraries& libraries = {});

/// Creates a context of Mesa's off-screen library.
Result<std::unique_ptr<Context>> CreateOSMesaContext(const std::string& library);

/// Creates an EGL context without a surface. With `onGpu` false, only software rasterizers are
/// accepted; with `onGpu` true, only others.
Result<std::unique_ptr<Context>> CreateEglContext(const std::string& library, bool onGpu);

} // namespace boxreel
