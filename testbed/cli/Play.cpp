// SPDX-License-Identifier: MIT
#include "Play.h"
#include "CommandLine.h"
#include "Declare.h"
#include "OutputPath.h"
#include "Record.h"
#include "Shot.h"

#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Terminal.h>
#include <film/PageRun.h>
#include <golden/ReferenceStore.h>
#include <golden/StateHash.h>
#include <render/Renderer.h>
#include <script/Script.h>
#include <session/SessionPanels.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

/// A product whose options are understood.
struct Expectation
{
    int line = 0;
    ScriptMoment at;
    std::optional<Condition> condition; ///< none: it is the world's state that is expected
    std::string state{};                ///< its hash, 16 hex digits
};
struct GoldenPicture
{
    int line = 0;
    std::string name;
    ShotOptions shot;
};
struct StillPicture
{
    int line = 0;
    ShotOptions shot;
};
struct Film
{
    int line = 0;
    RecordOptions record;
};

struct Play
{
    Script script;
    SceneLook look; ///< of the scene's line
    std::vector<Expectation> expectations;
    std::vector<GoldenPicture> goldens;
    std::vector<StillPicture> stills;
    std::vector<Film> films;
};

/// A file is meant from where the script is.
std::string SceneOf(const Script& script)
{
    const fs::path scene = script.scene;
    return scene.extension() == ".json" && scene.is_relative()
               ? (script.file.parent_path() / scene).string()
               : script.scene;
}

/// The command line that makes a product, understood as if it had been typed.
template <class Options>
Result<Options> Understood(const Script& script, const char* command,
                           const std::vector<std::string>& options, const fs::path& output)
{
    std::vector<std::string> words{command, SceneOf(script)};
    const std::vector<std::string> shared = script.SceneOptions();
    words.insert(words.end(), shared.begin(), shared.end());
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"-o", output.string()});
    ASSIGN_OR_RETURN(Request request, ParseCommandLine(words));
    Options* const understood = std::get_if<Options>(&request);
    if (understood == nullptr)
    {
        return Error{ErrorKind::Unusable, "--help", "is not possible in a script"};
    }
    return std::move(*understood);
}

bool& Overwrite(ShotOptions& shot)
{
    return shot.force;
}

bool& Overwrite(RecordOptions& record)
{
    return record.film.overwrite;
}

class Planner
{
public:
    Planner(Play& play, const PlayOptions& options) : m_play(play), m_options(options) {}

    Result<void> Plan();

private:
    Result<void> Add(const ScriptProduct& product);
    Result<void> AddExpectation(const ScriptProduct& product);
    Result<void> AddExpectedState(const ScriptProduct& product);
    Result<void> AddGolden(const ScriptProduct& product);
    Result<void> AddStill(const ScriptProduct& product);
    Result<void> AddFilm(const ScriptProduct& product);
    Result<fs::path> OutputOf(const ScriptProduct& product) const;
    template <class Options>
    Result<void> Claim(const ScriptProduct& product, Options options, bool overwrites);

    Play& m_play;
    const PlayOptions& m_options;
    std::shared_ptr<const Script> m_actions;
    std::vector<std::pair<fs::path, int>> m_files; ///< that are made, and by which line
};

Result<void> Planner::Plan()
{
    const Script& script = m_play.script;
    m_actions = std::make_shared<const Script>(script);
    // Parsed with options that every picture has, so an error is in the scene's line.
    const Result<ShotOptions> any =
        Understood<ShotOptions>(script, "shot", {"--step", "0"}, "any.png");
    if (!any)
    {
        return script.At(script.sceneLine, any.GetError());
    }
    m_play.look = any->look;
    m_play.look.simulation.script = m_actions;
    for (const ScriptProduct& product : script.products)
    {
        if (const Result<void> added = Add(product); !added)
        {
            return script.At(product.line, added.GetError());
        }
    }
    return {};
}

Result<void> Planner::Add(const ScriptProduct& product)
{
    switch (product.kind)
    {
    case ScriptProduct::Kind::Expect:
        return AddExpectation(product);
    case ScriptProduct::Kind::ExpectState:
        return AddExpectedState(product);
    case ScriptProduct::Kind::Golden:
        return AddGolden(product);
    case ScriptProduct::Kind::Shot:
        return AddStill(product);
    case ScriptProduct::Kind::Record:
        break;
    }
    return AddFilm(product);
}

Result<void> Planner::AddExpectation(const ScriptProduct& product)
{
    ASSIGN_OR_RETURN(const Condition condition, Condition::Parse("expect", product.name));
    m_play.expectations.push_back({product.line, product.at, condition});
    return {};
}

Result<void> Planner::AddExpectedState(const ScriptProduct& product)
{
    const std::string& hash = product.name;
    const bool isHash =
        hash.size() == 16 && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!isHash)
    {
        return Error{ErrorKind::Unusable, Quoted(hash), "is not a state hash",
                     "give the 16 hex digits that the window and verdicts print"};
    }
    m_play.expectations.push_back({product.line, product.at, std::nullopt, hash});
    return {};
}

Result<void> Planner::AddGolden(const ScriptProduct& product)
{
    RETURN_IF_ERROR(CheckReferenceName(product.name));
    std::vector<std::string> options = product.options;
    const std::vector<std::string> moment = product.at.AsOption();
    options.insert(options.end(), moment.begin(), moment.end());
    ASSIGN_OR_RETURN(ShotOptions shot,
                     Understood<ShotOptions>(m_play.script, "shot", options, "any.png"));
    shot.look.simulation.script = m_actions;
    shot.look.collectEverything = true;
    m_play.goldens.push_back({product.line, product.name, std::move(shot)});
    return {};
}

Result<fs::path> Planner::OutputOf(const ScriptProduct& product) const
{
    if (product.name == "-")
    {
        return Error{ErrorKind::Unusable, "-", "a script cannot write to standard output",
                     "give a file name"};
    }
    return m_options.into.empty() ? fs::path(product.name) : m_options.into / product.name;
}

/// Checks that a film or picture can be made: no other line writes its files, and its options are
/// valid.
template <class Options>
Result<void> Planner::Claim(const ScriptProduct& product, Options options, bool overwrites)
{
    const bool mayBeThere = overwrites || m_options.resume || m_options.check || m_options.test;
    for (const fs::path& file : FilesOf(options))
    {
        for (const auto& [other, line] : m_files)
        {
            if (IsSameFile(file, other))
            {
                return Error{ErrorKind::Unusable, file.string(),
                             "is written by line " + std::to_string(line) + " as well",
                             "give each file its own name"};
            }
        }
        m_files.emplace_back(file, product.line);
        std::error_code ignored;
        if (!mayBeThere && fs::exists(file, ignored))
        {
            return Error{ErrorKind::Unusable, file.string(), "already exists",
                         "use --force to overwrite it"};
        }
    }
    if (m_options.test)
    {
        return {}; // nothing is made
    }
    Overwrite(options) = mayBeThere;
    return Prepare(options);
}

Result<void> Planner::AddStill(const ScriptProduct& product)
{
    ASSIGN_OR_RETURN(const fs::path output, OutputOf(product));
    ASSIGN_OR_RETURN(ShotOptions shot,
                     Understood<ShotOptions>(m_play.script, "shot", product.options, output));
    shot.look.simulation.script = m_actions;
    shot.force = shot.force || m_options.force;
    shot.backend = m_options.backend;
    RETURN_IF_ERROR(Claim(product, shot, shot.force));
    m_play.stills.push_back({product.line, std::move(shot)});
    return {};
}

Result<void> Planner::AddFilm(const ScriptProduct& product)
{
    ASSIGN_OR_RETURN(const fs::path output, OutputOf(product));
    ASSIGN_OR_RETURN(RecordOptions record,
                     Understood<RecordOptions>(m_play.script, "record", product.options, output));
    if (m_play.script.UsesPanels() && !record.snapshots.folder.empty())
    {
        return Conflict("--snapshots", "actions on panels");
    }
    record.look.simulation.script = m_actions;
    record.film.overwrite = record.film.overwrite || m_options.force;
    // A page has no parts, so it cannot be continued.
    record.film.resume = record.film.resume || (m_options.resume && !IsPage(record.output));
    record.backend = m_options.backend;
    RETURN_IF_ERROR(Claim(product, record, record.film.overwrite));
    // A film that was stopped is gone on with if all of this is the same.
    record.arguments.push_back("actions:" + m_actions->actionText);
    m_play.films.push_back({product.line, std::move(record)});
    return {};
}

Result<SceneSession> OpenSession(const Play& play, const SceneLook& look)
{
    Result<SceneSource> source = OpenScene(SceneOf(play.script));
    if (!source)
    {
        return play.script.At(play.script.sceneLine, source.GetError());
    }
    return OpenSession(std::move(*source), look);
}

std::string NumberText(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// A body that is not there and cannot come either is a mistake.
Result<void> CheckBody(const Play& play, const Expectation& expectation,
                       const SceneSession& session)
{
    const std::optional<Error> missing =
        expectation.condition ? expectation.condition->MissingBody(session.World(), session.Names())
                              : std::nullopt;
    return !missing || session.MakesBodiesLater() ? Result<void>()
                                                  : play.script.At(expectation.line, *missing);
}

/// The present result of an expectation.
struct Answer
{
    bool holds = false;
    std::string expected;
    std::string found; ///< empty: there is not a single value
};

Answer AnswerOf(const Expectation& expectation, const SceneSession& session)
{
    if (!expectation.condition)
    {
        const std::string state = StateHashText(session.World());
        return {state == expectation.state, "state " + expectation.state, state};
    }
    const Condition& condition = *expectation.condition;
    const auto value = condition.ValueIn(session.World(), session.Names(), session.Time());
    return {condition.Holds(session.World(), session.Names(), session.Time()), condition.Text(),
            value ? NumberText(*value) : ""};
}

/// Returns the number of expectations that do not hold, and prints one line for each.
Result<int> Expect(const Play& play, SceneSession& session)
{
    std::vector<const Expectation*> inOrder;
    for (const Expectation& expectation : play.expectations)
    {
        inOrder.push_back(&expectation);
    }
    const auto stepOf = [&session](const Expectation* e) {
        return e->at.Step(session.StepsPerSecond());
    };
    std::stable_sort(
        inOrder.begin(), inOrder.end(),
        [&](const Expectation* a, const Expectation* b) { return stepOf(a) < stepOf(b); });
    int failures = 0;
    for (const Expectation* expectation : inOrder)
    {
        RETURN_IF_ERROR(CheckBody(play, *expectation, session));
    }
    for (const Expectation* expectation : inOrder)
    {
        session.AdvanceTo(stepOf(expectation));
        const Answer answer = AnswerOf(*expectation, session);
        failures += answer.holds ? 0 : 1;
        std::string line = answer.holds ? "ok    " : Red("FAIL", stdout) + "  ";
        line += play.script.file.string() + ":" + std::to_string(expectation->line) + ": " +
                answer.expected;
        line += answer.found.empty() ? "" : " (" + answer.found + ")";
        RETURN_IF_ERROR(WriteOutput(line + "\n"));
    }
    // A click on a missing control is reported before anything is made.
    for (const ScriptAction& action : play.script.actions)
    {
        if (action.IsForPanels())
        {
            session.AdvanceTo(action.at.Step(session.StepsPerSecond()) + 1);
        }
    }
    RETURN_IF_ERROR(session.CheckCompanion());
    return failures;
}

Result<GoldenCandidate> CandidateOf(const Play& play, const GoldenPicture& golden, Backend backend)
{
    ASSIGN_OR_RETURN(SceneSession session, OpenSession(play, golden.shot.look));
    const SceneLook& look = golden.shot.look;
    ASSIGN_OR_RETURN(
        Renderer renderer,
        Renderer::Create(
            {.width = look.width, .height = look.height, .theme = look.theme, .backend = backend}));
    session.AdvanceTo(golden.shot.steps.empty()
                          ? StepAt(golden.shot.at.front(), session.StepsPerSecond())
                          : golden.shot.steps.front());
    FrameContent content;
    session.Fill(content);
    GoldenCandidate candidate;
    candidate.name = golden.name;
    candidate.stateHash = StateHashText(session.World());
    candidate.state = ReadWorldState(session.World());
    candidate.renderer = renderer.Description();
    ASSIGN_OR_RETURN(const std::string fingerprint, renderer.Fingerprint());
    candidate.fingerprint = fingerprint;
    const Overlay* const panel =
        look.panels.hud || look.panels.testbed ? &content.overlay : nullptr;
    RETURN_IF_ERROR(renderer.Draw(content.list, content.camera, candidate.frame, panel));
    candidate.list = std::move(content.list);
    return candidate;
}

/// Returns the number of golden moments that differ, and prints one line for each.
Result<int> CompareGoldens(const Play& play, const PlayOptions& options)
{
    const fs::path folder = play.script.file.parent_path();
    const fs::path output = options.into / "golden-output";
    const ReferenceStore store(folder / "references", output);
    int failures = 0;
    for (const GoldenPicture& golden : play.goldens)
    {
        ASSIGN_OR_RETURN(const GoldenCandidate candidate,
                         CandidateOf(play, golden, options.backend));
        std::string line = "accepted  " + golden.name;
        if (options.accept)
        {
            const AcceptAs as =
                options.forThisRenderer ? AcceptAs::ForThisRenderer : AcceptAs::TheOneCompared;
            if (const Result<void> accepted = store.Accept(candidate, as); !accepted)
            {
                return play.script.At(golden.line, accepted.GetError());
            }
        }
        else
        {
            Result<GoldenVerdict> verdict = store.Judge(candidate);
            const bool isSame = verdict && verdict->status == GoldenStatus::Same;
            if (!isSame) // only a failure leaves files to look at
            {
                verdict = store.Verify(candidate);
            }
            if (!verdict)
            {
                return play.script.At(golden.line, verdict.GetError());
            }
            failures += isSame ? 0 : 1;
            const std::string why = verdict->Text("play it again with --accept");
            line = isSame ? "same  " + golden.name
                          : Red("FAIL", stdout) + "  " + play.script.file.string() + ":" +
                                std::to_string(golden.line) + ": " + why;
        }
        RETURN_IF_ERROR(WriteOutput(line + "\n"));
    }
    return failures;
}

/// True if a resumed script skips this line, because its files are complete.
template <class Options>
bool IsDone(const Options& options, bool resumes)
{
    const std::vector<fs::path> files = FilesOf(options);
    const auto isThere = [](const fs::path& file) {
        std::error_code ignored;
        return fs::exists(file, ignored);
    };
    const bool isDone = resumes && std::all_of(files.begin(), files.end(), isThere);
    if (isDone)
    {
        WriteMessage("boxreel: " + files.front().string() +
                     " already exists; use --force to make it again");
    }
    return isDone;
}

Result<int> MakeFiles(const Play& play, bool resumes)
{
    for (const StillPicture& still : play.stills)
    {
        const Result<int> taken =
            IsDone(still.shot, resumes && !still.shot.force) ? 0 : Run(still.shot);
        if (!taken)
        {
            return play.script.At(still.line, taken.GetError());
        }
    }
    for (const Film& film : play.films)
    {
        const Result<int> recorded =
            IsDone(film.record, resumes && !film.record.film.overwrite) ? 0 : Run(film.record);
        if (!recorded)
        {
            return play.script.At(film.line, recorded.GetError());
        }
        if (*recorded != 0)
        {
            return recorded; // stopped by a signal
        }
    }
    return 0;
}

} // namespace

Result<int> Run(const PlayOptions& options)
{
    if (options.forThisRenderer && !options.accept)
    {
        return Requires("--for-this-renderer", "--accept");
    }
    ASSIGN_OR_RETURN(Script script, ReadScript(options.script));
    Play play;
    play.script = std::move(script);
    RETURN_IF_ERROR(Planner(play, options).Plan());
    ASSIGN_OR_RETURN(SceneSession session, OpenSession(play, play.look));
    if (options.check)
    {
        const Result<void> written =
            WriteOutput(play.script.file.string() + ": " + session.Title() + ", " +
                        Counted(play.script.actions.size(), "action") + ", " +
                        Counted(play.expectations.size(), "expectation") + ", " +
                        Counted(play.goldens.size() + play.stills.size(), "picture") + ", " +
                        Counted(play.films.size(), "film") + "\n");
        return written ? Result<int>(0) : written.GetError();
    }
    const Result<int> unmet = Expect(play, session);
    if (!unmet)
    {
        return unmet;
    }
    const Result<int> different = CompareGoldens(play, options);
    if (!different)
    {
        return different;
    }
    const Result<int> made = options.test ? 0 : MakeFiles(play, options.resume);
    if (!made || *made != 0)
    {
        return made;
    }
    return *unmet + *different == 0 ? 0 : static_cast<int>(ErrorKind::Different);
}

Command& Declare(Command& program, PlayOptions& play)
{
    Command& command =
        AddCommand(program, "play", "Play a script: check it, make films and pictures");
    AddPath(command, "SCRIPT", "", play.script, "Play this script", {".play"});
    AddPath(command, "--into", "DIR", play.into, "Write files to this folder (the current one)");
    AddFlag(command, "--check", play.check,
            "Check that the script can be played; simulate nothing");
    AddFlag(command, "--test", play.test,
            "Check expectations and compare with references; make no films or\n"
            "shots");
    AddFlag(command, "--accept", play.accept, "Accept the pictures as references");
    AddFlag(command, "--for-this-renderer", play.forThisRenderer,
            "Store the references for this renderer only; needs --accept");
    AddForce(command, play.force);
    AddFlag(command, "--resume", play.resume, "Continue stopped films, except pages");
    AddBackend(command, play.backend);
    command.notes = {
        {"A script:"},
        {"scene car --seed 3 --hz 120          open a scene or file, as `boxreel shot` does\n"
         "at 1s press d                        press a key; also release, tap\n"
         "at 2s grab 3.5,4                     press the mouse button at a point [m]\n"
         "at 2s to 3s drag 8,4                 move straight to a point; at once: move 8,4\n"
         "at 3s drop                           release the mouse button\n"
         "at step 240 bomb 0,30 5,-40          throw a bomb from a point at a velocity; or: bomb\n"
         "at 4s shift 100,0                    shift the origin\n"
         "at 4s set sub-steps 4                set up the solver; sleep and others: on or off\n"
         "at 4s click Solver/Sleep             click in the panels of `boxreel ui`; or type, hit\n"
         "at 0s camera 0,5,20                  set centre and height; moves on to the next one\n"
         "at 5s expect chassis.x > 10          check a condition, as --until; or: state HASH\n"
         "at 5s golden car/5s                  compare with the reference beside the script\n"
         "at 5s shot car.png --draw shapes     make a picture, with options of `boxreel shot`\n"
         "record car.mp4 --seconds 8           make a film, with options of `boxreel record`",
         NoteKind::Table},
        {"An action takes effect in the step that begins at its time. # begins a comment. Words\n"
         "with blanks need quotes (\"). Exit code 2: an expectation is false, or a picture\n"
         "differs from its reference."}};
    command.examples = {"boxreel play testbed/scripts/car.play",
                        "boxreel play walk.play --into films --force"};
    return command;
}

Result<void> Check(PlayOptions& options)
{
    if (options.script.empty())
    {
        return Missing("play", "SCRIPT", "boxreel play walk.play");
    }
    if (options.resume && options.force)
    {
        return Conflict("--resume", "--force");
    }
    if (options.check && options.accept)
    {
        return Conflict("--check", "--accept");
    }
    return {};
}

} // namespace boxreel
