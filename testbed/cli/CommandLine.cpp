// SPDX-License-Identifier: MIT
#include "CommandLine.h"
#include "CommandLineOptions.h"
#include "OutputPath.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>

#include <algorithm>
#include <utility>

namespace boxreel
{
namespace
{

constexpr const char* kWhat = "2D rigid bodies, drawn and recorded off-screen";

/// Left of what an option or a command does; [characters].
constexpr std::size_t kNameWidth = 32;

/// A name and what it stands for, whose further lines stand below its first.
std::string HelpRow(const std::string& name, const std::string& text)
{
    std::string row = "  " + name;
    if (row.size() >= kNameWidth)
    {
        row += "\n" + std::string(kNameWidth, ' ');
    }
    row.resize(std::max(row.size(), kNameWidth), ' ');
    for (const char c : text)
    {
        row += c;
        row += c == '\n' ? std::string(kNameWidth, ' ') : "";
    }
    return row + "\n";
}

/// The parser's help with a usage line that says which words are needed. CLI11 2.5 and later would
/// break lines and titles otherwise, so lines are set here.
class HelpFormatter : public CLI::Formatter
{
public:
    std::string make_help(const CLI::App* command, std::string name,
                          CLI::AppFormatMode mode) const override
    {
        return command->get_description() + "\n" + make_usage(command, std::move(name)) +
               make_positionals(command) + make_groups(command, mode) +
               make_subcommands(command, mode) + "\n" + command->get_footer() + "\n";
    }

    std::string make_group(std::string group, bool isPositional,
                           std::vector<const CLI::Option*> options) const override
    {
        const bool isUsual = group == "OPTIONS" || group == "Options"; // by the version
        std::string text = isPositional ? "\nArguments:\n"
                           : isUsual    ? "\nOptions:\n"
                                        : "\n" + group + ":\n";
        for (const CLI::Option* option : options)
        {
            text += make_option(option, isPositional);
        }
        return text;
    }

    std::string make_option(const CLI::Option* option, bool isPositional) const override
    {
        return HelpRow(make_option_name(option, isPositional) + make_option_opts(option),
                       make_option_desc(option));
    }

    std::string make_subcommand(const CLI::App* command) const override
    {
        return HelpRow(command->get_display_name(true), command->get_description());
    }

    std::string make_usage(const CLI::App* command, std::string name) const override
    {
        std::string usage = "Usage: " + name;
        for (const CLI::Option* option : command->get_options())
        {
            if (option->get_positional())
            {
                const WordText word = WordOf(*option);
                usage += " " + UsageOf(word, word.name);
            }
        }
        const bool hasCommands = !command->get_subcommands({}).empty();
        return usage + (hasCommands ? " COMMAND" : " [OPTIONS]") + "\n";
    }
};

/// Of the command that was named, the program's when none was.
std::string HelpOf(const CLI::App& program)
{
    std::string help = program.help();
    for (std::size_t at = help.find("\n\n\n"); at != std::string::npos; at = help.find("\n\n\n"))
    {
        help.erase(at, 1);
    }
    return help;
}

Error Unusable(const std::string& message)
{
    return Error{ErrorKind::Unusable, message};
}

/// "record", "golden verify": the command that was named, as the user would type it.
std::string NameOf(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? command.get_name() : NameOf(*parent) + " " + command.get_name();
}

CLI::App& CommandOf(CLI::App& program)
{
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    return chosen.empty() ? program : CommandOf(*chosen.front());
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

std::string Suggestion(const std::string& word, const std::vector<std::string>& candidates)
{
    const std::string question = DidYouMean(word, candidates);
    return question.empty() ? ";" : "; " + question;
}

/// The word after a command that is none of its own: a mistyped subcommand or option, or one word
/// too many.
Error UnexpectedWord(CLI::App& command)
{
    const std::vector<std::string> words = command.remaining();
    const auto isOption = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
    const auto found = std::find_if(words.begin(), words.end(), isOption);
    const std::string help = " `" + NameOf(command) + " --help` shows what there is.";
    if (found != words.end())
    {
        const std::string option = found->substr(0, found->find('='));
        return Unusable("Unknown option '" + option + "'" +
                        Suggestion(option, OptionNames(command)) + help);
    }
    const std::string word = words.empty() ? "" : words.front();
    const std::vector<std::string> commands = CommandNames(command);
    if (!commands.empty())
    {
        const std::string hint = word == "bench" // the script's, once the program's
                                     ? "; in a checkout `./boxreel bench` runs the benchmarks."
                                     : Suggestion(word, commands);
        return Unusable("Unknown command '" + word + "'" + hint + help);
    }
    return Unusable("'" + word + "' is one word too many;" + help);
}

Error MissingCommand(CLI::App& command)
{
    if (!command.remaining().empty())
    {
        return UnexpectedWord(command);
    }
    std::string names;
    for (const std::string& name : CommandNames(command))
    {
        names += (names.empty() ? "" : ", ") + name;
    }
    return Unusable("Say what to do: " + names + "; `" + NameOf(command) + " --help` tells more.");
}

/// The parser's words for a missing or repeated value begin with the option's name and a colon.
Error WrongCount(const CLI::ParseError& error)
{
    const std::string words = error.what();
    const std::string option = words.substr(0, words.find(':'));
    const bool isMissing = words.find("missing") != std::string::npos;
    return Unusable(isMissing ? option + " needs a value."
                              : option + " is given more than once; give it once.");
}

Error Explain(CLI::App& program, const CLI::ParseError& error)
{
    CLI::App& command = CommandOf(program);
    if (dynamic_cast<const CLI::ValidationError*>(&error) != nullptr)
    {
        return Unusable(error.what());
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr)
    {
        return WrongCount(error);
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    {
        return UnexpectedWord(command);
    }
    const bool isRequired = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    if (isRequired && (!CommandNames(command).empty() || !command.remaining().empty()))
    {
        return MissingCommand(command);
    }
    return Unusable(std::string(error.what()) + "; `" + NameOf(command) +
                    " --help` shows what there is.");
}

/// A film that is not whole has such a name, and is gone on with, or replaced.
Result<void> CheckFilmName(const std::filesystem::path& film)
{
    return film.stem().extension() == ".part"
               ? Unusable("-o " + film.string() +
                          ": that is what an unfinished film is called; "
                          "choose a name without .part.")
               : Result<void>();
}

// Beside the column of panels something of the scene must be left [px].
constexpr int kLeastPanelWidth = 480;
constexpr int kLeastPanelHeight = 240;

/// The panel has one size; a picture that would cut it off is refused.
Result<void> CheckHud(SceneLook& look)
{
    if (look.panels && look.hud)
    {
        return Unusable("--ui shows what --hud does, and more; give one of them.");
    }
    if (look.panels && (look.width < kLeastPanelWidth || look.height < kLeastPanelHeight))
    {
        return Unusable("--ui needs a picture of at least " + std::to_string(kLeastPanelWidth) +
                        "x" + std::to_string(kLeastPanelHeight) +
                        " pixels; give a larger --size or leave the panels out.");
    }
    look.hud = look.hud || (look.hudMilliseconds && !look.panels);
    const int height = look.hudMilliseconds ? 150 : 130; // a line more
    if (look.hud && (look.width < 200 || look.height < height))
    {
        return Unusable("--hud needs a picture of at least 200x" + std::to_string(height) +
                        " pixels; give a larger --size or leave the panel out.");
    }
    return {};
}

Result<Request> CheckRecord(RecordOptions options)
{
    RETURN_IF_ERROR(CheckHud(options.look));
    if (options.scene.empty())
    {
        return Unusable("Say which scene, such as `boxreel record pyramid -o pyramid.mp4`; "
                        "`boxreel list` shows them.");
    }
    if (options.output.empty())
    {
        return Unusable("Say where the film goes, such as -o film.mp4.");
    }
    RETURN_IF_ERROR(CheckFilmName(options.output));
    if (options.film.resume && options.film.overwrite)
    {
        return Unusable("--resume goes on with what --force throws away; give one of them.");
    }
    if (options.length.range && !options.length.until.empty())
    {
        return Unusable("--frame-range needs a film whose length is known; leave --until out.");
    }
    if (options.skipDone && !options.length.range)
    {
        return Unusable("--skip-done asks the papers of a part, and a whole film has none; give "
                        "--frame-range, too, or leave it out.");
    }
    if (options.skipDone && options.film.overwrite)
    {
        return Unusable("--skip-done keeps what --force throws away; give one of them.");
    }
    if (options.messages.progress == ProgressMode::OpenJD && options.output == "-")
    {
        return Unusable("--progress openjd and -o - both need the standard output; write a file.");
    }
    if (options.look.panels && !options.snapshots.folder.empty())
    {
        return Unusable("--snapshots keeps states of the scene, but not of the panels that --ui "
                        "shows; leave one of them out.");
    }
    if (options.snapshots.every && options.snapshots.folder.empty())
    {
        return Unusable("--snapshot-every says how often, --snapshots DIR where to; give both.");
    }
    if (options.thumbnail.at && options.thumbnail.file.empty())
    {
        return Unusable("--thumbnail-at says when, --thumbnail FILE.png where to; give both.");
    }
    if (options.length.seconds && options.length.frames)
    {
        return Unusable("--seconds and --frames both say how long the film is; give one of them.");
    }
    if (options.length.seconds && options.length.seconds->nanoseconds == 0)
    {
        return Unusable("--seconds 0: a film needs at least one frame; give more than 0.");
    }
    return Request(std::move(options));
}

/// What pixels cannot be, and what only pixels can be.
Result<void> CheckPixels(const ShotOptions& options)
{
    const bool isVector =
        PictureFormatOf(options.output).value_or(PictureFormat::Png) != PictureFormat::Png;
    if (isVector && (options.look.hud || options.look.panels))
    {
        return Unusable(std::string(options.look.hud ? "--hud" : "--ui") +
                        " draws a panel of pixels, which '" + options.output.string() +
                        "' cannot hold; leave it out, or write a .png.");
    }
    if (isVector && options.stats)
    {
        return Unusable("--stats counts pixels, and '" + options.output.string() +
                        "' has none; leave it out, or write a .png.");
    }
    const Camera size = Scaled(Camera{.width = options.look.width, .height = options.look.height},
                               options.look.scale);
    if (!isVector && std::max(size.width, size.height) > 8192)
    {
        return Unusable("--scale makes it " + std::to_string(size.width) + "x" +
                        std::to_string(size.height) +
                        " pixels, and 8192 is the most each way; lower it or --size, or write an "
                        ".svg or a .pdf.");
    }
    return {};
}

Result<Request> CheckShot(ShotOptions options)
{
    RETURN_IF_ERROR(CheckHud(options.look));
    if (options.scene.empty())
    {
        return Unusable("Say which scene, such as `boxreel shot pyramid --at 3s -o pyramid.png`; "
                        "`boxreel list` shows them.");
    }
    if (options.output.empty())
    {
        return Unusable("Say where the picture goes, such as -o picture.png.");
    }
    if (!options.at.empty() && !options.steps.empty())
    {
        return Unusable("--at and --step both say when the picture is taken; give one of them.");
    }
    if (options.at.empty() && options.steps.empty())
    {
        return Unusable("Say when the picture is taken, such as --at 3s or --step 180.");
    }
    RETURN_IF_ERROR(CheckMotion(options));
    RETURN_IF_ERROR(CheckPixels(options));
    return Request(std::move(options));
}

Result<Request> CheckMerge(MergeOptions options)
{
    if (options.parts.empty())
    {
        return Unusable("Name the parts, such as `boxreel merge a.mkv b.mkv -o film.mkv`.");
    }
    if (options.output.empty())
    {
        return Unusable("Say where the film goes, such as -o film.mkv.");
    }
    if (options.output == "-")
    {
        return Unusable("A film that is joined needs a file, of the same kind as its parts; give "
                        "its name, such as -o film.mkv.");
    }
    RETURN_IF_ERROR(CheckFilmName(options.output));
    return Request(std::move(options));
}

Result<Request> CheckExport(ExportOptions options, const CLI::App& command)
{
    if (options.scene.empty())
    {
        return Unusable("Say which scene, such as `boxreel export pyramid -o pyramid.json`; "
                        "`boxreel list` shows them.");
    }
    if (options.output.empty())
    {
        return Unusable("Say where the scene file goes, such as -o scene.json, or - for the "
                        "standard output.");
    }
    if (options.output != "-" && options.output.extension() != ".json")
    {
        return Unusable("-o " + options.output.string() +
                        ": a scene file is found by its end; give a name with .json, or -.");
    }
    if (options.at && command.count("--step") > 0)
    {
        return Unusable("--at and --step both say when; give one of them.");
    }
    return Request(std::move(options));
}

Result<Request> CheckPlay(PlayOptions options)
{
    if (options.script.empty())
    {
        return Unusable("Name the script, such as `boxreel play walk.play`.");
    }
    if (options.resume && options.force)
    {
        return Unusable("--resume goes on with what --force throws away; give one of them.");
    }
    if (options.check && options.accept)
    {
        return Unusable("--check makes nothing, and --accept would; give one of them.");
    }
    return Request(std::move(options));
}

Result<Request> CheckDiff(DiffOptions options)
{
    if (options.expected.empty() || options.actual.empty())
    {
        return Unusable("Name two pictures, such as `boxreel diff before.png after.png`.");
    }
    return Request(std::move(options));
}

/// `boxreel completion`, `boxreel man`.
Result<Request> Description(CLI::App& program, const std::string& name, std::optional<Shell> shell)
{
    if (name == "completion" && !shell)
    {
        return Unusable(
            "Say for which shell, such as `boxreel completion bash`; zsh is the other.");
    }
    const CommandText text = DescribeCommands(program);
    return Request(TextRequest{name == "man"          ? ManualPage(text)
                               : shell == Shell::Bash ? BashCompletion(text)
                                                      : ZshCompletion(text)});
}

Result<Request> Chosen(CLI::App& program, ParsedOptions& parsed)
{
    const std::string name = program.get_subcommands().front()->get_name();
    if (name == "completion" || name == "man")
    {
        return Description(program, name, parsed.shell);
    }
    if (name == "record")
    {
        return CheckRecord(std::move(parsed.record));
    }
    if (name == "merge")
    {
        return CheckMerge(std::move(parsed.merge));
    }
    if (name == "shot")
    {
        return CheckShot(std::move(parsed.shot));
    }
    if (name == "diff")
    {
        return CheckDiff(std::move(parsed.diff));
    }
    if (name == "golden" && program.get_subcommands().front()->got_subcommand("state"))
    {
        return Request(std::move(parsed.goldenState));
    }
    if (name == "golden" && program.get_subcommands().front()->got_subcommand("report"))
    {
        return Request(std::move(parsed.goldenReport));
    }
    if (name == "golden")
    {
        return Request(std::move(parsed.golden));
    }
    if (name == "doctor")
    {
        return Request(DoctorOptions{});
    }
    if (name == "check")
    {
        return parsed.check.file.empty()
                   ? Unusable("Name the scene file, such as `boxreel check machine.json`.")
                   : Result<Request>(std::move(parsed.check));
    }
    if (name == "export")
    {
        return CheckExport(std::move(parsed.exported), *program.get_subcommand("export"));
    }
    if (name == "play")
    {
        return CheckPlay(std::move(parsed.play));
    }
    if (name == "ui")
    {
        return Request(std::move(parsed.ui));
    }
    return Request(parsed.list);
}

void DeclareProgram(CLI::App& program, ParsedOptions& parsed)
{
    program.formatter(std::make_shared<HelpFormatter>());
    program.set_version_flag("--version", "boxreel " BOXREEL_VERSION, "Print the version and exit");
    program.require_subcommand(1);
    program.footer("Examples:\n"
                   "  boxreel list\n"
                   "  boxreel record pyramid -o pyramid.mp4\n"
                   "  boxreel shot pyramid --at 3s -o pyramid.png\n\n"
                   "`boxreel COMMAND --help` tells more. Exit codes: 0 done, 1 not usable,\n"
                   "2 not as it should be (pictures differ, a script's expectation fails), 3 "
                   "something is absent,\n"
                   "4 reading or writing failed, 75 stopped and can be resumed.");
    DeclareList(program, parsed);
    DeclareRecord(program, parsed);
    DeclareMerge(program, parsed);
    DeclareShot(program, parsed);
    DeclareDiff(program, parsed);
    DeclareGolden(program, parsed);
    DeclarePlay(program, parsed);
    DeclareUi(program, parsed);
    DeclareCheck(program, parsed);
    DeclareDoctor(program);
    DeclareExport(program, parsed);
    DeclareCompletion(program, parsed);
    DeclareMan(program);
    for (CLI::App* command : program.get_subcommands({}))
    {
        command->group("Commands");
        for (CLI::App* action : command->get_subcommands({}))
        {
            action->group("Commands");
        }
    }
}

} // namespace

CommandText DescribeProgram()
{
    CLI::App program(kWhat, "boxreel");
    ParsedOptions parsed;
    DeclareProgram(program, parsed);
    return DescribeCommands(program);
}

Result<Request> ParseCommandLine(const std::vector<std::string>& arguments)
{
    CLI::App program(kWhat, "boxreel");
    ParsedOptions parsed;
    parsed.record.arguments.assign(arguments.begin(), arguments.end());
    DeclareProgram(program, parsed);
    std::vector<std::string> words = arguments;
    if (words.empty())
    {
        return Request(TextRequest{HelpOf(program)});
    }
    if (words.front() == "help")
    {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    std::reverse(words.begin(), words.end()); // as this overload of parse expects them
    try
    {
        program.parse(words);
    }
    catch (const CLI::CallForHelp&)
    {
        CLI::App& command = CommandOf(program);
        return command.remaining().empty() ? Request(TextRequest{HelpOf(program)})
                                           : Result<Request>(UnexpectedWord(command));
    }
    catch (const CLI::CallForVersion& version)
    {
        return Request(TextRequest{std::string(version.what()) + "\n"});
    }
    catch (const CLI::ParseError& error)
    {
        return Explain(program, error);
    }
    return Chosen(program, parsed);
}

} // namespace boxreel
