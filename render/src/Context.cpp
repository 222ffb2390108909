// SPDX-License-Identifier: MIT
#include "Context.h"

#include "ContextLibrary.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>

#include <cstdlib>
#include <span>
#include <utility>

namespace boxreel
{
namespace
{

constexpr std::pair<const char*, Backend> kNames[] = {{"auto", Backend::Auto},
                                                      {"osmesa", Backend::OSMesa},
                                                      {"egl", Backend::Egl},
                                                      {"egl-gpu", Backend::EglGpu}};

constexpr const char* kVariable = "BOXREEL_BACKEND";

// OSMesa first: the script `boxreel` installs it, so its users all draw with the same library.
constexpr Backend kAutomatic[] = {Backend::OSMesa, Backend::Egl};

// Mesa's libraries share one record of the thread's current context, but EGL has another of its
// own. To keep both consistent, the last context is released before the next becomes current.
thread_local Context* t_current = nullptr;

std::string NameOf(Backend backend)
{
    for (const auto& [name, value] : kNames)
    {
        if (value == backend)
        {
            return name;
        }
    }
    return "unknown";
}

Result<Backend> FromVariable()
{
    const char* const text = std::getenv(kVariable);
    return text == nullptr || *text == '\0' ? Backend::Auto : ParseBackend(kVariable, text);
}

Result<std::unique_ptr<Context>> CreateOne(Backend backend, const ContextLibraries& libraries)
{
    switch (backend)
    {
    case Backend::OSMesa:
        return CreateOSMesaContext(libraries.osMesa);
    case Backend::Egl:
        return CreateEglContext(libraries.egl, false);
    case Backend::EglGpu:
        return CreateEglContext(libraries.egl, true);
    case Backend::Auto:
        break; // replaced by one of kAutomatic above
    }
    return Error{ErrorKind::Absent, NameOf(backend), "no such back end"};
}

} // namespace

std::vector<std::string> BackendNames()
{
    std::vector<std::string> names;
    for (const auto& [name, backend] : kNames)
    {
        names.emplace_back(name);
    }
    return names;
}

Result<Backend> ParseBackend(const std::string& option, const std::string& text)
{
    for (const auto& [name, backend] : kNames)
    {
        if (text == name)
        {
            return backend;
        }
    }
    return NotOneOf(option, text, BackendNames());
}

std::unique_lock<std::recursive_mutex> LockGl()
{
    static std::recursive_mutex mutex;
    return std::unique_lock(mutex);
}

Result<void> Context::MakeCurrent()
{
    if (t_current == this && IsCurrent())
    {
        return {};
    }
    if (t_current != nullptr)
    {
        std::exchange(t_current, nullptr)->Unbind();
    }
    Result<void> bound = Bind();
    if (bound)
    {
        t_current = this;
    }
    return bound;
}

void Context::Leave()
{
    if (t_current == this)
    {
        Unbind();
        t_current = nullptr;
    }
}

Result<std::unique_ptr<Context>> CreateContext(Backend backend, const ContextLibraries& libraries)
{
    if (backend == Backend::Auto)
    {
        ASSIGN_OR_RETURN(const Backend chosen, FromVariable());
        backend = chosen;
    }
    if (backend != Backend::EglGpu)
    {
        RETURN_IF_ERROR(CheckVectorWidth());
    }
    std::string failures;
    for (const Backend candidate :
         backend == Backend::Auto ? std::span<const Backend>(kAutomatic) : std::span(&backend, 1))
    {
        Result<std::unique_ptr<Context>> context = CreateOne(candidate, libraries);
        if (context)
        {
            return context;
        }
        failures += "\n  " + NameOf(candidate) + ": " + context.GetError().Text();
    }
    std::string names;
    for (const std::string& name : BackendNames())
    {
        names.append(names.empty() ? "" : ", ").append(name);
    }
    return Error{ErrorKind::Absent, "back end " + NameOf(backend), "cannot draw" + failures,
                 std::string("set ") + kVariable + " to one of " + names};
}

} // namespace boxreel
