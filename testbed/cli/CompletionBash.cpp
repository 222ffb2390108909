// SPDX-License-Identifier: MIT
#include "CommandTree.h"
#include "CompletionScripts.h"

#include <base/Quoting.h>
#include <options/Values.h>

namespace boxreel
{
namespace
{

using Kind = Completion::Kind;

/// Returns the argument of _boxreel_matches: "files .png .svg".
std::string KindText(const Completion& completion)
{
    const std::string words = completion.words.empty() ? "" : " " + JoinedBy(" ", completion.words);
    switch (completion.kind)
    {
    case Kind::Nothing:
        return "text";
    case Kind::Words:
        return "words" + words;
    case Kind::List:
        return "list" + words;
    case Kind::Files:
        return "files" + words;
    case Kind::Folders:
        return "folders";
    case Kind::Scenes:
        return "scenes" + words;
    }
    return "text";
}

/// Below each command: its commands, and its options.
std::string CommandCases(const CommandText& program)
{
    std::string cases;
    for (const CommandText* command : AllCommands(program))
    {
        std::vector<std::string> commands;
        for (const CommandText& next : command->commands)
        {
            commands.push_back(LastWord(next.path));
        }
        std::vector<std::string> options;
        for (const OptionText& option : command->options)
        {
            options.insert(options.end(), option.names.begin(), option.names.end());
        }
        cases += "        " + ShellQuoted(command->path) +
                 ")\n            commands=" + ShellQuoted(JoinedBy(" ", commands)) +
                 "\n            options=" + ShellQuoted(JoinedBy(" ", options)) + " ;;\n";
    }
    return cases;
}

/// Returns the cases for the values of options and for the words of commands.
std::string KindCases(const CommandText& program)
{
    std::string cases;
    const auto add = [&cases](const std::string& pattern, const Completion& completion) {
        cases += "        " + pattern + ") kind=" + ShellQuoted(KindText(completion)) + " ;;\n";
    };
    for (const CommandText* command : AllCommands(program))
    {
        for (const OptionText& option : command->options)
        {
            std::vector<std::string> patterns;
            for (const std::string& name : option.names)
            {
                patterns.push_back(ShellQuoted(command->path + " " + name));
            }
            if (!option.unit.empty())
            {
                add(JoinedBy(" | ", patterns), option.completion);
            }
        }
        int number = 0;
        for (const WordText& word : command->words)
        {
            ++number;
            add(word.isList ? ShellQuoted(command->path + " ") + "[0-9]*"
                            : ShellQuoted(command->path + " " + std::to_string(number)),
                word.completion);
        }
    }
    return cases;
}

constexpr const char* kMatches = R"sh(
# Prints what begins with $current, one per line. $1: the kind of argument, followed by its words.
_boxreel_matches()
{
    local kind=$1 last=${current##*,} plain=${current#[\"\']} end
    plain=${plain//\\/}
    shift
    case $kind in
        words) compgen -W "$*" -- "$current" ;;
        list) compgen -P "${current%"$last"}" -W "$*" -- "$last" ;;
        scenes) compgen -W "$(_boxreel_all_scenes)" -- "$(printf '%s\n' "$current" | _boxreel_slugs)" ;;
        folders) compgen -d -- "$plain" ;;
        files)
            [[ $# -eq 0 ]] && compgen -f -- "$plain"
            [[ $# -eq 0 ]] || compgen -d -- "$plain"
            for end; do
                compgen -f -X "!*$end" -- "$plain"
            done ;;
    esac
}

# Offers what begins with $current. What readline took for another word, $1, stays as it is.
_boxreel_offer()
{
    local line
    while IFS= read -r line; do
        COMPREPLY+=("${line#"$1"}")
    done < <(_boxreel_matches $kind)
}
)sh";

constexpr const char* kMain = R"sh(
_boxreel()
{
    local IFS=$' \t\n' program=${COMP_WORDS[0]/#\~/$HOME} path=boxreel
    local commands options kind='' current before='' word number=0 i
    local -a typed=()
    COMPREPLY=()
    # Readline takes words apart at = and :, which are letters like others to the program.
    for ((i = 1; i <= COMP_CWORD; i++)); do
        word=${COMP_WORDS[i]}
        if [[ ${#typed[@]} -gt 0 && ($word == [=:]* || ${COMP_WORDS[i - 1]} == *[=:]) ]]; then
            before=${typed[${#typed[@]} - 1]}
            [[ $word == [=:]* ]] && before+=$word
            typed[${#typed[@]} - 1]+=$word
        else
            before=''
            typed+=("$word")
        fi
    done
    current=${typed[${#typed[@]} - 1]}
    word=${current//\\?/}
    if [[ $word == [!\"\']*[\"\']* ]]; then
        return # readline would put the match behind a quote within the word
    fi
    for ((i = 0; i < ${#typed[@]} - 1; i++)); do
        word=${typed[i]}
        if [[ -n $kind ]]; then
            kind='' # this was the value of the option before
        elif [[ $word == -* ]]; then
            _boxreel_kind "$path $word"
        else
            _boxreel_command "$path"
            case " $commands " in
                *" $word "*) path+=" $word" ;;
                *) number=$((number + 1)) ;;
            esac
        fi
    done
    _boxreel_command "$path"
    if [[ -n $kind ]]; then
        : # the value of the option before
    elif [[ $current == --*=* ]]; then
        _boxreel_kind "$path ${current%%=*}"
        before=${before#*=} current=${current#*=}
    elif [[ $current == -* ]]; then
        kind="words $options"
    elif [[ -n $commands && $number -eq 0 ]]; then
        kind="words $commands"
        # The script of a checkout that builds the program has a command of its own.
        if [[ $path == boxreel ]] && IFS= read -r -N 2 word 2>/dev/null <"$program" && [[ $word == '#!' ]]; then
            kind+=' test'
        fi
    else
        _boxreel_kind "$path $((number + 1))"
        kind=${kind:-words $options}
    fi
    case $kind in
        scenes*)
            [[ $current == */* ]] || _boxreel_offer "$before"
            if [[ ${#COMPREPLY[@]} -gt 0 || $kind == scenes ]]; then
                return
            fi
            kind=files${kind#scenes} ;;
    esac
    case $kind in
        files* | folders) compopt -o filenames 2>/dev/null ;;
    esac
    _boxreel_offer "$before"
}

complete -F _boxreel boxreel
)sh";

} // namespace

std::string BashCompletion(const CommandText& program)
{
    return "# What bash completes for boxreel " BOXREEL_VERSION
           "; made by `boxreel completion bash`.\n\n"
           "# $commands and $options of the command $1.\n"
           "_boxreel_command()\n{\n    commands='' options=''\n    case $1 in\n" +
           CommandCases(program) +
           "    esac\n}\n\n"
           "# $kind: what stands behind an option of a command, or at the place of a word; empty: "
           "nothing.\n"
           "_boxreel_kind()\n{\n    kind=''\n    case $1 in\n" +
           KindCases(program) + "    esac\n}\n\n" + kSceneFunctions + kMatches + kMain;
}

} // namespace boxreel
