// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>

#include <dlfcn.h>

/// Opening the shared library of a back end, and finding its functions. For Context*.cpp only.
namespace boxreel
{

/// Its symbols stay its own, so that those of two GL libraries never meet in one process; and it is
/// never closed, because Mesa's worker threads and thread-local data outlive a context. `packages`
/// are Debian's, for the Error (Absent).
Result<void*> OpenContextLibrary(const std::string& library, const std::string& packages);

/// False, and null, when the library has no function of that name.
template <class Function>
bool FindFunction(void* library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

} // namespace boxreel
