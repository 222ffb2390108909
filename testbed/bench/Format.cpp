// SPDX-License-Identifier: MIT
#include "Format.h"

#include <cstdarg>
#include <cstdio>

namespace boxreel
{

std::string Format(const char* format, ...)
{
    char text[320];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return text;
}

} // namespace boxreel
