// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>

/// @file
/// A library that is opened when a film needs it, not before.
namespace boxreel
{

class SharedLibrary
{
public:
    /// An Error (Absent) names the library and Debian's package. Once open it stays open: libraries
    /// keep threads and tables of their own.
    static Result<SharedLibrary> Open(const std::string& name, const std::string& package);

    /// Whether the library has this function.
    template <class Function>
    bool Bind(const char* symbol, Function& function) const
    {
        function = reinterpret_cast<Function>(Find(symbol));
        return function != nullptr;
    }

private:
    explicit SharedLibrary(void* handle) : m_handle(handle) {}
    void* Find(const char* symbol) const;

    void* m_handle;
};

} // namespace boxreel
