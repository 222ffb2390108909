// SPDX-License-Identifier: MIT
#include "WorldCalls.h"

#include <cstdio>
#include <cstdlib>

/// libFuzzer calls this with its inputs. The input selects the calls. The invariants and numbers of
/// the world are checked after each call.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    fuzz::WorldCalls calls({data, size});
    while (!calls.Done())
    {
        const char* name = calls.Call();
        const std::string why = calls.WhyBroken();
        if (!why.empty())
        {
            std::fprintf(stderr, "after %s: %s\n", name, why.c_str());
            std::abort();
        }
    }
    return 0;
}
