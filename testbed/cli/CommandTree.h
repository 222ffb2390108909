// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

/// The commands and options of the program as plain data, made from what the commands declare.
/// Help, completions and the manual page are made of it.
namespace boxreel
{

/// The completions that a shell offers for a word or an option's value.
struct Completion
{
    enum class Kind
    {
        Nothing, ///< a number, a text
        Words,   ///< one of `words`
        List,    ///< several of `words`, with commas between them
        Files,   ///< that end in one of `words`, such as ".png"; any when there are none
        Folders,
        Scenes, ///< by name, or files that end in one of `words`
    };
    Kind kind = Kind::Nothing;
    std::vector<std::string> words;
};

/// A positional word: SCENE.
struct WordText
{
    std::string name;
    std::string help;
    bool isList = false;     ///< any number of them, the last of a command's words
    bool isOptional = false; ///< it may be left out
    Completion completion;
};

struct OptionText
{
    std::vector<std::string> names; ///< "-o", "--output": short ones first
    std::string unit;               ///< of its value, "FILE"; empty: it takes none
    std::string help;               ///< may have line breaks
    std::string group = "Options";  ///< the heading that it stands below
    bool repeats = false;           ///< may be given several times
    Completion completion;
};

/// How lines of a note are shown: filled, or as they are, indented.
enum class NoteKind
{
    Prose,
    Table,
};

/// A paragraph of a command's help.
struct Note
{
    std::string text; ///< lines of the help
    NoteKind kind = NoteKind::Prose;
};

struct CommandText
{
    std::string path;                  ///< "boxreel", "boxreel golden verify"
    std::string summary;               ///< half a sentence
    std::vector<Note> notes;           ///< end of its help
    std::vector<std::string> examples; ///< command lines
    std::vector<WordText> words;
    std::vector<OptionText> options;
    std::vector<CommandText> commands;
};

/// Returns the commands and options that ParseCommandLine (CommandLine.h) understands.
CommandText DescribeProgram();

/// Returns the word in the form of a usage line: SCENE, [SCENE] if optional, [SCENE...] for a list.
/// `name` may contain markup.
inline std::string UsageOf(const WordText& word, const std::string& name)
{
    const std::string shown = word.isList ? name + "..." : name;
    return word.isList || word.isOptional ? "[" + shown + "]" : shown;
}

/// The command and all below it, each before those below.
inline std::vector<const CommandText*> AllCommands(const CommandText& command)
{
    std::vector<const CommandText*> all{&command};
    for (const CommandText& next : command.commands)
    {
        const std::vector<const CommandText*> below = AllCommands(next);
        all.insert(all.end(), below.begin(), below.end());
    }
    return all;
}

/// Scripts for these shells. They offer scenes by the names that need no quotes, newtons-cradle,
/// and ask the program for them when they are wanted.
std::string BashCompletion(const CommandText& program);
std::string ZshCompletion(const CommandText& program);

/// The manual page, in roff for man(1).
std::string ManualPage(const CommandText& program);

} // namespace boxreel
