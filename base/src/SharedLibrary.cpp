// SPDX-License-Identifier: MIT
#include <base/SharedLibrary.h>

#include <utility>

#include <dlfcn.h>

namespace boxreel
{
namespace
{

Error Absent(const std::string& name, const std::string& problem, const std::string& packages)
{
    return Error{ErrorKind::Absent, name, problem, "install it with: apt install " + packages};
}

} // namespace

SharedLibrary::SharedLibrary(void* handle, std::string name, std::string packages)
    : m_handle(handle), m_name(std::move(name)), m_packages(std::move(packages))
{}

Result<SharedLibrary> SharedLibrary::Open(const std::string& name, const std::string& packages,
                                          Symbols symbols)
{
    const int mode = symbols == Symbols::Now ? RTLD_NOW : RTLD_LAZY;
    void* const handle = dlopen(name.c_str(), mode | RTLD_LOCAL);
    if (handle == nullptr)
    {
        const char* const reason = dlerror();
        return Absent(name,
                      std::string("cannot be loaded (") +
                          (reason != nullptr ? reason : "no reason given") + ")",
                      packages);
    }
    return SharedLibrary(handle, name, packages);
}

Error SharedLibrary::MissingError(const std::string& what) const
{
    return Absent(m_name, "lacks " + what, m_packages);
}

void* SharedLibrary::Find(const char* symbol) const
{
    return dlsym(m_handle, symbol);
}

} // namespace boxreel
