// SPDX-License-Identifier: MIT
#include "CommandLineOptions.h"

namespace boxreel
{
namespace
{

using Kind = Completion::Kind;

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

void DeclareCompletion(CLI::App& program, ParsedOptions& parsed)
{
    CLI::App* command =
        program.add_subcommand("completion", "Print what completes words in a shell");
    AddValue(*command, "SHELL", "", parsed.shell,
             OneOf<Shell>({{"bash", Shell::Bash}, {"zsh", Shell::Zsh}}), "bash or zsh");
    command->footer(
        "Commands, options, their values, scenes and files. Scenes are offered by names that need "
        "no\nquotes, such as newtons-cradle; `boxreel list --names` is asked for them each "
        "time.\n\n"
        "Examples:\n"
        "  source <(boxreel completion bash)   # in ~/.bashrc\n"
        "  source <(boxreel completion zsh)    # in ~/.zshrc, after compinit\n"
        "  boxreel completion bash > ~/.local/share/bash-completion/completions/boxreel");
}

void DeclareMan(CLI::App& program)
{
    CLI::App* command = program.add_subcommand("man", "Print the manual page");
    command->footer("Examples:\n"
                    "  man <(boxreel man)\n"
                    "  boxreel man > boxreel.1");
}

CommandText DescribeCommands(CLI::App& program)
{
    return Describe(program, program.get_name());
}

} // namespace boxreel
