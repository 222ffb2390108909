// SPDX-License-Identifier: MIT
#include "ContextLibrary.h"

namespace boxreel
{

Result<void*> OpenContextLibrary(const std::string& library, const std::string& packages)
{
    void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr)
    {
        const char* const reason = dlerror();
        return Error{ErrorKind::Absent, library + " did not load (" +
                                            (reason ? reason : "no reason given") +
                                            "); install it with: apt install " + packages};
    }
    return handle;
}

} // namespace boxreel
