// SPDX-License-Identifier: MIT
#include "CommandTree.h"
#include "CompletionScripts.h"

#include <base/Quoting.h>
#include <options/Values.h>

#include <algorithm>

namespace boxreel
{
namespace
{

using Kind = Completion::Kind;

/// ".png", ".svg": a pattern for both.
std::string Pattern(const std::vector<std::string>& ends)
{
    std::vector<std::string> letters;
    for (const std::string& end : ends)
    {
        letters.push_back(end.substr(1));
    }
    // For a single extension, zsh would read the brackets as a qualifier.
    return letters.empty()       ? "*"
           : letters.size() == 1 ? "*." + letters.front()
                                 : "*.(" + JoinedBy("|", letters) + ")";
}

/// Returns the action for _arguments.
std::string Action(const Completion& completion)
{
    switch (completion.kind)
    {
    case Kind::Nothing:
        return " ";
    case Kind::Words:
        return "(" + JoinedBy(" ", completion.words) + ")";
    case Kind::List:
        return "_sequence compadd - " + JoinedBy(" ", completion.words);
    case Kind::Files:
        return "_files -g \"" + Pattern(completion.words) + "\"";
    case Kind::Folders:
        return "_files -/";
    case Kind::Scenes:
        return completion.words.empty() ? " _boxreel_scenes"
                                        : " _boxreel_scenes \"" + Pattern(completion.words) + "\"";
    }
    return " ";
}

std::string Line(const std::string& specification)
{
    return " \\\n        " + ShellQuoted(specification);
}

std::string OptionLines(const OptionText& option)
{
    const bool isHelp = option.names.back() == "--help" || option.names.back() == "--version";
    const std::string before = isHelp           ? "(- *)"
                               : option.repeats ? "*"
                                                : "(" + JoinedBy(" ", option.names) + ")";
    std::string lines;
    for (const std::string& name : option.names)
    {
        const bool isLong = name.starts_with("--");
        const std::string value = option.unit.empty() ? "" : isLong ? "=" : "+";
        const std::string behind =
            option.unit.empty() ? ""
                                : ":" + ZshEscaped(option.unit) + ":" + Action(option.completion);
        lines += Line(before + name + value + "[" + ZshEscaped(option.help) + "]" + behind);
    }
    return lines;
}

std::string FunctionOf(const std::string& path)
{
    std::string name = "_" + path;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

/// The script of a checkout that builds the program has a command of its own.
constexpr const char* kScriptsOwn = R"sh(            local begin=
            read -r -k 2 -u 0 begin 2>/dev/null <$program
            [[ $begin == '#!' ]] && commands+=('test:Build everything and run the tests')
)sh";

/// Returns the function body of a command with subcommands.
std::string CommandBody(const CommandText& command, bool isProgram)
{
    std::string body = Line("1:command:->command") + Line("*::word:->word");
    body += "\n    case $state in\n        command)\n            commands=(\n";
    for (const CommandText& next : command.commands)
    {
        body += "                " +
                ShellQuoted(LastWord(next.path) + ":" + ZshEscaped(next.summary)) + "\n";
    }
    body += "            )\n";
    body += isProgram ? kScriptsOwn : "";
    body += "            _describe -t commands command commands ;;\n"
            "        word)\n            case $line[1] in\n";
    for (const CommandText& next : command.commands)
    {
        body += "                " + LastWord(next.path) + ") " + FunctionOf(next.path) + " ;;\n";
    }
    return body + "            esac ;;\n    esac\n";
}

std::string Function(const CommandText& command)
{
    const bool isProgram = command.path.find(' ') == std::string::npos;
    std::string text = FunctionOf(command.path) + "()\n{\n";
    text += isProgram ? "    local program=${${(Q)words[1]}/#\\~/$HOME}\n" : "";
    text += command.commands.empty()
                ? ""
                : "    local curcontext=$curcontext context state state_descr line\n"
                  "    local -a commands\n    local -A opt_args\n";
    text += "    _arguments -C -S :";
    for (const OptionText& option : command.options)
    {
        text += OptionLines(option);
    }
    for (const WordText& word : command.words)
    {
        text += Line((word.isList ? "*:" : ":") + ZshEscaped(word.name) + ":" +
                     Action(word.completion));
    }
    return text + (command.commands.empty() ? "\n" : CommandBody(command, isProgram)) + "}\n\n";
}

constexpr const char* kScenes = R"sh(
# Scenes, and files of the pattern $1 when there is one.
_boxreel_scenes()
{
    local -a scenes kinds
    scenes=(${(f)"$(_boxreel_all_scenes)"})
    kinds=("scenes:scene:compadd -M 'm:{[:upper:]}={[:lower:]}' -a scenes")
    (( $# )) && kinds+=("files:scene file:_files -g '$1'")
    _alternative $kinds
}

)sh";

} // namespace

std::string ZshCompletion(const CommandText& program)
{
    std::string text = "#compdef boxreel\n# What zsh completes for boxreel " BOXREEL_VERSION
                       "; made by `boxreel completion zsh`.\n\n";
    text.append(kSceneFunctions).append(kScenes);
    for (const CommandText* command : AllCommands(program))
    {
        text += Function(*command);
    }
    return text + "# As a file of $fpath it is called at once, else it is only read.\n"
                  "if [[ ${funcstack[1]-} == _boxreel ]]; then\n"
                  "    _boxreel \"$@\"\n"
                  "else\n"
                  "    compdef _boxreel boxreel\n"
                  "fi\n";
}

} // namespace boxreel
