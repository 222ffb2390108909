// SPDX-License-Identifier: MIT
#include "Declare.h"

#include <base/ErrorMacros.h>

#include <algorithm>

namespace boxreel
{
namespace
{

/// `option` is empty for an argument, which has no name on the command line.
Result<void> CheckNotEmpty(const std::string& option, const std::string& text,
                           const std::string& remedy)
{
    if (text.empty())
    {
        return Error{ErrorKind::Unusable, option.empty() ? "\"\"" : option, "is empty", remedy};
    }
    return {};
}

} // namespace

Option& Option::Group(const std::string& heading)
{
    text.group = heading;
    return *this;
}

Option& Option::Completes(const Completion& completion)
{
    text.completion = completion;
    return *this;
}

Command::Command(std::string itsPath, std::string itsSummary)
    : path(std::move(itsPath)), summary(std::move(itsSummary))
{
    AddOption(*this, "-h,--help", "", nullptr, "Print this help message and exit");
}

bool Command::WasGiven(const std::string& name) const
{
    return std::any_of(options.begin(), options.end(), [&name](const Option& option) {
        return option.wasGiven && option.text.names.back() == name;
    });
}

CommandText Describe(const Command& command)
{
    CommandText text;
    text.path = command.path;
    text.summary = command.summary;
    text.notes = command.notes;
    text.examples = command.examples;
    for (const Option& option : command.options)
    {
        if (option.IsArgument())
        {
            text.words.push_back({.name = option.text.names.front(),
                                  .help = option.text.help,
                                  .isList = option.text.repeats,
                                  .isOptional = option.isOptional,
                                  .completion = option.text.completion});
        }
        else
        {
            text.options.push_back(option.text);
        }
    }
    for (const Command& next : command.commands)
    {
        text.commands.push_back(Describe(next));
    }
    return text;
}

Command& AddCommand(Command& parent, const std::string& name, const std::string& summary)
{
    return parent.commands.emplace_back(parent.path + " " + name, summary);
}

Command& Below(Command& parent, const std::string& name)
{
    return *std::find_if(parent.commands.begin(), parent.commands.end(),
                         [&name](const Command& command) { return command.Name() == name; });
}

OneOf<std::string> OneWordOf(const std::vector<std::string>& words)
{
    std::vector<std::pair<std::string, std::string>> choices;
    for (const std::string& word : words)
    {
        choices.emplace_back(word, word);
    }
    return OneOf<std::string>(std::move(choices));
}

Option& AddOption(Command& command, const std::string& names, const std::string& unit,
                  OptionReader read, const std::string& help)
{
    Option& option = command.options.emplace_back();
    option.text.names = SplitAt(',', names);
    option.text.unit = unit;
    option.text.help = help;
    option.read = std::move(read);
    return option;
}

Option& AddFlag(Command& command, const std::string& names, bool& flag, const std::string& help)
{
    return AddFlag(
        command, names, [&flag] { flag = true; }, help);
}

Option& AddFlag(Command& command, const std::string& names, const std::function<void()>& set,
                const std::string& help)
{
    const auto read = [set](const std::vector<std::string>&) {
        set();
        return Result<void>();
    };
    return AddOption(command, names, "", read, help);
}

Option& AddText(Command& command, const std::string& names, const std::string& unit,
                const std::function<Result<void>(const std::string&)>& read,
                const std::string& help)
{
    const auto first = [read](const std::vector<std::string>& texts) {
        return read(texts.front());
    };
    return AddOption(command, names, unit, first, help);
}

Option& AddTexts(Command& command, const std::string& names, const std::string& unit,
                 const OptionReader& read, const std::string& help)
{
    Option& option = AddOption(command, names, unit, read, help);
    option.text.repeats = true;
    return option;
}

std::string Filled(std::string start, const std::vector<std::string>& words,
                   const std::string& separator)
{
    constexpr std::size_t kLineLength = 66;
    std::size_t lineStart = 0;
    for (std::size_t i = 0; i < words.size(); ++i)
    {
        const std::string word = words[i] + (i + 1 < words.size() ? separator : "");
        if (start.size() - lineStart + word.size() > kLineLength)
        {
            start.erase(start.find_last_not_of(' ') + 1);
            start += '\n';
            lineStart = start.size();
        }
        start += word;
    }
    return start;
}

Error Missing(const std::string& subject, const std::string& argument, const std::string& example)
{
    return {ErrorKind::Unusable, subject, "requires " + argument, "for example `" + example + "`"};
}

Error Conflict(const std::string& option, const std::string& other)
{
    return {ErrorKind::Unusable, option, "cannot be used with " + other, "remove one of them"};
}

Error Requires(const std::string& option, const std::string& other)
{
    return {ErrorKind::Unusable, option, "requires " + other};
}

Option& AddScene(Command& command, std::string& scene)
{
    return AddName(command, "SCENE", scene,
                   "Open a scene of `boxreel list`, or a R.U.B.E. .json file")
        .Completes({Completion::Kind::Scenes, {".json"}});
}

Option& AddName(Command& command, const std::string& argument, std::string& name,
                const std::string& help)
{
    const auto read = [&name](const std::string& text) {
        name = text;
        return CheckNotEmpty("", text, "give a name");
    };
    return AddText(command, argument, "", read, help);
}

Option& AddPaths(Command& command, const std::string& argument,
                 std::vector<std::filesystem::path>& paths, const std::string& help)
{
    const auto read = [&paths](const std::vector<std::string>& texts) -> Result<void> {
        for (const std::string& text : texts)
        {
            RETURN_IF_ERROR(CheckNotEmpty("", text, "give a path"));
        }
        paths.assign(texts.begin(), texts.end());
        return {};
    };
    return AddTexts(command, argument, "", read, help);
}

void AddPath(Command& command, const std::string& names, const std::string& unit,
             std::filesystem::path& path, const std::string& help,
             const std::vector<std::string>& ends)
{
    const std::string named = names.starts_with("-") ? names.substr(0, names.find(',')) : "";
    const auto read = [&path, named](const std::string& text) {
        path = text;
        return CheckNotEmpty(named, text, "give a path");
    };
    AddText(command, names, unit, read, help)
        .Completes(unit == "DIR" ? Completion{Completion::Kind::Folders, {}}
                                 : Completion{Completion::Kind::Files, ends});
}

void AddForce(Command& command, bool& force)
{
    AddFlag(command, "--force", force, "Overwrite an existing file");
}

void AddStats(Command& command, bool& stats)
{
    AddFlag(command, "--stats", stats, "Print rendering statistics and a timing breakdown");
}

Option& AddBackend(Command& command, Backend& backend)
{
    return AddValue(command, "--backend", "NAME", backend, ParseBackend,
                    "Draw with " + JoinedBy(", ", BackendNames()) +
                        "\n"
                        "(auto: $BOXREEL_BACKEND, or the first that works)")
        .Completes({Completion::Kind::Words, BackendNames()});
}

} // namespace boxreel
