// SPDX-License-Identifier: MIT
#include "FieldRange.h"

#include "Format.h"

#include <algorithm>

namespace boxreel
{
namespace
{

constexpr int kDeepest = 16; ///< copies of what is nested deeper could run out of stack

/// The control characters of ASCII, and U+0080 to U+009F, which terminals obey too.
bool HasControls(const std::string& text)
{
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const auto byte = static_cast<unsigned char>(text[i]);
        const bool isSecondHalf =
            byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
        if (byte < 0x20 || byte == 0x7f || isSecondHalf)
        {
            return true;
        }
    }
    return false;
}

std::string WrongNumber(const std::string& name, double value, std::span<const FieldRange> ranges)
{
    const auto range = std::find_if(ranges.begin(), ranges.end(),
                                    [&](const FieldRange& known) { return name == known.name; });
    if (range == ranges.end() || value == 0.0 || (value >= range->least && value <= range->most))
    {
        return "";
    }
    return Format(" has '%s' of %g, which is no number from %g to %g", range->name, value,
                  range->least, range->most);
}

/// What is wrong, to be put behind the name of the file; empty: nothing.
std::string WrongIn(const Json& json, const std::string& name, std::span<const FieldRange> ranges,
                    int depth)
{
    if (HasControls(name) || (json.is_string() && HasControls(json.get<std::string>())))
    {
        return " has a name or text with control characters";
    }
    if (json.is_number())
    {
        return WrongNumber(name, json.get<double>(), ranges);
    }
    if (!json.is_structured())
    {
        return "";
    }
    if (depth == kDeepest)
    {
        return " is nested too deep";
    }
    for (const auto& [key, value] : json.items())
    {
        std::string wrong = WrongIn(value, key, ranges, depth + 1);
        if (!wrong.empty())
        {
            return wrong;
        }
    }
    return "";
}

} // namespace

Result<void> CheckFields(const Json& json, std::span<const FieldRange> ranges,
                         const std::string& name, const std::string& maker)
{
    const std::string wrong = WrongIn(json, "", ranges, 0);
    if (!wrong.empty())
    {
        return Error{ErrorKind::Unusable,
                     "'" + name + "'" + wrong + "; make it again with `" + maker + "`."};
    }
    return {};
}

} // namespace boxreel
