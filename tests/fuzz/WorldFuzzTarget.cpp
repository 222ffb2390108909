// SPDX-License-Identifier: MIT
#include "WorldCalls.h"

#include <cstdio>
#include <cstdlib>

/// What libFuzzer calls with every input it makes up: the input decides what is called, and the
/// world's books and numbers are looked at after each call.
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
