// SPDX-License-Identifier: MIT
#include <debugdraw/TextWidth.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace boxreel
{
namespace
{

// How far the pen goes on after a letter of DejaVu Sans, in 2048ths of its em square; a test
// compares them with the font itself.
constexpr std::array<int, 0x7F - 0x20> kAscii{
    651,  821,  942,  1716, 1303, 1946, 1597, 563,  799,  799,  1024, 1716, 651,  739,  651,  690,
    1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690,  690,  1716, 1716, 1716, 1087,
    2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604,  604,  1343, 1141, 1767, 1532, 1612,
    1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025, 1403, 1251, 1403, 799,  690,  799,  1716, 1024,
    1024, 1255, 1300, 1126, 1300, 1260, 721,  1300, 1298, 569,  569,  1186, 569,  1995, 1298, 1253,
    1300, 1300, 842,  1067, 803,  1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,  1303, 1716};
constexpr std::array<int, 0x100 - 0xA0> kLatin1{
    651,  821,  1303, 1303, 1303, 1303, 690,  1024, 1024, 2048, 965,  1253, 1716, 739,  2048, 1024,
    1024, 1716, 821,  821,  1024, 1303, 1303, 651,  1024, 821,  965,  1253, 1985, 1985, 1985, 1087,
    1401, 1401, 1401, 1401, 1401, 1401, 1995, 1430, 1294, 1294, 1294, 1294, 604,  604,  604,  604,
    1587, 1532, 1612, 1612, 1612, 1612, 1612, 1716, 1612, 1499, 1499, 1499, 1499, 1251, 1239, 1290,
    1255, 1255, 1255, 1255, 1255, 1255, 2011, 1126, 1260, 1260, 1260, 1260, 569,  569,  569,  569,
    1253, 1298, 1253, 1253, 1253, 1253, 1253, 1716, 1253, 1298, 1298, 1298, 1298, 1212, 1300, 1212};
constexpr int kOther = 1600; // about that of Greek and Cyrillic letters, which are not listed

// A line is 2384 of these high: 1901 above the baseline and 483 below.
constexpr double kPixels = kTextHeight / 2384.0;

int UnitsOf(char32_t letter)
{
    letter = letter == '\t' ? ' ' : letter;
    if (letter >= 0x20 && letter < 0x7F)
    {
        return kAscii[letter - 0x20];
    }
    if (letter >= 0xA0 && letter < 0x100)
    {
        return kLatin1[letter - 0xA0];
    }
    return letter < 0xA0 ? 0 : kOther;
}

/// The letter that begins at `at`, which goes on to the next one. What is no UTF-8 is the sign for
/// that.
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

/// As much of the beginning of `word` as fits, at least a letter.
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

/// One paragraph, whose words are parted by spaces.
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
                break; // a letter is wider than the room
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
    double drawn = 0.0;   // where letters stand on whole pixels
    double printed = 0.0; // where they need not
    for (std::size_t at = 0; at < line.size();)
    {
        const double width = UnitsOf(NextLetter(line, at)) * kPixels;
        printed += width;
        drawn += std::floor(width + 0.5);
    }
    return std::max(drawn, printed);
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
