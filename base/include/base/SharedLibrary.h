// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>

/// @file
/// Libraries that are loaded when they are needed.
namespace boxreel
{

/// A library that is loaded when it is needed, not when the program starts. Its symbols are its
/// own, so that those of two GL libraries never meet in one process. It is never unloaded:
/// libraries keep threads and thread-local data.
class SharedLibrary
{
public:
    enum class Symbols
    {
        Lazy, ///< each is looked up at its first call
        Now,  ///< a library that lacks one of its own does not open
    };

    /// An Error (Absent) names the library and Debian's packages.
    static Result<SharedLibrary> Open(const std::string& name, const std::string& packages,
                                      Symbols symbols = Symbols::Lazy);

    /// Whether the library has this function.
    template <class Function>
    bool Bind(const char* symbol, Function& function) const
    {
        function = reinterpret_cast<Function>(Find(symbol));
        return function != nullptr;
    }

    /// The Error (Absent) when it lacks something, such as "the function avcodec_open2".
    Error Lacks(const std::string& what) const;

private:
    SharedLibrary(void* handle, std::string name, std::string packages);
    void* Find(const char* symbol) const;

    void* m_handle;
    std::string m_name, m_packages;
};

} // namespace boxreel
