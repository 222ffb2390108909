// SPDX-License-Identifier: MIT
#include "CommandLine.h"
#include "Declare.h"
#include "Help.h"
#include "Parser.h"

#include <base/ErrorMacros.h>

#include <array>
#include <optional>
#include <utility>

namespace boxreel
{
namespace
{

/// Returns the program and its commands, which write to `commands`. `declared`: those of
/// `commands`, in its order.
Command DeclareProgram(Commands& commands, std::vector<const Command*>& declared)
{
    Command program("boxreel", "2D rigid bodies, drawn and recorded off-screen");
    AddOption(program, "--version", "", nullptr, "Print the version and exit");
    std::vector<std::string> codes;
    for (const ExitCode& code : ExitCodes())
    {
        codes.push_back(std::string(code.code) + " " + code.brief);
    }
    program.notes = {{"`boxreel COMMAND --help` shows the options of a command.\n" +
                      Filled("Exit codes: ", codes, ", ") + "."}};
    program.examples = {"boxreel list", "boxreel record pyramid -o pyramid.mp4",
                        "boxreel shot pyramid --at 3s -o pyramid.png"};
    std::apply(
        [&](auto&... options) {
            const std::array all{&Declare(program, options)...};
            declared.assign(all.begin(), all.end());
        },
        commands);
    return program;
}

/// The command that was named, once its options are checked.
Result<Request> Chosen(Commands& commands, const std::vector<const Command*>& declared)
{
    std::optional<Request> chosen;
    Result<void> checked;
    std::size_t index = 0;
    const auto take = [&](auto& options) {
        if (declared[index++]->wasGiven) // of nested commands the inner one is the later
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
    Commands commands;
    std::vector<const Command*> declared;
    return Describe(DeclareProgram(commands, declared));
}

Result<Request> ParseCommandLine(const std::vector<std::string>& arguments)
{
    Commands commands;
    std::vector<const Command*> declared;
    std::get<RecordOptions>(commands).arguments.assign(arguments.begin(), arguments.end());
    Command program = DeclareProgram(commands, declared);
    std::vector<std::string> words = arguments;
    if (words.empty())
    {
        return Request(TextRequest{HelpOf(Describe(program))});
    }
    if (words.front() == "help")
    {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    ASSIGN_OR_RETURN(const ParsedLine line, Parse(program, words));
    switch (line.kind)
    {
    case ParsedLine::Kind::Help:
        return Request(TextRequest{HelpOf(Describe(*line.command))});
    case ParsedLine::Kind::Version:
        return Request(TextRequest{"boxreel " BOXREEL_VERSION "\n"});
    case ParsedLine::Kind::Run:
        break;
    }
    return Chosen(commands, declared);
}

} // namespace boxreel
