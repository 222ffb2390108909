// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace boxreel::test
{

/// Returns the bytes of base64 up to its padding or the end of its line.
inline std::string FromBase64(std::string_view text)
{
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : text.substr(0, text.find_first_of("=\n")))
    {
        bits = bits << 6 | std::uint32_t(kLetters.find(letter));
        count += 6;
        if (count >= 8)
        {
            count -= 8;
            bytes += char(bits >> count);
        }
    }
    return bytes;
}

} // namespace boxreel::test
