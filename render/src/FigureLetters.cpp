// SPDX-License-Identifier: MIT
#include "FigureLetters.h"

#include <algorithm>
#include <array>

namespace boxreel
{
namespace
{

/// Returns the characters of valid UTF-8.
std::vector<std::string> LettersOf(std::string_view text)
{
    std::vector<std::string> letters;
    for (const char c : text)
    {
        if ((static_cast<unsigned char>(c) & 0xC0) != 0x80 || letters.empty())
        {
            letters.emplace_back();
        }
        letters.back() += c;
    }
    return letters;
}

/// Returns the code point of one character in valid UTF-8.
char32_t CodeOf(const std::string& letter)
{
    const unsigned lead = static_cast<unsigned char>(letter.front());
    char32_t code = letter.size() == 1 ? lead : lead & (0xFFu >> (letter.size() + 1));
    for (std::size_t i = 1; i < letter.size(); ++i)
    {
        code = code << 6 | (static_cast<unsigned char>(letter[i]) & 0x3Fu);
    }
    return code;
}

struct LetterRange
{
    char32_t first;
    char32_t last;
};

/// NameChar of XML 1.0, fifth edition, section 2.3, without the colon, which separates namespaces.
constexpr std::array<LetterRange, 18> kNameLetters{{{'-', '.'},
                                                    {'0', '9'},
                                                    {'A', 'Z'},
                                                    {'_', '_'},
                                                    {'a', 'z'},
                                                    {0xB7, 0xB7},
                                                    {0xC0, 0xD6},
                                                    {0xD8, 0xF6},
                                                    {0xF8, 0x37D},
                                                    {0x37F, 0x1FFF},
                                                    {0x200C, 0x200D},
                                                    {0x203F, 0x2040},
                                                    {0x2070, 0x218F},
                                                    {0x2C00, 0x2FEF},
                                                    {0x3001, 0xD7FF},
                                                    {0xF900, 0xFDCF},
                                                    {0xFDF0, 0xFFFC},
                                                    {0x10000, 0xEFFFF}}};

bool IsNameLetter(char32_t code)
{
    return std::any_of(kNameLetters.begin(), kNameLetters.end(), [code](const LetterRange& range) {
        return range.first <= code && code <= range.last;
    });
}

} // namespace

std::string Readable(std::string_view text)
{
    std::string readable;
    for (std::size_t i = 0; i < text.size();)
    {
        const auto byte = [&](std::size_t at) {
            return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
        };
        const unsigned lead = byte(i);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        unsigned code = length == 1 ? lead : lead & (0x7Fu >> length);
        bool valid = lead < 0x80 || (lead >= 0xC2 && lead < 0xF5);
        for (std::size_t k = 1; valid && k < length; ++k)
        {
            valid = (byte(i + k) & 0xC0u) == 0x80u;
            code = code << 6 | (byte(i + k) & 0x3Fu);
        }
        constexpr unsigned kShortest[] = {0, 0, 0x80, 0x800, 0x10000};
        valid = valid && code >= kShortest[length] && code <= 0x10FFFF &&
                (code < 0xD800 || code > 0xDFFF) && code != 0xFFFE && code != 0xFFFF;
        const bool control = code < 0x20 || (code >= 0x7F && code < 0xA0);
        if (valid && (code == '\t' || code == '\n'))
        {
            readable += ' ';
        }
        else if (valid && !control)
        {
            readable += text.substr(i, length);
        }
        else if (!valid)
        {
            readable += "\xEF\xBF\xBD";
        }
        i += valid ? length : 1;
    }
    return readable;
}

std::string AsIdPart(std::string_view text)
{
    std::string id;
    for (const std::string& letter : LettersOf(Readable(text)))
    {
        id += IsNameLetter(CodeOf(letter)) ? letter : "-";
    }
    return id;
}

std::vector<std::string> LettersWithout(const Figure& figure,
                                        const std::function<bool(char32_t)>& has)
{
    std::vector<std::string> missing;
    for (const FigurePanel& panel : figure.panels)
    {
        for (const std::string& text : panel.list.texts)
        {
            for (const std::string& letter : LettersOf(Readable(text)))
            {
                if (!has(CodeOf(letter)) &&
                    std::find(missing.begin(), missing.end(), letter) == missing.end())
                {
                    missing.push_back(letter);
                }
            }
        }
    }
    return missing;
}

} // namespace boxreel
