// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Backend.h>

#include <memory>
#include <mutex>
#include <string>

/// A GL 3.3 core context behind the one interface that the renderer sees. Each back end is one
/// Context*.cpp, a window's is in WindowGlfw.cpp; they load their libraries at run time: nothing of
/// GL is linked. A context is current in one thread at a time, and destroyed there; to the default
/// framebuffer only finished pictures are copied, in a window.
namespace boxreel
{

class Context
{
public:
    Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    virtual ~Context() = default;

    /// Directs the GL calls of this thread to this context; cheap when it is current already.
    Result<void> MakeCurrent();

    /// The address of a GL function, null when the library has none of that name.
    virtual void* ProcAddress(const char* name) const = 0;

    /// The back end's name for people, e.g. "OSMesa".
    virtual const char* BackEnd() const = 0;

    /// Shows what was drawn to the default framebuffer, where there is one.
    virtual void SwapBuffers() {}

protected:
    /// What its library says; another back end's library may have had the last word.
    virtual bool IsCurrent() const = 0;
    virtual Result<void> Bind() = 0;
    virtual void Unbind() = 0;

    /// What every destructor does first: a library keeps what is current.
    void Leave();
};

/// Held while contexts are made, called and ended: one thread of the process at a time. The
/// contexts of a library share a screen, and llvmpipe looks through what the scenes of all of them
/// refer to (whether a buffer is in use) while other threads change that, which crashes it now and
/// then. Its raster threads go on meanwhile.
[[nodiscard]] std::unique_lock<std::recursive_mutex> LockGl();

/// What the loader is asked for; other names in tests.
struct ContextLibraries
{
    std::string osMesa = "libOSMesa.so.8";
    std::string egl = "libEGL.so.1";
};

/// The back end that was asked for, or the first that works. When none does, an Error (Absent) with
/// a line for each that was tried: its library, what went wrong, the remedy. An Error (Unusable)
/// for an environment variable that names no back end or stops Mesa.
Result<std::unique_ptr<Context>> CreateContext(Backend backend,
                                               const ContextLibraries& libraries = {});

/// Mesa's off-screen library.
Result<std::unique_ptr<Context>> CreateOSMesaContext(const std::string& library);

/// EGL without a surface. With `onGpu` false what would draw on anything but a software rasteriser
/// is refused, with `onGpu` true the opposite.
Result<std::unique_ptr<Context>> CreateEglContext(const std::string& library, bool onGpu);

} // namespace boxreel
