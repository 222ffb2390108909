// SPDX-License-Identifier: MIT
#include "CommandLine.h"
#include "Declare.h"
#include "Help.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <options/Values.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace boxreel
{
namespace
{

constexpr const char* kSummary = "2D rigid bodies, drawn and recorded off-screen";

/// "boxreel golden verify"
std::string NameOf(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : NameOf(*parent) + " " + command.get_name();
}

CLI::App& CommandOf(CLI::App& program)
{
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    return chosen.empty() ? program : CommandOf(*chosen.front());
}

std::vector<std::string> CommandNames(CLI::App& parent)
{
    std::vector<std::string> names;
    for (const CLI::App* command : parent.get_subcommands({}))
    {
        names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> OptionNames(const CLI::App& command)
{
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
    {
        for (const std::string& name : option->get_lnames())
        {
            names.push_back("--" + name);
        }
    }
    return names;
}

/// "did you mean 'record'?", or where to look.
std::string Suggestion(const CLI::App& command, const std::string& word,
                       const std::vector<std::string>& candidates, const std::string& what)
{
    return DidYouMean(word, candidates, "`" + NameOf(command) + " --help` lists the " + what);
}

/// The word after a command that is none of its own: a mistyped subcommand or option, or one word
/// too many.
Error UnexpectedWord(CLI::App& command)
{
    const std::vector<std::string> words = command.remaining();
    const std::vector<std::string> commands = CommandNames(command);
    const auto isOption = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
    // Behind an unknown command stand its own options.
    const bool isCommand = !commands.empty() && !words.empty() && !isOption(words.front());
    const auto found = std::find_if(words.begin(), words.end(), isOption);
    if (found != words.end() && !isCommand)
    {
        const std::string option = found->substr(0, found->find('='));
        return {ErrorKind::Unusable, option, "unknown option",
                Suggestion(command, option, OptionNames(command), "options")};
    }
    const std::string word = words.empty() ? "" : words.front();
    if (commands.empty())
    {
        return {ErrorKind::Unusable, "'" + word + "'", "too many arguments",
                "`" + NameOf(command) + " --help` shows the usage"};
    }
    return {ErrorKind::Unusable, "'" + word + "'", "unknown command",
            word == "bench" // of the script in a checkout
                ? "in a checkout `./boxreel bench` runs the benchmarks"
                : Suggestion(command, word, commands, "commands")};
}

Error MissingCommand(CLI::App& command)
{
    if (!command.remaining().empty())
    {
        return UnexpectedWord(command);
    }
    return {ErrorKind::Unusable, command.get_name(), "requires a command",
            "use " + JoinedBy(", ", CommandNames(command))};
}

/// The option with a missing, a needless or a repeated value. The parser's exception does not hold
/// it, so it is looked up in what was typed and read.
Error WrongCount(const CLI::App& command, const std::vector<std::string>& arguments)
{
    for (const CLI::Option* option : command.get_options())
    {
        if (option->get_expected_max() == 1 && option->results().size() > 1)
        {
            return {ErrorKind::Unusable, option->get_name(), "must be given only once"};
        }
    }
    std::string missing = arguments.back();
    for (auto word = arguments.rbegin(); word != arguments.rend(); ++word)
    {
        const std::string name = word->substr(0, word->find('='));
        const CLI::Option* option = command.get_option_no_throw(name);
        if (option == nullptr)
        {
            continue;
        }
        if (option->get_expected_max() == 0 && name != *word)
        {
            return {ErrorKind::Unusable, *word, "takes no value"};
        }
        if (option->get_expected_max() > 0 && option->count() == 0)
        {
            missing = name;
        }
    }
    return {ErrorKind::Unusable, missing, "requires a value"};
}

Error Explain(CLI::App& program, const CLI::ParseError& error,
              const std::vector<std::string>& arguments)
{
    CLI::App& command = CommandOf(program);
    if (const auto* refusal = dynamic_cast<const Refusal*>(&error))
    {
        return refusal->error;
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    {
        CLI::App* owner = &command; // words before a command belong to a parent
        while (owner->remaining().empty() && owner->get_parent() != nullptr)
        {
            owner = owner->get_parent();
        }
        return UnexpectedWord(*owner);
    }
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
    {
        return MissingCommand(command);
    }
    return WrongCount(command, arguments);
}

void DeclareProgram(CLI::App& program, Commands& commands, std::vector<CLI::App*>& declared)
{
    SetHelpFormat(program);
    program.set_version_flag("--version", "boxreel " BOXREEL_VERSION, "Print the version and exit");
    program.require_subcommand(1);
    program.footer(
        "Examples:\n"
        "  boxreel list\n"
        "  boxreel record pyramid -o pyramid.mp4\n"
        "  boxreel shot pyramid --at 3s -o pyramid.png\n\n"
        "`boxreel COMMAND --help` shows the options of a command.\n"
        "Exit codes: 0 success, 1 invalid input, 2 a check failed, 3 a library or device "
        "is missing,\n"
        "4 reading or writing failed, 75 stopped by a signal; --resume continues.");
    std::apply(
        [&](auto&... options) {
            const std::array all{Declare(program, options)...};
            declared.assign(all.begin(), all.end());
        },
        commands);
    for (CLI::App* command : program.get_subcommands({}))
    {
        command->group("Commands");
        for (CLI::App* action : command->get_subcommands({}))
        {
            action->group("Commands");
        }
    }
}

/// The command that was named, once its options are checked.
Result<Request> Chosen(Commands& commands, const std::vector<CLI::App*>& declared)
{
    std::optional<Request> chosen;
    Result<void> checked;
    std::size_t index = 0;
    const auto take = [&](auto& options) {
        if (declared[index++]->parsed()) // of nested commands the inner one is the later
        {
            checked = Check(options);
            chosen = std::move(options);
        }
    };
    std::apply([&](auto&... options) { (take(options), ...); }, commands);
    RETURN_IF_ERROR(checked);
    return *std::move(chosen);
}

} // namespace

CommandText DescribeProgram()
{
    CLI::App program(kSummary, "boxreel");
    Commands commands;
    std::vector<CLI::App*> declared;
    DeclareProgram(program, commands, declared);
    return DescribeCommands(program);
}

Result<Request> ParseCommandLine(const std::vector<std::string>& arguments)
{
    CLI::App program(kSummary, "boxreel");
    Commands commands;
    std::vector<CLI::App*> declared;
    std::get<RecordOptions>(commands).arguments.assign(arguments.begin(), arguments.end());
    DeclareProgram(program, commands, declared);
    std::vector<std::string> words = arguments;
    if (words.empty())
    {
        return Request(TextRequest{HelpOf(program)});
    }
    if (words.front() == "help")
    {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    std::reverse(words.begin(), words.end()); // as this overload of parse expects them
    try
    {
        program.parse(words);
    }
    catch (const CLI::CallForHelp&)
    {
        CLI::App& command = CommandOf(program);
        return command.remaining().empty() ? Request(TextRequest{HelpOf(program)})
                                           : Result<Request>(UnexpectedWord(command));
    }
    catch (const CLI::CallForVersion&)
    {
        return Request(TextRequest{"boxreel " BOXREEL_VERSION "\n"});
    }
    catch (const CLI::ParseError& error)
    {
        return Explain(program, error, arguments);
    }
    return Chosen(commands, declared);
}

} // namespace boxreel
