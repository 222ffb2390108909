// SPDX-License-Identifier: MIT
#include "ContextLibrary.h"

#include <cstdlib>

namespace boxreel
{
namespace
{

/// Mesa 22.3 keeps compiled shaders on disk, by the processor but not by the width of vectors that
/// this variable asks for. A vertex shader that an earlier process compiled for eight vertices at a
/// time then writes beyond memory that this one has taken for four, and malloc stops the process.
void KeepShadersOfOtherWidthsOut()
{
    if (std::getenv("LP_NATIVE_VECTOR_WIDTH") != nullptr)
    {
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    }
}

} // namespace

Result<SharedLibrary> OpenContextLibrary(const std::string& library, const std::string& packages)
{
    KeepShadersOfOtherWidthsOut();
    return SharedLibrary::Open(library, packages, SharedLibrary::Symbols::Now);
}

} // namespace boxreel
