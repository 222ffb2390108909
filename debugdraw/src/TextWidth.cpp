// SPDX-License-Identifier: MIT
#include <debugdraw/TextWidth.h>

#include "LetterWidths.h"

#include <algorithm>
#include <cmath>

namespace boxreel
{
namespace
{

// A line is 2384 of these high: 1901 above the baseline and 483 below.
constexpr double kPixels = kTextHeight / 2384.0;

/// Returns the width of the drawn glyph: 0 for control characters, that of '?' for missing ones.
int UnitsOf(char32_t letter)
{
    letter = letter == '\t' ? ' ' : letter;
    const int units = LetterWidth(letter);
    return units > 0 || letter < ' ' ? units : LetterWidth('?');
}

/// Returns the character at `at` and advances to the next. Invalid UTF-8 gives U+FFFD.
char32_t NextLetter(std::string_view text, std::size_t& at)
{
    const auto lead = static_cast<unsigned char>(text[at++]);
    if (lead < 0x80)
    {
        return lead;
    }
    char32_t letter = lead & (lead < 0xE0 ? 0x1Fu : lead < 0xF0 ? 0x0Fu : 0x07u);
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u)
    {
        letter = letter << 6 | (static_cast<unsigned char>(text[at++]) & 0x3Fu);
    }
    return letter < 0xA0 ? U'\uFFFD' : letter;
}

/// Returns the length of the prefix of `word` that fits, at least one character.
std::size_t Fitting(std::string_view word, double room)
{
    std::size_t end = 0;
    NextLetter(word, end);
    for (std::size_t next = end; next < word.size(); end = next)
    {
        NextLetter(word, next);
        if (TextWidth(word.substr(0, next)) > room)
        {
            break;
        }
    }
    return end;
}

/// Wraps one paragraph of words separated by spaces.
void Wrap(std::string_view text, double room, std::vector<std::string>& lines)
{
    std::string line;
    for (std::size_t start = 0; start <= text.size();)
    {
        const std::size_t end = std::min(text.find(' ', start), text.size());
        std::string_view word = text.substr(start, end - start);
        start = end + 1;
        const std::string longer =
            line.empty() ? std::string(word) : line + " " + std::string(word);
        if (TextWidth(longer) <= room)
        {
            line = longer;
            continue;
        }
        if (!line.empty())
        {
            lines.push_back(std::move(line));
        }
        while (TextWidth(word) > room)
        {
            const std::size_t part = Fitting(word, room);
            if (part == word.size())
            {
                break; // a character is wider than `room`
            }
            lines.emplace_back(word.substr(0, part));
            word.remove_prefix(part);
        }
        line = word;
    }
    lines.push_back(std::move(line));
}

} // namespace

double TextWidth(std::string_view line)
{
    double drawn = 0.0;   // with glyphs on whole pixels
    double printed = 0.0; // without rounding
    for (std::size_t at = 0; at < line.size();)
    {
        const double width = UnitsOf(NextLetter(line, at)) * kPixels;
        printed += width;
        drawn += std::floor(width + 0.5);
    }
    return std::max(drawn, printed);
}

bool HasLettersOf(std::string_view line)
{
    for (std::size_t at = 0; at < line.size();)
    {
        const char32_t letter = NextLetter(line, at);
        if (letter >= ' ' && LetterWidth(letter) == 0)
        {
            return false;
        }
    }
    return true;
}

std::vector<std::string> WrapText(std::string_view given, double room)
{
    std::string text(given);
    std::replace(text.begin(), text.end(), '\t', ' ');
    std::vector<std::string> lines;
    for (std::size_t start = 0; start <= text.size();)
    {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        Wrap(std::string_view(text).substr(start, end - start), room, lines);
        start = end + 1;
    }
    return lines;
}

} // namespace boxreel
