// SPDX-License-Identifier: MIT
#include "Context.h"

#include "ContextLibrary.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>

#include <cstdlib>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace boxreel
{
namespace
{

constexpr std::pair<const char*, Backend> kNames[] = {{"auto", Backend::Auto},
                                                      {"osmesa", Backend::OSMesa},
                                                      {"egl", Backend::Egl},
                                                      {"egl-gpu", Backend::EglGpu}};

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

/// A back end, and what named it, for errors.
struct Choice
{
    Backend backend = Backend::Auto;
    std::string culprit;
    std::string otherRemedy; ///< what helps beside installing it; empty if nothing
};

Result<Choice> Choose(Backend backend)
{
    const char* const text = std::getenv(kBackendVariable);
    if (backend == Backend::Auto && text != nullptr && *text != '\0')
    {
        ASSIGN_OR_RETURN(backend, ParseBackend(kBackendVariable, text));
        if (backend != Backend::Auto)
        {
            return Choice{backend, AsTyped(kBackendVariable, text), "unset the variable"};
        }
    }
    return Choice{backend, "back end " + NameOf(backend),
                  backend == Backend::Auto ? "" : "choose another back end"};
}

/// One sentence. With several candidates the problem names each, and any remedy is enough.
Error NothingDraws(const Choice& choice, const std::vector<std::pair<Backend, Error>>& failures)
{
    std::string problems;
    std::string remedies;
    const auto addRemedy = [&remedies](const std::string& remedy) {
        const bool isNeeded = !remedy.empty() && !remedies.empty();
        remedies.append(isNeeded ? ", or " : "").append(remedy);
    };
    for (const auto& [candidate, error] : failures)
    {
        problems.append(problems.empty() ? "" : ", ");
        problems.append(failures.size() > 1 ? NameOf(candidate) + ": " : "");
        problems.append(Error{error.kind, error.culprit, error.problem}.Text());
        addRemedy(error.remedy);
    }
    addRemedy(choice.otherRemedy);
    return Error{ErrorKind::Absent, choice.culprit, "does not work (" + problems + ")", remedies};
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
    return Error{ErrorKind::Absent, NameOf(backend), "unknown back end"};
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
    ASSIGN_OR_RETURN(const Choice choice, Choose(backend));
    if (choice.backend != Backend::EglGpu)
    {
        RETURN_IF_ERROR(CheckVectorWidth());
    }
    std::vector<std::pair<Backend, Error>> failures;
    for (const Backend candidate : choice.backend == Backend::Auto
                                       ? std::span<const Backend>(kAutomatic)
                                       : std::span(&choice.backend, 1))
    {
        Result<std::unique_ptr<Context>> context = CreateOne(candidate, libraries);
        if (context)
        {
            return context;
        }
        failures.emplace_back(candidate, context.GetError());
    }
    return NothingDraws(choice, failures);
}

} // namespace boxreel
