// SPDX-License-Identifier: MIT
#include "RubeNames.h"

namespace boxreel
{

// Names come from the file: long ones would drown the message, control characters could garble the
// terminal. Bytes of other scripts pass; a name is cut between characters only.
std::string Quoted(const std::string& name)
{
    constexpr std::size_t kMost = 60;
    std::size_t length = name.size();
    if (length > kMost)
    {
        length = kMost;
        while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0) == 0x80)
        {
            --length;
        }
    }
    std::string result = "\"";
    result.append(name, 0, length);
    for (char& c : result)
    {
        const unsigned char byte = static_cast<unsigned char>(c);
        c = byte < 0x20 || byte == 0x7F ? '?' : c;
    }
    return result + (length < name.size() ? "...\"" : "\"");
}

std::string NameOfBody(const RubeScene& scene, std::size_t index)
{
    return "body " + std::to_string(index) + " " + Quoted(scene.bodies[index].name);
}

} // namespace boxreel
