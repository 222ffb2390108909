// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Result.h>

#include <memory>
#include <string>

/// A GL 3.3 core context without a window, behind the one interface that the renderer sees. Each
/// back end is one Context*.cpp, which loads its library at run time: nothing of GL is linked. A
/// context is current in one thread at a time; the default framebuffer is never drawn to.
namespace boxreel
{

class Context
{
public:
    virtual ~Context() = default;

    /// Directs the GL calls of this thread to this context; cheap when it is current already.
    virtual Result<void> MakeCurrent() = 0;

    /// The address of a GL function, null when the library has none of that name.
    virtual void* ProcAddress(const char* name) const = 0;

    /// The back end's name for people, e.g. "OSMesa".
    virtual const char* BackEnd() const = 0;
};

/// Mesa's off-screen library. `library` is what the loader is asked for.
Result<std::unique_ptr<Context>> CreateOSMesaContext(const std::string& library = "libOSMesa.so.8");

} // namespace boxreel
