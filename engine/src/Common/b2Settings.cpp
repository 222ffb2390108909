// SPDX-License-Identifier: MIT
#include <Box2D/Common/b2Settings.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace
{
b2AllocFunction g_alloc = std::malloc;
b2FreeFunction g_free = std::free;
b2LogFunction g_log = nullptr;
b2MisuseFunction g_misuse = nullptr;
} // namespace

void* b2Alloc(int32 size)
{
    // malloc(0) may return null, which would look like out of memory.
    void* memory = size >= 0 ? g_alloc(size > 0 ? static_cast<std::size_t>(size) : 1) : nullptr;
    if (memory == nullptr)
    {
        box2d::AssertionFailed("b2Alloc got no memory; free some or install a larger allocator "
                               "with b2SetAllocator.",
                               __FILE__, __LINE__);
    }
    return memory;
}

void b2Free(void* memory)
{
    g_free(memory);
}

void b2SetAllocator(b2AllocFunction alloc, b2FreeFunction free)
{
    const bool both = alloc != nullptr && free != nullptr;
    B2_REQUIRE(both || (alloc == nullptr && free == nullptr),
               "b2SetAllocator needs both functions, or two nulls for malloc and free.");
    g_alloc = both ? alloc : std::malloc;
    g_free = both ? free : std::free;
}

void b2Log(const char* format, ...)
{
    std::va_list arguments;
    va_start(arguments, format);
    if (g_log == nullptr)
    {
        std::vprintf(format, arguments);
    }
    else
    {
        char text[1024]; // longer than any line of Dump; longer text is truncated
        std::vsnprintf(text, sizeof text, format, arguments);
        g_log(text);
    }
    va_end(arguments);
}

void b2SetLog(b2LogFunction log)
{
    g_log = log;
}

void b2SetMisuse(b2MisuseFunction function)
{
    g_misuse = function;
}

bool box2d::ReportMisuse(const char* sentence, const char* file, int line)
{
    if (g_misuse == nullptr)
    {
        return false;
    }
    g_misuse(sentence, file, line);
    return true;
}

void box2d::AssertionFailed(const char* sentence, const char* file, int line)
{
    std::fprintf(stderr, "%s:%d: %s\n", file, line, sentence);
    std::abort();
}
