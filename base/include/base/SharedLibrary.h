// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <string>

/// @file
/// Libraries that are loaded on demand.
namespace boxreel
{

/// A library that is loaded on demand instead of at program start. Its symbols are private, so that
/// two GL libraries in one process do not conflict. It is never unloaded, because libraries keep
/// threads and thread-local data.
class SharedLibrary
{
public:
    /// The time at which symbols are resolved.
    enum class Symbols
    {
        Lazy, ///< resolve each symbol at its first call
        Now,  ///< resolve all symbols; an unresolved symbol is an Error
    };

    /// Loads a library. An Error (Absent) names the library and its Debian packages.
    static Result<SharedLibrary> Open(const std::string& name, const std::string& packages,
                                      Symbols symbols = Symbols::Lazy);

    /// True if the library has this function.
    template <class Function>
    bool Bind(const char* symbol, Function& function) const
    {
        function = reinterpret_cast<Function>(Find(symbol));
        return function != nullptr;
    }

    /// Returns the Error (Absent) for a missing part, such as "the function avcodec_open2".
    Error MissingError(const std::string& what) const;

private:
    SharedLibrary(void* handle, std::string name, std::string packages);
    void* Find(const char* symbol) const;

    void* m_handle;
    std::string m_name, m_packages;
};

} // namespace boxreel
