// SPDX-License-Identifier: MIT
#include "CommandLineOptions.h"
#include "OutputPath.h"

#include <algorithm>
#include <sstream>

namespace boxreel
{
namespace
{

Result<double> ParseScale(const std::string& option, const std::string& text)
{
    const Result<double> scale = ParseNumber(option, text);
    if (!scale || *scale < 0.1 || *scale > 16.0)
    {
        return Error{ErrorKind::Unusable,
                     option + " '" + text + "': give a number from 0.1 to 16, such as 2."};
    }
    return scale;
}

} // namespace

CLI::Option* AddFlag(CLI::App& command, const std::string& names, bool& flag,
                     const std::string& help)
{
    return command.add_flag(names, flag, help);
}

CLI::Option* AddText(CLI::App& command, const std::string& names,
                     const std::function<void(const std::string&)>& read, const std::string& help)
{
    return command.add_option_function<std::string>(names, read, help);
}

CLI::Option* AddTexts(CLI::App& command, const std::string& names,
                      const std::function<void(const std::vector<std::string>&)>& read,
                      const std::string& help)
{
    return command.add_option_function<std::vector<std::string>>(names, read, help);
}

std::string ListedWords(const std::vector<std::string>& words)
{
    std::string list;
    for (const std::string& word : words)
    {
        list.append(list.empty() ? "" : ", ").append(word);
    }
    return list;
}

void Refuse(const std::string& message)
{
    throw CLI::ValidationError(message);
}

CLI::Option* AddScene(CLI::App& command, std::string& scene)
{
    CLI::Option* option =
        command.add_option("SCENE", scene, "A name from `boxreel list`, or a R.U.B.E. .json file");
    return Completes(option->type_name(""), {Completion::Kind::Scenes, {".json"}});
}

void AddPath(CLI::App& command, const std::string& names, const std::string& unit,
             std::filesystem::path& path, const std::string& help,
             const std::vector<std::string>& ends)
{
    const auto read = [&path, names](const std::string& text) {
        if (text.empty() && names.starts_with("-"))
        {
            Refuse(names.substr(0, names.find(',')) + " is empty; give a name.");
        }
        path = text;
    };
    CLI::Option* option = AddText(command, names, read, help);
    option->type_name(unit);
    Completes(option, unit == "DIR" ? Completion{Completion::Kind::Folders, {}}
                                    : Completion{Completion::Kind::Files, ends});
}

void AddForce(CLI::App& command, bool& force)
{
    AddFlag(command, "--force", force, "Overwrite an existing file");
}

void AddStats(CLI::App& command, bool& stats)
{
    AddFlag(command, "--stats", stats,
            "Then say what was drawn, what left as it was, and\nwhere the time of a film went");
}

CLI::Option* AddBackend(CLI::App& command, Backend& backend)
{
    CLI::Option* option =
        AddValue(command, "--backend", "NAME", backend, ParseBackend,
                 ListedWords(BackendNames()) + " (auto: $BOXREEL_BACKEND, or what works)");
    return Completes(option, {Completion::Kind::Words, BackendNames()});
}

void DeclareList(CLI::App& program, ParsedOptions& parsed)
{
    CLI::App* command = program.add_subcommand("list", "The scenes, with what they show");
    AddFlag(*command, "--names", parsed.list.namesOnly, "Names only, one a line");
    command->footer("Examples:\n"
                    "  boxreel list\n"
                    "  boxreel list --names | head -3");
}

void DeclareShot(CLI::App& program, ParsedOptions& parsed)
{
    ShotOptions& shot = parsed.shot;
    CLI::App* command = program.add_subcommand("shot", "Make one picture of a scene");
    AddScene(*command, shot.scene);
    AddPath(*command, "-o,--output", "FILE", shot.output, "The picture: .png, .svg or .pdf",
            FigureEnds());
    AddForce(*command, shot.force);
    AddStats(*command, shot.stats);
    AddMotion(*command, shot);
    AddValue(*command, "--scale", "FACTOR", shot.look.scale, ParseScale,
             "Of all lengths in pixels, lines and text too; 0.1 to 16 (1)")
        ->group("Picture");
    AddLook(*command, shot.look, &shot.bothThemes);
    AddBackend(*command, shot.backend)->group("Picture");
    command->footer(
        "The pixels of a .png are those of a film's frame at the same time. In .svg and .pdf text\n"
        "stays text, and each body is a group with a name. --theme both writes NAME-light.EXT\n"
        "(print) and NAME-dark.EXT. --size is that of a picture, without what is beside it; of\n"
        "several moments, that of each (640x360).\n\n"
        "Examples:\n"
        "  boxreel shot pyramid --at 3s -o pyramid.png\n"
        "  boxreel shot bridge --step 180 -o bridge.png --size 1920x1080 --hud\n"
        "  boxreel shot chain --at 500ms -o chain.png --draw shapes,joints,aabbs --labels\n"
        "  boxreel shot tumbler --at 4s -o tumbler.svg --theme okabe-ito\n"
        "  boxreel shot pyramid --at 3s -o pyramid.pdf --theme print --labels\n"
        "  boxreel shot bridge --at 2s -o bridge.svg --theme both\n"
        "  boxreel shot newtons-cradle --at 1s -o cradle.png --trail moving --onion 6:50ms\n"
        "  boxreel shot dominos --at 0s,1s,2s,3s -o dominos.pdf --theme print --scale-bar\n"
        "  boxreel shot bridge --at 2s -o b.svg --axes --dimension 3,17 --caption \"A bridge.\"");
}

void DeclareDiff(CLI::App& program, ParsedOptions& parsed)
{
    DiffOptions& diff = parsed.diff;
    CLI::App* command = program.add_subcommand("diff", "Compare two pictures");
    AddPath(*command, "A", "", diff.expected, "The picture that is right, .png", {".png"});
    AddPath(*command, "B", "", diff.actual, "The picture to judge, .png", {".png"});
    AddPath(*command, "-o,--output", "FILE", diff.output,
            "Write a picture of the differences, .png", {".png"});
    AddForce(*command, diff.force);
    AddCompare(*command, diff.compare, "same-machine");
    command->footer("Exit code 0: equal, 2: different, 1: a picture that cannot be read.\n\n"
                    "Examples:\n"
                    "  boxreel diff before.png after.png\n"
                    "  boxreel diff before.png after.png --preset exact -o diff.png\n"
                    "  boxreel diff mine.png yours.png --preset cross-machine --ignore 0,0,200x30");
}

namespace
{

/// The words of --only.
struct GoldenFilterChoice
{
    std::vector<std::string> Words() const { return {"all", "changed", "missing"}; }
    Result<GoldenFilter> operator()(const std::string& option, const std::string& text) const
    {
        const std::vector<std::string> words = Words();
        const auto found = std::find(words.begin(), words.end(), text);
        return found == words.end() ? Result<GoldenFilter>(NotOneOf(option, text, words))
                                    : Result<GoldenFilter>(GoldenFilter(found - words.begin()));
    }
};

void DeclareGoldenState(CLI::App& golden, GoldenStateOptions& options)
{
    CLI::App* command =
        golden.add_subcommand("state", "Print a scene's state at a step, body by body");
    CLI::Option* scene = command->add_option("SCENE", options.scene, "Such as pyramid")->required();
    Completes(scene->type_name(""), {Completion::Kind::Scenes, {}});
    AddValue(*command, "--step", "N", options.step, WholeBetween(0, 1'000'000),
             "Simulation steps since the start (300)");
    AddFlag(*command, "--trace", options.trace, "Hashes of every step up to it instead");
    command->footer(
        "The hash of all, then a line a body: number, x, y, angle and, where it moves,\n"
        "velocity x, y, angular. "
        "With --trace a line a step: number, hash, a digit for each\nbody.\n\n"
        "Examples:\n"
        "  boxreel golden state pyramid --step 120\n"
        "  boxreel golden state car --trace --step 60");
}

void DeclareGoldenReport(CLI::App& golden, GoldenReportOptions& options)
{
    CLI::App* command =
        golden.add_subcommand("report", "Make a page of what golden tests found, for a browser");
    const auto read = [&options](const std::vector<std::string>& texts) {
        options.folders.assign(texts.begin(), texts.end());
    };
    CLI::Option* folders = AddTexts(*command, "FOLDERS", read,
                                    "That tests wrote to, one a shard (build/golden-output)");
    Completes(folders->type_name(""), {Completion::Kind::Folders, {}});
    AddPath(*command, "-o,--output", "FILE", options.output,
            "The page (report.html in the first folder)", {".html"});
    AddPath(*command, "--against", "FILE", options.against,
            "Another build of boxreel: its pictures of the steps\n"
            "around the first that differs, too");
    AddBackend(*command, options.backend);
    AddForce(*command, options.force);
    command->footer(
        "One file that needs no other: summary, filter, and for each moment that differs "
        "expected,\n"
        "actual, difference, blink, slider, the outlines of both worlds and the first step that\n"
        "differs. Exit code 0 when it is written, whatever it says.\n\n"
        "Examples:\n"
        "  boxreel golden report\n"
        "  boxreel golden report shard-0 shard-1 -o report.html\n"
        "  boxreel golden report --against ../before/build/release/boxreel");
}

void DeclareGoldenFilm(CLI::App& action, GoldenOptions& golden)
{
    AddPath(action, "--film", "FILE", golden.film,
            "A film's contact sheet instead of scenes; NAMES is\nwhat it is called (films/FILE)",
            VideoEnds());
    CLI::Option* film = action.get_option("--film");
    AddValue(action, "--every", "STEPS", golden.sheet.every, WholeBetween(1, 1'000'000),
             "Steps from one picture of the sheet to the next (30)")
        ->needs(film);
    AddValue(
        action, "--hz", "RATE", golden.sheet.stepsPerSecond,
        [](const std::string& option, const std::string& text) -> Result<double> {
            const Result<Rational> rate = RatioBetween(1.0, 100000.0)(option, text);
            return rate ? Result<double>(rate->ToDouble()) : Result<double>(rate.GetError());
        },
        "Simulation steps in a second of the film (60)")
        ->needs(film);
}

} // namespace

void DeclareGolden(CLI::App& program, ParsedOptions& parsed)
{
    GoldenOptions& golden = parsed.golden;
    CLI::App* command =
        program.add_subcommand("golden", "Compare the scenes with what was approved");
    command->require_subcommand(1);
    command->footer("Examples:\n"
                    "  boxreel golden verify\n"
                    "  boxreel golden verify pyramid bridge --output /tmp/failures\n"
                    "  boxreel golden accept pyramid");
    CLI::App* verify = command->add_subcommand(
        "verify", "Simulate, draw and compare; what differs is left to look at");
    CLI::App* accept = command->add_subcommand("accept", "Make what the scenes show the reference");
    for (CLI::App* action : {verify, accept})
    {
        CLI::Option* names = action->add_option(
            "NAMES", golden.names, "Such as pyramid or pyramid/2s; all when none is given");
        Completes(names->type_name(""), {Completion::Kind::Scenes, {}});
        AddPath(*action, "--references", "DIR", golden.references,
                "Folder of what was approved (golden/references)");
        AddPath(*action, "--output", "DIR", golden.output,
                "Folder for what differs (build/golden-output)");
        AddBackend(*action, golden.backend);
        DeclareGoldenFilm(*action, golden);
    }
    AddCompare(*verify, golden.compare,
               "cross-machine where another renderer drew the\nreference, else same-machine");
    AddIgnoredBodies(*verify, golden.compare);
    verify->footer("Exit code 0: all as approved, 2: something differs or was never approved.\n\n"
                   "Examples:\n"
                   "  boxreel golden verify\n"
                   "  boxreel golden verify pyramid --output /tmp/failures\n"
                   "  boxreel golden verify --report report.html\n"
                   "  boxreel golden verify pyramid --against ../before/build/release/boxreel\n"
                   "  boxreel golden verify menu --film menu.mp4 --preset cross-machine");
    accept->footer("Look at the pictures before they are committed, and say in the commit why they "
                   "changed.\n\n"
                   "Examples:\n"
                   "  boxreel golden accept\n"
                   "  boxreel golden accept pyramid bridge\n"
                   "  boxreel golden accept --only missing\n"
                   "  boxreel golden accept menu --film menu.mp4");
    accept->callback([&golden] { golden.accept = true; });
    AddPath(*verify, "--against", "FILE", golden.against,
            "Another build of boxreel: compare each step's state with\n"
            "what it does, instead of with what was approved");
    AddValue(*accept, "--only", "WHICH", golden.acceptance.only, GoldenFilterChoice(),
             "all, changed, missing (all)");
    AddFlag(*accept, "--for-this-renderer", golden.acceptance.forThisRenderer,
            "Only pictures drawn by the same renderer are compared with these");
    AddPath(*verify, "--report", "FILE", golden.report,
            "A page of what was verified, for a browser", {".html"});
    DeclareGoldenReport(*command, parsed.goldenReport);
    DeclareGoldenState(*command, parsed.goldenState);
}

void DeclarePlay(CLI::App& program, ParsedOptions& parsed)
{
    PlayOptions& play = parsed.play;
    CLI::App* command =
        program.add_subcommand("play", "Play a script: what it expects, films and pictures");
    AddPath(*command, "SCRIPT", "", play.script, "A text file; below is what it holds", {".play"});
    AddPath(*command, "--into", "DIR", play.into, "Folder for what it makes (the current one)");
    AddFlag(*command, "--check", play.check,
            "Only say whether it can be played; simulates and makes nothing");
    AddFlag(*command, "--test", play.test,
            "Only look at what it expects and at what was approved; makes no\nfilms and "
            "shots");
    AddFlag(*command, "--accept", play.accept,
            "Pictures become the references that they would be compared with");
    AddFlag(*command, "--for-this-renderer", play.forThisRenderer,
            "With --accept: only pictures drawn by the same renderer are\ncompared with these");
    AddForce(*command, play.force);
    AddFlag(*command, "--resume", play.resume, "Go on with films that were stopped");
    AddBackend(*command, play.backend);
    command->footer(
        "A script:\n"
        "  scene car --seed 3 --hz 120          a scene or a file, and options of `boxreel shot`\n"
        "  at 1s press d                        a key goes down; also release, tap\n"
        "  at 2s grab 3.5,4                     the mouse's button goes down at a point [m]\n"
        "  at 2s to 3s drag 8,4                 it moves straight there; at once: move 8,4\n"
        "  at 3s drop                           its button goes up\n"
        "  at step 240 bomb 0,30 5,-40          from a place with a velocity, or just: bomb\n"
        "  at 4s shift 100,0                    of the origin\n"
        "  at 4s set sub-steps 4                of the solver; sleep and others: on or off\n"
        "  at 4s click Solver/Sleep             on the panels of `boxreel ui`; also type, hit\n"
        "  at 0s camera 0,5,20                  middle and height; goes on to the next one\n"
        "  at 5s expect chassis.x > 10          as --until of `boxreel record`; or: state HASH\n"
        "  at 5s golden car/5s                  compared with what was approved, beside the "
        "script\n"
        "  at 5s shot car.png --draw shapes     with options of `boxreel shot`\n"
        "  record car.mp4 --seconds 8           with options of `boxreel record`\n"
        "What is done at a time shows in the step that begins there. # begins a remark, and what "
        "has blanks\nstands in quotes (\"). Exit code 2: an expectation does not hold, or a "
        "picture "
        "is not as approved.\n\n"
        "Examples:\n"
        "  boxreel play testbed/scripts/car.play\n"
        "  boxreel play walk.play --into films --force");
}

void DeclareCheck(CLI::App& program, ParsedOptions& parsed)
{
    CLI::App* command = program.add_subcommand("check", "Say what of a scene file can be built");
    AddPath(*command, "FILE", "", parsed.check.file, "A R.U.B.E. .json file", {".json"});
    command->footer("Lists what is left out and why, and notes where the format's defaults are not "
                    "the engine's.\nExit code 0: all can be built, 2: something is left out, 1: no "
                    "scene file.\n\n"
                    "Examples:\n"
                    "  boxreel check machine.json");
}

void DeclareDoctor(CLI::App& program)
{
    CLI::App* command = program.add_subcommand("doctor", "Say what works on this machine");
    command->footer(
        "Draws, films and computes a little of each kind. What does not work is said with "
        "what helps.\nExit code 0: all works (one of the back ends is enough), 2: the "
        "engine computes otherwise than\nelsewhere, 3: something is not installed, 4: no "
        "room or no right to write here.\n\n"
        "Examples:\n"
        "  boxreel doctor");
}

void DeclareExport(CLI::App& program, ParsedOptions& parsed)
{
    ExportOptions& options = parsed.exported;
    CLI::App* command = program.add_subcommand("export", "Write a scene as a scene file");
    AddScene(*command, options.scene);
    AddPath(*command, "-o,--output", "FILE", options.output,
            "The scene file, .json; - for the standard output", {".json"});
    AddForce(*command, options.force);
    AddValue(*command, "--at", "TIME", options.at, ParseDuration,
             "After so much simulated time: 3s, 500ms, 2.5 (0s)");
    AddValue(*command, "--step", "N", options.step, WholeBetween(0, 1'000'000'000),
             "Or after so many steps");
    AddValue(*command, "--hz", "RATE", options.look.stepsPerSecond, RatioBetween(1.0, 100000.0),
             "Simulation steps a second (60)");
    AddValue(*command, "--seed", "N", options.look.seed, WholeBetween(0, 0xffffffff),
             "Of the scene's random numbers (1)");
    command->footer(
        "Bodies, shapes, joints and names come back bit by bit, also by `boxreel record "
        "FILE`. What a scene\ndoes by itself, steering, new bodies, is no part of a "
        "scene file, nor are the impulses of contacts\nthat touch.\n\n"
        "Examples:\n"
        "  boxreel export pyramid -o pyramid.json\n"
        "  boxreel export bridge --at 2s -o sagging.json");
}

} // namespace boxreel
