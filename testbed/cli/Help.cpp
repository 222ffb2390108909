// SPDX-License-Identifier: MIT
#include "Help.h"

#include <options/Values.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// Left of what an option or a command does; [characters].
constexpr std::size_t kNameWidth = 32;

/// Returns a name with its description, whose further lines are indented below the first.
std::string HelpRow(const std::string& name, const std::string& text)
{
    std::string row = "  " + name;
    if (row.size() >= kNameWidth)
    {
        row += "\n" + std::string(kNameWidth, ' ');
    }
    row.resize(std::max(row.size(), kNameWidth), ' ');
    for (const char c : text)
    {
        row += c;
        row += c == '\n' ? std::string(kNameWidth, ' ') : "";
    }
    return row + "\n";
}

std::string UsageOf(const CommandText& command)
{
    std::string usage = "Usage: " + command.path;
    for (const WordText& word : command.words)
    {
        usage += " " + UsageOf(word, word.name);
    }
    return usage + (command.commands.empty() ? " [OPTIONS]" : " COMMAND") + "\n";
}

std::string OptionRow(const OptionText& option)
{
    return HelpRow(JoinedBy(",", option.names) + (option.unit.empty() ? "" : " " + option.unit) +
                       (option.repeats ? " ..." : ""),
                   option.help);
}

/// The options, each below its heading. Headings stand in the order of their first options.
std::string OptionRows(const std::vector<OptionText>& options)
{
    std::vector<std::pair<std::string, std::string>> groups;
    for (const OptionText& option : options)
    {
        auto group = std::find_if(groups.begin(), groups.end(), [&option](const auto& known) {
            return known.first == option.group;
        });
        if (group == groups.end())
        {
            group = groups.emplace(groups.end(), option.group, "\n" + option.group + ":\n");
        }
        group->second += OptionRow(option);
    }
    std::string rows;
    for (const auto& [heading, text] : groups)
    {
        rows += text;
    }
    return rows;
}

} // namespace

std::string HelpOf(const CommandText& command)
{
    std::string help = command.summary + "\n" + UsageOf(command);
    help += command.words.empty() ? "" : "\nArguments:\n";
    for (const WordText& word : command.words)
    {
        help += HelpRow(word.name + (word.isList ? " ..." : ""), word.help);
    }
    help += OptionRows(command.options);
    help += command.commands.empty() ? "" : "\nCommands:\n";
    for (const CommandText& next : command.commands)
    {
        help += HelpRow(next.path.substr(next.path.rfind(' ') + 1), next.summary);
    }
    return help + "\n" + command.notes + "\n";
}

} // namespace boxreel
