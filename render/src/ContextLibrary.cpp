// SPDX-License-Identifier: MIT
#include "ContextLibrary.h"

#include <base/Quoting.h>

#include <cstdlib>
#include <string_view>

namespace boxreel
{
namespace
{

constexpr const char* kVectorWidth = "LP_NATIVE_VECTOR_WIDTH"; // [bits]

/// Mesa 22.3 keeps compiled shaders on disk. Their key has the processor, but not the width of
/// vectors in this variable. A vertex shader compiled earlier for eight vertices at a time then
/// writes beyond memory allocated for four, and malloc stops the process.
void KeepShadersOfOtherWidthsOut()
{
    if (std::getenv(kVectorWidth) != nullptr)
    {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    }
}

} // namespace

// Measured with Mesa 22.3.6 and LLVM 15: 32, 64, 96, 160, 384, 512 and 1024 end in LLVM with a
// segmentation fault, 0 with a division by zero, and 300 never returns.
Result<void> CheckVectorWidth()
{
    const char* const width = std::getenv(kVectorWidth);
    const std::string_view text = width == nullptr ? "" : width;
    if (text.empty() || text == "128" || text == "256")
    {
        return {};
    }
    return Error{ErrorKind::Unusable, std::string(kVectorWidth) + " " + Quoted(text),
                 "must be 128 or 256 for llvmpipe", "unset it"};
}

Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages)
{
    KeepShadersOfOtherWidthsOut();
    return SharedLibrary::Open(library, packages, SharedLibrary::Symbols::Now);
}

} // namespace boxreel
