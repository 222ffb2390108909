// SPDX-License-Identifier: MIT
#include "RubeNames.h"

#include <utility>

namespace boxreel
{

namespace
{

unsigned char Byte(const std::string& text, std::size_t index)
{
    return index < text.size() ? static_cast<unsigned char>(text[index]) : 0;
}

/// Bytes of a control character that begins there, of ASCII or of the second set, which UTF-8
/// begins with C2; 0: none.
std::size_t ControlAt(const std::string& text, std::size_t index)
{
    const unsigned char byte = Byte(text, index);
    if (byte < 0x20 || byte == 0x7F)
    {
        return 1;
    }
    const unsigned char next = Byte(text, index + 1);
    return byte == 0xC2 && next >= 0x80 && next < 0xA0 ? 2 : 0;
}

} // namespace

std::string RubeNote::Text() const
{
    return part + ": " + reason;
}

void AddNote(RubeNotes& notes, std::size_t& count, RubeNote note)
{
    if (++count <= kMaxNotes)
    {
        notes.push_back(std::move(note));
        return;
    }
    notes.resize(kMaxNotes);
    notes.push_back({std::to_string(count - kMaxNotes) + " more parts", "not listed"});
}

// Limits length and removes control characters. Bytes of other scripts are kept; names are cut
// between characters.
std::string QuotedName(const std::string& name)
{
    constexpr std::size_t kMaxBytes = 60;
    std::size_t length = name.size();
    if (length > kMaxBytes)
    {
        length = kMaxBytes;
        while (length > 0 && (Byte(name, length) & 0xC0) == 0x80)
        {
            --length;
        }
    }
    std::string result = "\"";
    for (std::size_t i = 0; i < length;)
    {
        const std::size_t control = ControlAt(name, i);
        result += control > 0 ? '?' : name[i];
        i += control > 0 ? control : 1;
    }
    return result + (length < name.size() ? "...\"" : "\"");
}

std::string NameOfBody(const RubeScene& scene, std::size_t index)
{
    return WithName("body", index, scene.bodies[index].name);
}

std::string WithName(const char* what, std::size_t index, const std::string& name)
{
    const std::string text = what + (" " + std::to_string(index));
    return name.empty() ? text : text + " " + QuotedName(name);
}

} // namespace boxreel
