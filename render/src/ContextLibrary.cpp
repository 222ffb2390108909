// SPDX-License-Identifier: MIT
#include "ContextLibrary.h"

#include <cstdlib>

namespace boxreel
{
namespace
{

/// Mesa 22.3 caches compiled shaders on disk by processor, but not by the vector width in this
/// variable. A cached vertex shader for eight vertices at a time would write beyond buffers
/// allocated for four. The process would abort in malloc.
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
