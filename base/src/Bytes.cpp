// SPDX-License-Identifier: MIT
#include <base/Bytes.h>

#include <cstdio>

namespace boxreel
{

void PutNumber(std::vector<std::uint8_t>& bytes, std::uint64_t number)
{
    for (int shift = 0; shift < 64; shift += 8)
    {
        bytes.push_back(static_cast<std::uint8_t>(number >> shift));
    }
}

std::uint64_t TakeNumber(std::span<const std::uint8_t>& bytes)
{
    if (bytes.size() < 8)
    {
        bytes = {};
        return 0;
    }
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < 8; ++i)
    {
        number |= std::uint64_t(bytes[i]) << (8 * i);
    }
    bytes = bytes.subspan(8);
    return number;
}

std::uint64_t ChecksumOf(std::span<const std::uint8_t> bytes, std::uint64_t before)
{
    std::uint64_t sum = before;
    for (const std::uint8_t byte : bytes)
    {
        sum = (sum ^ byte) * 0x100000001b3u;
    }
    return sum;
}

std::uint64_t ChecksumOf(const std::string& text)
{
    return ChecksumOf({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string HexText(std::uint64_t number)
{
    char text[20];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

} // namespace boxreel
