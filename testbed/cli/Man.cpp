// SPDX-License-Identifier: MIT
#include "Man.h"
#include "CommandTree.h"
#include "Declare.h"
#include "Help.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <base/Words.h>

#include <sstream>

namespace boxreel
{
namespace
{

/// A term and its description.
struct Entry
{
    const char* term;
    const char* meaning;
};

constexpr Entry kVariables[] = {
    {"BOXREEL_BACKEND",
     "The back end if --backend is not given or is auto: one of the names of --backend."},
    {"NO_COLOR", "Disables colours if set. They are used on terminals only."},
    {"TERM", "Disables colours if it is dumb or not set."},
    {"BOXREEL_GOLDEN_REFERENCES, BOXREEL_GOLDEN_OUTPUT, BOXREEL_GOLDEN_ACCEPT",
     "For golden tests: the folder of the references, the folder of the differences, and what this "
     "run accepts (missing, changed, all or this-renderer)."},
    {"XDG_CONFIG_HOME", "The folder for the settings of `boxreel ui` (~/.config)."},
    {"LP_NUM_THREADS", "The number of threads of Mesa's software renderer."},
    {"TMPDIR", "The folder for temporary files of `boxreel doctor` and `boxreel golden report`."},
    {"DISPLAY, WAYLAND_DISPLAY", "The display of `boxreel ui`; no other command needs one."},
};

constexpr Entry kFiles[] = {
    {"NAME.part.EXT",
     "A film that is being recorded or was stopped. It is playable, and --resume continues it."},
    {"NAME.EXT.json, NAME.part.EXT.json",
     "The manifest of a part, or of an unfinished film: the command, the state of the world, "
     "the frames."},
    {"golden/references", "The references, in the checkout around the current folder."},
    {"build/golden-output", "The differences from the references; golden-output in the current "
                            "folder if there is no checkout."},
};

/// Text that means itself: nothing in it is roff's, and dashes can be copied to a shell.
std::string Plain(const std::string& text)
{
    std::string plain;
    char previous = '\n';
    for (const char c : text)
    {
        plain += c == '.' && previous == '\n' ? "\\&." // no request
                 : c == '\\'                  ? "\\e"
                 : c == '-'                   ? "\\-"
                 : c == '\''                  ? "\\(aq"
                 : c == '`'                   ? "\\(ga"
                 : c == '^'                   ? "\\(ha"
                 : c == '~'                   ? "\\(ti"
                                              : std::string(1, c);
        previous = c;
    }
    return plain;
}

std::string Bold(const std::string& text)
{
    return "\\fB" + Plain(text) + "\\fR";
}

std::string Italic(const std::string& text)
{
    return "\\fI" + Plain(text) + "\\fR";
}

/// Returns one or more sentences. Text between backquotes becomes bold.
std::string Prose(const std::string& text)
{
    std::string prose;
    bool isCommand = false;
    std::istringstream pieces(text);
    for (std::string piece; std::getline(pieces, piece, '`'); isCommand = !isCommand)
    {
        prose += isCommand ? Bold(piece) : Plain(piece);
    }
    return prose;
}

/// Lines that stay as they are.
std::string Table(const std::string& lines)
{
    return ".RS 4\n.nf\n" + Plain(lines) + "\n.fi\n.RE\n";
}

std::string NoteText(const Note& note)
{
    return ".PP\n" + (note.kind == NoteKind::Table ? Table(note.text) : Prose(note.text) + "\n");
}

std::string Term(const std::string& term, const std::string& meaning)
{
    return ".TP\n" + term + "\n" + Prose(meaning) + "\n";
}

template <std::size_t Count>
std::string Section(const char* title, const Entry (&entries)[Count])
{
    std::string section = std::string(".SH ") + title + "\n";
    for (const Entry& entry : entries)
    {
        section += Term(Bold(entry.term), entry.meaning);
    }
    return section;
}

std::string Usage(const CommandText& command)
{
    std::string usage = Bold(command.path);
    for (const WordText& word : command.words)
    {
        usage += " " + UsageOf(word, Italic(word.name));
    }
    return usage +
           (command.commands.empty() ? " [" + Italic("OPTIONS") + "]" : " " + Italic("COMMAND"));
}

std::string OptionTerm(const OptionText& option)
{
    const std::string term = JoinedBy(", ", option.names, Bold);
    return option.unit.empty() ? term : term + " " + Italic(option.unit);
}

/// Words and options, and what the help says below them.
std::string Body(const CommandText& command)
{
    std::string body = Prose(command.summary) + ".\n";
    for (const WordText& word : command.words)
    {
        body += Term(Italic(word.name), word.help);
    }
    std::string group = command.options.empty() ? "" : command.options.front().group;
    for (const OptionText& option : command.options)
    {
        if (option.names.back() == "--help")
        {
            continue; // which all have
        }
        if (option.group != group)
        {
            group = option.group;
            body += ".PP\n" + Plain(group) + ":\n";
        }
        body += Term(OptionTerm(option), option.help);
    }
    for (const Note& note : command.notes)
    {
        body += NoteText(note);
    }
    return body + ".PP\nExamples:\n" + Table(JoinedBy("\n", command.examples));
}

std::string Synopsis(const std::vector<const CommandText*>& commands)
{
    std::string synopsis = ".SH SYNOPSIS\n.nf\n";
    for (const CommandText* command : commands)
    {
        synopsis += command->commands.empty() ? Usage(*command) + "\n" : "";
    }
    return synopsis + ".fi\n";
}

} // namespace

std::string ManualPage(const CommandText& program)
{
    std::vector<const CommandText*> commands = AllCommands(program);
    commands.erase(commands.begin()); // the program itself
    std::string page = ".\\\" Made by `boxreel man`.\n"
                       ".TH BOXREEL 1 \"\" \"boxreel " BOXREEL_VERSION "\" \"User Commands\"\n"
                       ".SH NAME\nboxreel \\- " +
                       Plain(program.summary) + "\n";
    page += Synopsis(commands);
    page += ".SH DESCRIPTION\n" +
            Prose("Simulates 2D rigid bodies and makes films and pictures of them without a "
                  "display. The same input gives the same bits.") +
            "\n";
    page += ".SH OPTIONS\n"
            "Of boxreel and of every command:\n";
    for (const OptionText& option : program.options)
    {
        page += Term(OptionTerm(option), option.help);
    }
    page += ".SH COMMANDS\n";
    for (const CommandText* command : commands)
    {
        page += ".SS " + Usage(*command) + "\n" + Body(*command);
    }
    page += ".SH EXIT STATUS\n";
    for (const ExitCode& code : ExitCodes())
    {
        page += Term(Bold(code.code), code.meaning);
    }
    page += Section("ENVIRONMENT", kVariables) + Section("FILES", kFiles);
    return page + ".SH EXAMPLES\n" + Table(JoinedBy("\n", program.examples));
}

Command& Declare(Command& program, ManOptions&)
{
    Command& command = AddCommand(program, "man", "Print the manual page");
    command.examples = {"man <(boxreel man)", "boxreel man > boxreel.1"};
    return command;
}

Result<int> Run(const ManOptions&)
{
    RETURN_IF_ERROR(WriteOutput(ManualPage(DescribeProgram())));
    return 0;
}

} // namespace boxreel
