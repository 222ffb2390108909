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

constexpr ExitCode kExitCodes[] = {
    {"0", "success", "Done."},
    {"1", "invalid input",
     "Invalid input: unknown, missing, malformed or contradictory, or a file exists and --force "
     "was not given."},
    {"2", "a check failed",
     "A check failed: pictures or states differ, an expectation of a script is false, parts of a "
     "scene file were left out, or the engine's self-test has another result."},
    {"3", "a library or device is missing",
     "A library, an encoder, a program or a display is absent."},
    {"4", "reading or writing failed", "Reading or writing failed."},
    {"75", "stopped by a signal", "Stopped by a signal; --resume continues a film."},
};

/// The lines of a note, tables indented.
std::string NoteText(const Note& note)
{
    const std::string indent = note.kind == NoteKind::Table ? "  " : "";
    std::string lines = indent;
    for (const char c : note.text)
    {
        lines += c;
        lines += c == '\n' ? indent : "";
    }
    return lines + "\n";
}

} // namespace

std::span<const ExitCode> ExitCodes()
{
    return kExitCodes;
}

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
    help += command.notes.empty() ? "" : "\n";
    for (const Note& note : command.notes)
    {
        help += NoteText(note);
    }
    return help + "\nExamples:\n" + NoteText({JoinedBy("\n", command.examples), NoteKind::Table});
}

} // namespace boxreel
