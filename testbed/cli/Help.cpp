// SPDX-License-Identifier: MIT
#include "Help.h"
#include "Declare.h"

#include <algorithm>
#include <memory>

namespace boxreel
{
namespace
{

using Kind = Completion::Kind;

/// Left of what an option or a command does; [characters].
constexpr std::size_t kNameWidth = 32;

/// A name and what it stands for, whose further lines stand below its first.
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

/// The parser's help with a usage line that says which words are needed. CLI11 2.5 and later would
/// break lines and titles otherwise, so lines are set here.
class HelpFormatter : public CLI::Formatter
{
public:
    std::string make_help(const CLI::App* command, std::string name,
                          CLI::AppFormatMode mode) const override
    {
        return command->get_description() + "\n" + make_usage(command, std::move(name)) +
               make_positionals(command) + make_groups(command, mode) +
               make_subcommands(command, mode) + "\n" + command->get_footer() + "\n";
    }

    std::string make_group(std::string group, bool isPositional,
                           std::vector<const CLI::Option*> options) const override
    {
        const bool isUsual = group == "OPTIONS" || group == "Options"; // by the version
        std::string text = isPositional ? "\nArguments:\n"
                           : isUsual    ? "\nOptions:\n"
                                        : "\n" + group + ":\n";
        for (const CLI::Option* option : options)
        {
            text += make_option(option, isPositional);
        }
        return text;
    }

    std::string make_option(const CLI::Option* option, bool isPositional) const override
    {
        return HelpRow(make_option_name(option, isPositional) + make_option_opts(option),
                       make_option_desc(option));
    }

    std::string make_subcommand(const CLI::App* command) const override
    {
        return HelpRow(command->get_display_name(true), command->get_description());
    }

    std::string make_usage(const CLI::App* command, std::string name) const override
    {
        std::string usage = "Usage: " + name;
        for (const CLI::Option* option : command->get_options())
        {
            if (option->get_positional())
            {
                const WordText word = WordOf(*option);
                usage += " " + UsageOf(word, word.name);
            }
        }
        const bool hasCommands = !command->get_subcommands({}).empty();
        return usage + (hasCommands ? " COMMAND" : " [OPTIONS]") + "\n";
    }
};

OptionText Describe(CLI::Option& option)
{
    OptionText text;
    for (const std::string& name : option.get_snames())
    {
        text.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames())
    {
        text.names.push_back("--" + name);
    }
    text.unit = option.get_expected_max() > 0 ? option.get_type_name() : "";
    text.help = option.get_description();
    text.group = option.get_group();
    text.repeats = option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll ||
                   option.get_expected_max() > 1;
    text.completion = CompletionOf(option);
    return text;
}

CommandText Describe(CLI::App& command, const std::string& path)
{
    CommandText text;
    text.path = path;
    text.summary = command.get_description();
    text.notes = command.get_footer();
    for (CLI::Option* option : command.get_options())
    {
        if (option->get_positional())
        {
            text.words.push_back(WordOf(*option));
            text.words.back().completion = CompletionOf(*option);
        }
        else
        {
            text.options.push_back(Describe(*option));
        }
    }
    for (CLI::App* next : command.get_subcommands({}))
    {
        text.commands.push_back(Describe(*next, path + " " + next->get_name()));
    }
    return text;
}

} // namespace

WordText WordOf(const CLI::Option& option)
{
    return {.name = option.get_name(true),
            .help = option.get_description(),
            .isList = option.get_expected_max() > 1,
            .isOptional = option.get_group() == kMayBeLeftOut,
            .completion = {}};
}

/// The parser keeps nothing of ours with an option but checks, which have names: this one lets
/// everything pass, and its name is the kind, a digit, and a line for each word.
CLI::Option* Completes(CLI::Option* option, const Completion& completion)
{
    std::string name(1, static_cast<char>('0' + static_cast<int>(completion.kind)));
    for (const std::string& word : completion.words)
    {
        name.append("\n").append(word);
    }
    const auto pass = [](std::string&) { return std::string(); };
    return option->check(CLI::Validator(pass, "", name));
}

Completion CompletionOf(CLI::Option& option)
{
    Completion completion;
    try
    {
        std::vector<std::string> lines = SplitAt('\n', option.get_validator(0)->get_name());
        completion.kind = static_cast<Kind>(lines.front().front() - '0');
        completion.words.assign(lines.begin() + 1, lines.end());
    }
    catch (const CLI::OptionNotFound&)
    {
        return {}; // nobody said what to offer
    }
    return completion;
}

CommandText DescribeCommands(CLI::App& program)
{
    return Describe(program, program.get_name());
}

void SetHelpFormat(CLI::App& program)
{
    program.formatter(std::make_shared<HelpFormatter>());
}

std::string HelpOf(const CLI::App& program)
{
    std::string help = program.help();
    for (std::size_t at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n"))
    {
        help.erase(at, 1);
    }
    return help;
}

} // namespace boxreel
