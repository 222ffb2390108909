// SPDX-License-Identifier: MIT
#include <base/SharedLibrary.h>

#include <dlfcn.h>

namespace boxreel
{

Result<SharedLibrary> SharedLibrary::Open(const std::string& name, const std::string& package)
{
    void* handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (handle == nullptr)
    {
        const char* reason = dlerror();
        return Error{ErrorKind::Absent, "Films need " + name + ", which cannot be loaded (" +
                                            (reason != nullptr ? reason : "no reason given") +
                                            "); install Debian's " + package + "."};
    }
    return SharedLibrary(handle);
}

void* SharedLibrary::Find(const char* symbol) const
{
    return dlsym(m_handle, symbol);
}

} // namespace boxreel
