// SPDX-License-Identifier: MIT
#pragma once

#include "Command.h"
#include "CommandTree.h"

#include <base/Nearest.h>
#include <options/Values.h>
#include <render/Backend.h>
#include <session/SceneSession.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// How commands declare their options to the parser.
namespace boxreel
{

/// Says what shells offer there.
CLI::Option* Completes(CLI::Option* option, const Completion& completion);
Completion CompletionOf(CLI::Option& option);
/// The group of words that need not be given. (An option of the parser's that expects none takes
/// none either, when it is a word by itself.)
inline constexpr const char* kMayBeLeftOut = "May be left out";
/// Of an option that is a word by itself, without what completes it.
WordText WordOf(const CLI::Option& option);

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

/// What the parser's own templates do, compiled once: a flag, an option that hands on its text, and
/// one that may have several.
CLI::Option* AddFlag(CLI::App& command, const std::string& names, bool& flag,
                     const std::string& help);
CLI::Option* AddText(CLI::App& command, const std::string& names,
                     const std::function<void(const std::string&)>& read, const std::string& help);
CLI::Option* AddTexts(CLI::App& command, const std::string& names,
                      const std::function<void(const std::vector<std::string>&)>& read,
                      const std::string& help);
/// `start`, then the words with `separator` between them, in lines as long as those of a help.
std::string Filled(std::string start, const std::vector<std::string>& words,
                   const std::string& separator);
/// An error of ours on its way through the parser.
struct Refusal : CLI::ValidationError
{
    explicit Refusal(boxreel::Error why) : CLI::ValidationError(""), error(std::move(why)) {}
    boxreel::Error error;
};

/// The value, or throws the error as a Refusal: for functions that the parser calls.
template <class Value>
Value OrRefuse(Result<Value> value)
{
    if (!value)
    {
        throw Refusal(std::move(value).TakeError());
    }
    return *std::move(value);
}

/// The command `boxreel SUBJECT` lacks an argument.
Error Missing(const std::string& subject, const std::string& argument, const std::string& example);
/// `option` cannot be used together with `other`.
Error Conflict(const std::string& option, const std::string& other);
/// `option` has a meaning only together with `other`.
Error Requires(const std::string& option, const std::string& other);

/// An option whose text `parse` turns into a value for `target`; a refusal becomes the parser's
/// error.
template <class Target, class Parse>
CLI::Option* AddValue(CLI::App& command, const std::string& names, const std::string& unit,
                      Target& target, Parse parse, const std::string& help)
{
    const std::string name = names.substr(names.rfind(',') + 1);
    const auto read = [&target, parse, name](const std::string& text) {
        target = static_cast<Target>(OrRefuse(parse(name, text)));
    };
    CLI::Option* option = AddText(command, names, read, help);
    option->type_name(unit);
    if constexpr (requires { parse.Words(); })
    {
        Completes(option, {Completion::Kind::Words, parse.Words()});
    }
    return option;
}

/// The text, or throws a Refusal that names the option, or "" for an argument without one.
std::string NotEmpty(const std::string& option, const std::string& text,
                     const std::string& remedy = "give a path");
/// The texts as paths, or throws a Refusal if one is empty.
std::vector<std::filesystem::path> PathsOf(const std::vector<std::string>& texts);
/// An argument that must not be empty.
CLI::Option* AddName(CLI::App& command, const std::string& argument, std::string& name,
                     const std::string& help);

/// Options that several commands share.
CLI::Option* AddScene(CLI::App& command, std::string& scene);
/// `unit`: DIR for a folder. `ends`: of the files' names, for shells; none: any.
void AddPath(CLI::App& command, const std::string& names, const std::string& unit,
             std::filesystem::path& path, const std::string& help,
             const std::vector<std::string>& ends = {});
void AddForce(CLI::App& command, bool& force);
void AddStats(CLI::App& command, bool& stats);
CLI::Option* AddBackend(CLI::App& command, Backend& backend);

/// Options that decide what a picture of a scene looks like, shared by record and shot.
/// `bothThemes`: where to say that a light and a dark twin are wanted; null where there are none.
void AddLook(CLI::App& command, SceneLook& look, bool* bothThemes);

/// Whether the picture is large enough for its panel, and has only one. Sets `hud` where it is
/// implied.
Result<void> CheckHud(SceneLook& look);

} // namespace boxreel
