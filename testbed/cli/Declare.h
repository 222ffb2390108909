// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"
#include "CommandTree.h"

#include <base/Nearest.h>
#include <options/Values.h>
#include <render/Backend.h>
#include <session/SceneSession.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Declares the options of commands as data. The parser (Parser.h) writes the command line to them.
/// The help, the completions and the manual page show them.
namespace boxreel
{

/// Reads the texts that were given to an option, or returns why they are invalid. A flag has none.
using OptionReader = std::function<Result<void>(const std::vector<std::string>& texts)>;

/// An option, or an argument that has no name before it, such as SCENE.
struct Option
{
    OptionText text;
    OptionReader read;       ///< null: the parser's own, such as --help
    bool isOptional = false; ///< of an argument: it may be left out
    bool wasGiven = false;   ///< set by the parser

    bool IsArgument() const { return !text.names.front().starts_with('-'); }
    bool IsFlag() const { return !IsArgument() && text.unit.empty(); }

    /// Sets the option's heading in the help.
    Option& Group(const std::string& heading);
    /// Sets what shells offer there.
    Option& Completes(const Completion& completion);
};

struct Command
{
    /// Has --help.
    Command(std::string itsPath, std::string itsSummary);

    std::string path;                     ///< "boxreel golden verify"
    std::string summary;                  ///< half a sentence
    std::vector<Note> notes;              ///< end of its help
    std::vector<std::string> examples;    ///< command lines, below the notes
    std::list<Option> options;            ///< and arguments, in the order of the help
    std::list<Command> commands;          ///< below it, one of which must be given
    std::function<Result<void>()> finish; ///< called when all options are read; may be empty
    bool wasGiven = false;                ///< set by the parser

    /// Returns "verify".
    std::string Name() const { return path.substr(path.rfind(' ') + 1); }
    /// True if this option was given; `name`: "--size".
    bool WasGiven(const std::string& name) const;
};

/// Returns what help, completions and the manual page show of it.
CommandText Describe(const Command& command);

Command& AddCommand(Command& parent, const std::string& name, const std::string& summary);
/// Returns the command of this name; only if it was added before.
Command& Below(Command& parent, const std::string& name);

/// One of a few words.
template <class Value>
struct OneOf
{
    std::vector<std::pair<std::string, Value>> choices;

    explicit OneOf(std::vector<std::pair<std::string, Value>> all) : choices(std::move(all)) {}

    std::vector<std::string> Words() const
    {
        std::vector<std::string> words;
        for (const auto& [name, value] : choices)
        {
            words.push_back(name);
        }
        return words;
    }

    Result<Value> operator()(const std::string& option, const std::string& text) const
    {
        for (const auto& [name, value] : choices)
        {
            if (name == text)
            {
                return value;
            }
        }
        return NotOneOf(option, text, Words());
    }
};

inline auto RatioBetween(double lowest, double highest)
{
    return [lowest, highest](const std::string& option, const std::string& text) {
        return ParseRatio(option, text, lowest, highest);
    };
}

inline auto WholeBetween(std::int64_t lowest, std::int64_t highest)
{
    return [lowest, highest](const std::string& option, const std::string& text) {
        return ParseWhole(option, text, lowest, highest);
    };
}

/// `problem`: "must be a share from 0 to 1, such as 0.5".
inline auto NumberBetween(double lowest, double highest, const char* problem)
{
    return [=](const std::string& option, const std::string& text) -> Result<double> {
        const Result<double> number = ParseNumber(option, text);
        return number && *number >= lowest && *number <= highest
                   ? number
                   : Result<double>(BadValue(option, text, problem));
    };
}

/// One of these words, which is itself the value.
OneOf<std::string> OneWordOf(const std::vector<std::string>& words);

/// `names`: "-o,--output", or that of a word. `unit`: of the value, "FILE"; empty: a flag or a
/// word.
Option& AddOption(Command& command, const std::string& names, const std::string& unit,
                  OptionReader read, const std::string& help);
Option& AddFlag(Command& command, const std::string& names, bool& flag, const std::string& help);
Option& AddFlag(Command& command, const std::string& names, const std::function<void()>& set,
                const std::string& help);
Option& AddText(Command& command, const std::string& names, const std::string& unit,
                const std::function<Result<void>(const std::string&)>& read,
                const std::string& help);
/// It may be given several times; `read` gets all texts at once.
Option& AddTexts(Command& command, const std::string& names, const std::string& unit,
                 const OptionReader& read, const std::string& help);
/// `start`, then the words with `separator` between them, in lines as long as those of a help.
std::string Filled(std::string start, const std::vector<std::string>& words,
                   const std::string& separator);

/// The command `boxreel SUBJECT` lacks an argument.
Error Missing(const std::string& subject, const std::string& argument, const std::string& example);
/// `option` cannot be used together with `other`.
Error Conflict(const std::string& option, const std::string& other);
/// `option` has a meaning only together with `other`.
Error Requires(const std::string& option, const std::string& other);

/// An option whose text `parse` turns into a value for `target`, or refuses.
template <class Target, class Parse>
Option& AddValue(Command& command, const std::string& names, const std::string& unit,
                 Target& target, Parse parse, const std::string& help)
{
    const std::string name = names.substr(names.rfind(',') + 1);
    const auto read = [&target, parse, name](const std::string& text) -> Result<void> {
        auto value = parse(name, text);
        if (!value)
        {
            return std::move(value).TakeError();
        }
        target = static_cast<Target>(*std::move(value));
        return {};
    };
    Option& option = AddText(command, names, unit, read, help);
    if constexpr (requires { parse.Words(); })
    {
        option.Completes({Completion::Kind::Words, parse.Words()});
    }
    return option;
}

/// An option that may be given several times; `parse` turns each text into one more of `values`.
template <class Value, class Parse>
Option& AddValues(Command& command, const std::string& name, const std::string& unit,
                  std::vector<Value>& values, Parse parse, const std::string& help)
{
    const auto read = [&values, parse,
                       name](const std::vector<std::string>& texts) -> Result<void> {
        for (const std::string& text : texts)
        {
            Result<Value> value = parse(name, text);
            if (!value)
            {
                return std::move(value).TakeError();
            }
            values.push_back(*std::move(value));
        }
        return {};
    };
    return AddTexts(command, name, unit, read, help);
}

/// An argument that must not be empty.
Option& AddName(Command& command, const std::string& argument, std::string& name,
                const std::string& help);
/// Any number of paths, none of them empty.
Option& AddPaths(Command& command, const std::string& argument,
                 std::vector<std::filesystem::path>& paths, const std::string& help);

/// Options that several commands share.
Option& AddScene(Command& command, std::string& scene);
/// `unit`: DIR for a folder. `ends`: of the files' names, for shells; none: any.
void AddPath(Command& command, const std::string& names, const std::string& unit,
             std::filesystem::path& path, const std::string& help,
             const std::vector<std::string>& ends = {});
void AddForce(Command& command, bool& force);
void AddStats(Command& command, bool& stats);
Option& AddBackend(Command& command, Backend& backend);

/// Options that decide what a picture of a scene looks like, shared by record and shot.
/// `bothThemes`: where to say that a light and a dark twin are wanted; null where there are none.
void AddLook(Command& command, SceneLook& look, bool* bothThemes);

/// Checks that the picture is large enough for its panel, and has only one. Sets `hud` where it is
/// implied.
Result<void> CheckHud(SceneLook& look);

} // namespace boxreel
