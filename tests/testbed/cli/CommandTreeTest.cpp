// SPDX-License-Identifier: MIT
// The program's description of itself is complete and correct.
#include "../../base/Errors.h"

#include <base/Quoting.h>
#include <cli/CommandLine.h>
#include <cli/CommandTree.h>
#include <cli/Help.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <regex>
#include <sstream>

namespace boxreel
{
namespace
{

using testing::HasSubstr;

/// The words behind "boxreel": of a command, its path.
std::vector<std::string> Words(const std::string& line)
{
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;)
    {
        all.push_back(word);
    }
    all.erase(all.begin());
    return all;
}

std::string PrintedHelp(const CommandText& command)
{
    std::vector<std::string> words = Words(command.path);
    words.emplace_back("--help");
    return std::get<TextRequest>(*ParseCommandLine(words)).text;
}

/// Splits a shell line of an example: words, some in double quotes, before any pipe, comment or
/// redirection.
std::vector<std::string> ShellWords(const std::string& line)
{
    const std::string command = line.substr(
        0, std::min({line.find(" | "), line.find(" > "), line.find(" # "), line.size()}));
    std::vector<std::string> words;
    const std::regex word("\"([^\"]*)\"|([^ ]+)");
    for (std::sregex_iterator at(command.begin(), command.end(), word), end; at != end; ++at)
    {
        words.push_back((*at)[1].matched ? (*at)[1].str() : (*at)[2].str());
    }
    return words;
}

TEST(CommandTree, ContainsEveryCommandAndOptionOfHelp)
{
    const CommandText program = DescribeProgram();
    EXPECT_GE(AllCommands(program).size(), 16u);
    const std::regex optionLine("(^|\n)  (?:-[a-z],)?(--[a-z-]+)( [A-Z][^ \n]*)?");
    for (const CommandText* command : AllCommands(program))
    {
        const std::string help = PrintedHelp(*command);
        const std::string head = help.substr(0, help.find("\n  boxreel ")); // the examples
        std::vector<std::pair<std::string, bool>> shown;
        for (std::sregex_iterator at(head.begin(), head.end(), optionLine), end; at != end; ++at)
        {
            shown.emplace_back((*at)[2], (*at)[3].matched);
        }
        std::vector<std::pair<std::string, bool>> described;
        for (const OptionText& option : command->options)
        {
            described.emplace_back(option.names.back(), !option.unit.empty());
        }
        EXPECT_THAT(described, testing::UnorderedElementsAreArray(shown)) << command->path;
        for (const CommandText& next : command->commands)
        {
            EXPECT_THAT(help, HasSubstr("\n  " + Words(next.path).back() + " ")) << next.path;
        }
    }
}

TEST(CommandTree, ParsesExamplesOfEveryCommand)
{
    const CommandText program = DescribeProgram();
    for (const CommandText* command : AllCommands(program))
    {
        bool hasOwn = false;
        for (const std::string& example : command->examples)
        {
            hasOwn = hasOwn || example.find(command->path) != std::string::npos;
            std::vector<std::string> words = ShellWords(example);
            if (words.front() == "boxreel")
            {
                words.erase(words.begin());
                const Result<Request> request = ParseCommandLine(words);
                EXPECT_TRUE(request) << example << "\n" << request.GetError().Text();
            }
        }
        EXPECT_TRUE(hasOwn) << command->path;
    }
}

/// A command line that is right but for the words behind it.
std::vector<std::string> LineFor(const CommandText& command)
{
    std::vector<std::string> line = Words(command.path);
    for (const WordText& word : command.words)
    {
        line.push_back(word.completion.kind == Completion::Kind::Words
                           ? word.completion.words.front()
                           : "word");
    }
    return line;
}

TEST(CommandTree, OffersOnlyValidValues)
{
    int offered = 0;
    const CommandText program = DescribeProgram();
    for (const CommandText* command : AllCommands(program))
    {
        for (const OptionText& option : command->options)
        {
            const Completion::Kind kind = option.completion.kind;
            if (kind != Completion::Kind::Words && kind != Completion::Kind::List)
            {
                continue;
            }
            for (const std::string& word : option.completion.words)
            {
                std::vector<std::string> line = LineFor(*command);
                line.insert(line.end(), {option.names.back(), word});
                EXPECT_THAT(ParseCommandLine(line),
                            testing::Not(Refuses(AsTyped(option.names.back(), word))))
                    << command->path;
                ++offered;
            }
            std::vector<std::string> line = LineFor(*command);
            line.insert(line.end(), {option.names.back(), "xylophone"});
            EXPECT_THAT(ParseCommandLine(line), Refuses(AsTyped(option.names.back(), "xylophone")));
        }
    }
    EXPECT_GE(offered, 60);
}

TEST(CommandTree, OffersEveryValueListedInHelp)
{
    // "Choose draft, standard, high, lossless (standard)" and the like: words with commas between
    // them, then the default.
    const std::regex list("([a-z0-9-]+)(, [a-z0-9-]+)+\\s\\(");
    int lists = 0;
    const CommandText program = DescribeProgram();
    for (const CommandText* command : AllCommands(program))
    {
        for (const OptionText& option : command->options)
        {
            std::smatch match;
            if (!std::regex_search(option.help, match, list))
            {
                continue;
            }
            ++lists;
            const std::string all = match.str();
            EXPECT_EQ(std::count(all.begin(), all.end(), ',') + 1,
                      std::ptrdiff_t(option.completion.words.size()))
                << command->path << " " << option.names.back() << ": " << option.help;
        }
    }
    EXPECT_GE(lists, 14);
}

TEST(CommandTree, CompletesFilesByExtension)
{
    const CommandText program = DescribeProgram();
    for (const CommandText* command : AllCommands(program))
    {
        for (const OptionText& option : command->options)
        {
            const bool isFolder = option.unit == "DIR";
            const bool isFile = option.unit == "FILE";
            EXPECT_EQ(option.completion.kind == Completion::Kind::Folders, isFolder)
                << command->path << " " << option.names.back();
            EXPECT_EQ(option.completion.kind == Completion::Kind::Files, isFile)
                << command->path << " " << option.names.back();
            for (const std::string& end : option.completion.words)
            {
                EXPECT_EQ(end.starts_with("."), isFile) << option.names.back();
            }
        }
    }
}

TEST(CommandTree, ListsEveryOptionInManualPage)
{
    const CommandText program = DescribeProgram();
    const std::string page = ManualPage(program);
    const auto roff = [](const std::string& text) {
        return std::regex_replace(text, std::regex("-"), "\\-");
    };
    for (const CommandText* command : AllCommands(program))
    {
        const bool isAlone = command->path == program.path;
        EXPECT_THAT(page, HasSubstr((isAlone ? "boxreel \\- " : ".SS \\fB" + command->path)));
        for (const OptionText& option : command->options)
        {
            EXPECT_THAT(page, HasSubstr("\\fB" + roff(option.names.back()) + "\\fR"))
                << command->path;
        }
    }
    for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS",
                                "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES"})
    {
        EXPECT_THAT(page, HasSubstr(std::string("\n.SH ") + section + "\n"));
    }
    for (const ExitCode& code : ExitCodes())
    {
        EXPECT_THAT(page, HasSubstr(std::string(".TP\n\\fB") + code.code + "\\fR\n"));
    }
}

} // namespace
} // namespace boxreel
