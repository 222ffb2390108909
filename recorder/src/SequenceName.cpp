// SPDX-License-Identifier: MIT
#include "SequenceName.h"

namespace boxreel
{

std::filesystem::path SequenceName::PathOf(std::int64_t number) const
{
    std::string text = std::to_string(number);
    if (text.size() < std::size_t(digits))
    {
        text.insert(0, std::size_t(digits) - text.size(), '0');
    }
    return folder / (before + text + after);
}

std::optional<std::int64_t> SequenceName::NumberIn(const std::string& name) const
{
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) ||
        !name.ends_with(after))
    {
        return std::nullopt;
    }
    const std::string text = name.substr(before.size(), name.size() - before.size() - after.size());
    if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    {
        return std::nullopt;
    }
    const std::int64_t number = std::stoll(text);
    return PathOf(number).filename() == name ? std::optional(number) : std::nullopt;
}

std::optional<SequenceName> ParseSequenceName(const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    const std::size_t last = name.find_last_of('#');
    if (last == std::string::npos)
    {
        return std::nullopt;
    }
    std::size_t first = last;
    while (first > 0 && name[first - 1] == '#')
    {
        --first;
    }
    return SequenceName{path.parent_path(), name.substr(0, first), name.substr(last + 1),
                        int(last - first + 1)};
}

} // namespace boxreel
