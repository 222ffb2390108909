// SPDX-License-Identifier: MIT
#include <base/Quoting.h>

#include <algorithm>
#include <cstdint>

namespace boxreel
{
namespace
{

std::string_view MarkupOf(const char& letter)
{
    switch (letter)
    {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    default:
        return {&letter, 1};
    }
}

} // namespace

std::string Quoted(std::string_view text)
{
    return std::string(1, '\'').append(text).append(1, '\'');
}

std::string AsTyped(std::string_view option, std::string_view value)
{
    const bool needsQuotes = value.empty() || value.find(' ') != std::string_view::npos;
    const std::string shown = needsQuotes ? Quoted(value) : std::string(value);
    return option.empty() ? shown : std::string(option) + " " + shown;
}

std::string ShellQuoted(std::string_view text)
{
    std::string quoted(1, '\'');
    for (const char& c : text)
    {
        quoted += c == '\'' ? std::string_view("'\\''") : std::string_view(&c, 1);
    }
    return quoted + '\'';
}

std::string ZshEscaped(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
    {
        const bool isSign = c == '[' || c == ']' || c == ':' || c == '\\';
        escaped += isSign ? "\\" : "";
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

std::string MarkupEscaped(std::string_view text)
{
    std::string escaped;
    escaped.reserve(text.size());
    for (const char& c : text)
    {
        escaped += MarkupOf(c);
    }
    return escaped;
}

std::string JsonForScript(std::string json)
{
    for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
    {
        json.replace(at, 1, "\\u003c");
    }
    return json;
}

std::string Base64(std::string_view bytes)
{
    constexpr std::string_view kLetters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3)
    {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            group = group << 8 | (k < count ? std::uint8_t(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k)
        {
            text += k <= count ? kLetters[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

std::string HexByte(unsigned char byte)
{
    constexpr std::string_view kDigits = "0123456789abcdef";
    return {kDigits[byte >> 4], kDigits[byte & 15]};
}

} // namespace boxreel
