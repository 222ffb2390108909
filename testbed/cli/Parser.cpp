// SPDX-License-Identifier: MIT
#include "Parser.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

/// An error of a reader that passes through the parser.
struct Refusal : CLI::ValidationError
{
    explicit Refusal(boxreel::Error why) : CLI::ValidationError(""), error(std::move(why)) {}
    boxreel::Error error;
};

void Declare(CLI::App& parser, Option& option)
{
    const auto read = [&option](const std::vector<std::string>& texts) {
        option.wasGiven = true;
        if (Result<void> done = option.read(texts); !done)
        {
            throw Refusal(std::move(done).TakeError());
        }
    };
    const std::string names = JoinedBy(",", option.text.names);
    if (option.IsFlag())
    {
        parser.add_flag_callback(names, [read] { read({}); });
    }
    else if (option.text.repeats)
    {
        parser.add_option_function<std::vector<std::string>>(names, read)
            ->allow_extra_args(option.IsArgument());
    }
    else
    {
        parser.add_option_function<std::string>(names,
                                                [read](const std::string& text) { read({text}); });
    }
}

void Declare(CLI::App& parser, Command& command)
{
    for (Option& option : command.options)
    {
        if (option.read)
        {
            Declare(parser, option);
        }
    }
    for (Command& next : command.commands)
    {
        Declare(*parser.add_subcommand(next.Name()), next);
    }
    if (!command.commands.empty())
    {
        parser.require_subcommand(1);
    }
}

/// "boxreel golden verify"
std::string NameOf(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : NameOf(*parent) + " " + command.get_name();
}

CLI::App& CommandOf(CLI::App& parser)
{
    const std::vector<CLI::App*> chosen = parser.get_subcommands();
    return chosen.empty() ? parser : CommandOf(*chosen.front());
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

/// Reports an unknown word after a command: a mistyped subcommand or option, or an extra word.
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
        return {ErrorKind::Unusable, Quoted(word), "too many arguments",
                "`" + NameOf(command) + " --help` shows the usage"};
    }
    return {ErrorKind::Unusable, Quoted(word), "unknown command",
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

/// Returns the error of an option with a missing, an unexpected or a repeated value. The parser's
/// exception does not contain the option, so it is looked up in the arguments.
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

Error Explain(CLI::App& parser, const CLI::ParseError& error,
              const std::vector<std::string>& arguments)
{
    CLI::App& command = CommandOf(parser);
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

/// Returns the innermost command that was given.
Command& MarkGiven(const CLI::App& parser, Command& command)
{
    command.wasGiven = true;
    const std::vector<CLI::App*> given = parser.get_subcommands();
    return given.empty() ? command
                         : MarkGiven(*given.front(), Below(command, given.front()->get_name()));
}

Result<ParsedLine::Kind> Understand(CLI::App& parser, const std::vector<std::string>& arguments)
{
    try
    {
        // This overload of parse expects them in this order.
        parser.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    }
    catch (const CLI::CallForHelp&)
    {
        CLI::App& command = CommandOf(parser);
        return command.remaining().empty() ? Result<ParsedLine::Kind>(ParsedLine::Kind::Help)
                                           : Result<ParsedLine::Kind>(UnexpectedWord(command));
    }
    catch (const CLI::CallForVersion&)
    {
        return ParsedLine::Kind::Version;
    }
    catch (const CLI::ParseError& error)
    {
        return Explain(parser, error, arguments);
    }
    return ParsedLine::Kind::Run;
}

} // namespace

Result<ParsedLine> Parse(Command& program, const std::vector<std::string>& arguments)
{
    CLI::App parser("", program.path);
    parser.set_version_flag("--version", "");
    Declare(parser, program);
    ASSIGN_OR_RETURN(const ParsedLine::Kind kind, Understand(parser, arguments));
    const Command& command = MarkGiven(parser, program);
    if (kind == ParsedLine::Kind::Run && command.finish)
    {
        RETURN_IF_ERROR(command.finish());
    }
    return ParsedLine{kind, &command};
}

} // namespace boxreel
