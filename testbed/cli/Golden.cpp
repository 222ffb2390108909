// SPDX-License-Identifier: MIT
#include "Golden.h"
#include "Declare.h"
#include "GoldenReport.h"
#include "GoldenState.h"

#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/Terminal.h>
#include <session/GoldenScenes.h>

#include <algorithm>
#include <set>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

struct Folders
{
    fs::path references;
    fs::path output;
};

/// Returns the nearest parent folder that contains golden/references; empty if there is none.
fs::path FindCheckout()
{
    std::error_code error;
    fs::path folder = fs::current_path(error);
    while (!folder.empty() && !fs::is_directory(folder / "golden" / "references", error))
    {
        folder = folder == folder.parent_path() ? fs::path() : folder.parent_path();
    }
    return folder;
}

Result<Folders> ChooseFolders(const GoldenOptions& options)
{
    const fs::path checkout = FindCheckout();
    std::error_code error;
    if (options.references.empty() && checkout.empty())
    {
        return Error{ErrorKind::Unusable, "golden/references",
                     "not found in this folder or above it", "name the folder with --references"};
    }
    if (!options.references.empty() && !options.accept &&
        !fs::is_directory(options.references, error))
    {
        return Error{ErrorKind::Unusable, "--references " + options.references.string(),
                     "does not exist", "`boxreel golden accept --references` makes one"};
    }
    Folders folders;
    folders.references =
        options.references.empty() ? checkout / "golden" / "references" : options.references;
    folders.output = options.output.empty() ? DefaultGoldenOutput() : options.output;
    return folders;
}

Result<GoldenSelection> SelectFilm(const GoldenOptions& options)
{
    if (options.names.size() > 1)
    {
        return Error{ErrorKind::Unusable, Quoted(options.names[1]), "too many arguments",
                     "a film has one name"};
    }
    GoldenFilm film{options.film, "films/" + options.film.stem().string(), options.sheet};
    if (!options.names.empty())
    {
        film.name = options.names.front();
    }
    return GoldenSelection{.film = std::move(film)};
}

/// A moment that is named twice, by itself or with all of its scene, is looked at once.
void AddOnce(std::vector<GoldenSelection>& selections, const GoldenSelection& more)
{
    const auto covers = [](const GoldenSelection& a, const GoldenSelection& b) {
        return a.scene == b.scene && (a.moment.empty() || a.moment == b.moment);
    };
    if (std::none_of(selections.begin(), selections.end(),
                     [&](const GoldenSelection& known) { return covers(known, more); }))
    {
        std::erase_if(selections,
                      [&](const GoldenSelection& known) { return covers(more, known); });
        selections.push_back(more);
    }
}

Result<std::vector<GoldenSelection>> Select(const GoldenOptions& options)
{
    std::vector<GoldenSelection> selections;
    if (!options.film.empty())
    {
        const Result<GoldenSelection> film = SelectFilm(options);
        return film ? Result<std::vector<GoldenSelection>>(std::vector{*film})
                    : Result<std::vector<GoldenSelection>>(film.GetError());
    }
    const std::vector<std::string>& names = options.names;
    for (const std::string& name : names)
    {
        ASSIGN_OR_RETURN(const GoldenSelection selection, SelectGolden(name));
        AddOnce(selections, selection);
    }
    if (names.empty())
    {
        for (const SceneEntry& entry : AllScenes())
        {
            selections.push_back({.scene = &entry});
        }
    }
    return selections;
}

/// Returns a line if references of another renderer were compared with other limits; otherwise
/// empty.
std::string LimitsOfOthers(std::size_t moments, const CompareSettings& settings)
{
    const std::optional<CompareSettings> others = ForOtherRenderer(settings);
    return moments == 0 || !others
               ? ""
               : Counted(moments, "reference") +
                     " drawn by another renderer: " + DescribeLimits(*others) + "\n";
}

Result<int> Verify(const std::vector<GoldenSelection>& selections, const Folders& folders,
                   Renderer& renderer, const GoldenOptions& options)
{
    const CompareSettings settings = Effective(options.compare);
    const ReferenceStore store(folders.references, folders.output);
    std::size_t moments = 0;
    std::size_t failures = 0;
    std::size_t ofOthers = 0; // whose reference another renderer drew
    std::set<std::string> names;
    std::optional<Error> warning; // the first: where one file cannot be written, none can
    for (const GoldenSelection& selection : selections)
    {
        ASSIGN_OR_RETURN(const std::vector<GoldenVerdict> verdicts,
                         VerifyGolden(selection, store, renderer, settings));
        for (const GoldenVerdict& verdict : verdicts)
        {
            const bool isSame = verdict.status == GoldenStatus::Same;
            names.insert(verdict.name);
            warning = warning ? warning : verdict.warning;
            ++moments;
            failures += isSame ? 0 : 1;
            ofOthers += verdict.limits == LimitsChoice::OtherRenderer ? 1 : 0;
            RETURN_IF_ERROR(WriteOutput(isSame
                                            ? "same  " + verdict.name + "\n"
                                            : Red("FAIL", stdout) + "  " + verdict.Text() + "\n"));
        }
    }
    if (warning)
    {
        warning->problem += ", so reports do not list what passed";
        WriteMessage("boxreel: " + warning->Text());
    }
    const std::string what = Counted(moments, "moment");
    const std::string output = folders.output.string();
    const std::string named = options.output.empty() ? "" : " " + ShellQuoted(output);
    const std::string page =
        options.report.empty() ? "; `boxreel golden report" + named + "` makes a page of them" : "";
    const bool isOfOthersOnly = ofOthers > 0 && ofOthers == moments;
    const CompareSettings held = isOfOthersOnly ? *ForOtherRenderer(settings) : settings;
    RETURN_IF_ERROR(
        WriteOutput((failures == 0 ? what + ": all as approved (" + DescribeLimits(held) + ")\n"
                                   : what + ": " + std::to_string(failures) +
                                         " not as approved, see " + Quoted(output) + page + "\n") +
                    LimitsOfOthers(ofOthers, settings)));
    if (!options.report.empty())
    {
        GoldenReportOptions report;
        report.folders = {folders.output};
        report.output = options.report;
        report.backend = options.backend;
        RETURN_IF_ERROR(WriteGoldenReport(report, names));
    }
    return failures == 0 ? 0 : static_cast<int>(ErrorKind::Different);
}

Result<int> Accept(const std::vector<GoldenSelection>& selections, const Folders& folders,
                   const GoldenAcceptance& acceptance, Renderer& renderer)
{
    const ReferenceStore store(folders.references, folders.output);
    std::size_t moments = 0;
    std::size_t same = 0;
    for (const GoldenSelection& selection : selections)
    {
        ASSIGN_OR_RETURN(const std::vector<GoldenVerdict> accepted,
                         AcceptGolden(selection, store, renderer, acceptance));
        moments += accepted.size();
        for (const GoldenVerdict& verdict : accepted)
        {
            const bool isSame = verdict.status == GoldenStatus::Same;
            same += isSame ? 1 : 0;
            RETURN_IF_ERROR(WriteOutput(isSame ? "same  " + verdict.name + "\n"
                                               : "accepted  " + verdict.AcceptedText() + "\n"));
        }
    }
    RETURN_IF_ERROR(WriteOutput(
        Counted(moments, "moment") + " accepted in " + Quoted(folders.references.string()) +
        (same == 0 ? "" : ", " + std::to_string(same) + " of them as they were") + "\n"));
    return 0;
}

Result<int> VerifyAgainst(const std::filesystem::path& given,
                          const std::vector<GoldenSelection>& selections)
{
    ASSIGN_OR_RETURN(const fs::path program, FindOtherProgram(given));
    std::size_t failures = 0;
    for (const GoldenSelection& selection : selections)
    {
        ASSIGN_OR_RETURN(const std::string difference, CompareWith(program, selection));
        failures += difference.empty() ? 0 : 1;
        RETURN_IF_ERROR(WriteOutput(difference.empty()
                                        ? "same  " + SceneSlug(selection.scene->name) + "\n"
                                        : Red("FAIL", stdout) + "  " + difference + "\n"));
    }
    const std::string what = Counted(selections.size(), "scene");
    RETURN_IF_ERROR(
        WriteOutput(what + (failures == 0 ? ": each step as " + given.string() + " does it\n"
                                          : ": " + std::to_string(failures) + " not as " +
                                                given.string() + " does them\n")));
    return failures == 0 ? 0 : static_cast<int>(ErrorKind::Different);
}

} // namespace

fs::path DefaultGoldenOutput()
{
    const fs::path checkout = FindCheckout();
    return checkout.empty() ? "golden-output" : checkout / "build" / "golden-output";
}

Result<int> Run(const GoldenOptions& options)
{
    ASSIGN_OR_RETURN(const std::vector<GoldenSelection> selections, Select(options));
    if (!options.against.empty() && !options.film.empty())
    {
        return Conflict("--against", "--film");
    }
    if (!options.film.empty() && !options.compare.ignoredBodies.empty())
    {
        return Error{ErrorKind::Unusable, "--ignore-body", "cannot be used with --film",
                     "ignore rectangles with --ignore"};
    }
    const CompareSettings limits = Effective(options.compare);
    if (!options.against.empty() && limits.preset != CompareSettings().preset)
    {
        return Conflict("--against", "--preset");
    }
    if (!options.against.empty() && !limits.options.empty())
    {
        return Conflict("--against", limits.options.front());
    }
    if (!options.against.empty() && !options.report.empty())
    {
        return Error{ErrorKind::Unusable, "--report", "cannot be used with --against",
                     "verify first, then run `boxreel golden report --against " +
                         options.against.string() + "`"};
    }
    if (!options.against.empty())
    {
        return VerifyAgainst(options.against, selections);
    }
    if (!options.report.empty())
    {
        RETURN_IF_ERROR(CheckGoldenReportPath(options.report, false));
    }
    ASSIGN_OR_RETURN(const Folders folders, ChooseFolders(options));
    ASSIGN_OR_RETURN(Renderer renderer, CreateGoldenRenderer(options.backend));
    return options.accept ? Accept(selections, folders, options.acceptance, renderer)
                          : Verify(selections, folders, renderer, options);
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

void DeclareGoldenFilm(Command& action, GoldenOptions& golden)
{
    AddPath(
        action, "--film", "FILE", golden.film,
        "Compare the contact sheet of a film instead of scenes;\nNAMES is its name (films/FILE)",
        VideoEnds());
    AddValue(action, "--every", "STEPS", golden.sheet.every, WholeBetween(1, 1'000'000),
             "Set the steps between two pictures of the sheet (30)");
    AddValue(
        action, "--hz", "RATE", golden.sheet.stepsPerSecond,
        [](const std::string& option, const std::string& text) -> Result<double> {
            const Result<Rational> rate = RatioBetween(1.0, 100000.0)(option, text);
            return rate ? Result<double>(rate->ToDouble()) : Result<double>(rate.GetError());
        },
        "Set the simulation steps per second of the film (60)");
}

} // namespace

Command& Declare(Command& program, GoldenOptions& golden)
{
    Command& command = AddCommand(program, "golden", "Compare scenes with approved references");
    command.examples = {"boxreel golden verify",
                        "boxreel golden verify pyramid bridge --output /tmp/failures",
                        "boxreel golden accept pyramid"};
    Command& verify =
        AddCommand(command, "verify", "Simulate, draw and compare; write what differs");
    Command& accept = AddCommand(command, "accept", "Accept the current pictures as references");
    for (Command* action : {&verify, &accept})
    {
        const auto readNames = [&golden](const std::vector<std::string>& names) {
            golden.names = names;
            return Result<void>();
        };
        AddTexts(*action, "NAMES", "", readNames,
                 "Select scenes or moments, such as pyramid or pyramid/2s (all)")
            .Completes({Completion::Kind::Scenes, {}});
        AddPath(*action, "--references", "DIR", golden.references,
                "Use this folder of references (golden/references)");
        AddPath(*action, "--output", "DIR", golden.output,
                "Write what differs to this folder (build/golden-output, or\n"
                "./golden-output)");
        AddBackend(*action, golden.backend);
        DeclareGoldenFilm(*action, golden);
        action->finish = [action, &golden]() -> Result<void> {
            for (const char* option : {"--every", "--hz"})
            {
                if (action->WasGiven(option) && golden.film.empty())
                {
                    return Requires(option, "--film");
                }
            }
            golden.accept = action->Name() == "accept";
            return {};
        };
    }
    AddCompare(verify, golden.compare,
               "cross-machine if another renderer drew the\nreference, otherwise same-machine");
    AddIgnoredBodies(verify, golden.compare);
    verify.notes = {
        {"Exit code 0: all match, 2: something differs or has no reference.\n"
         "For --against, `git worktree add ../before HEAD~1` checks out an older version; its\n"
         "script ../before/boxreel builds it when it is run."}};
    verify.examples = {"boxreel golden verify",
                       "boxreel golden verify pyramid --output /tmp/failures",
                       "boxreel golden verify --report report.html",
                       "boxreel golden verify pyramid --against ../before/boxreel",
                       "boxreel golden verify menu --film menu.mp4 --preset cross-machine"};
    accept.notes = {
        {"Look at the pictures before you commit them. Say in the commit why they changed."}};
    accept.examples = {"boxreel golden accept", "boxreel golden accept pyramid bridge",
                       "boxreel golden accept --only missing",
                       "boxreel golden accept menu --film menu.mp4"};
    AddPath(verify, "--against", "FILE", golden.against,
            "Compare the state of each step with another build of\n"
            "boxreel instead of with the references");
    AddValue(accept, "--only", "WHICH", golden.acceptance.only, GoldenFilterChoice(),
             "Accept all, changed or missing references (all)");
    AddFlag(accept, "--for-this-renderer", golden.acceptance.forThisRenderer,
            "Store the references for this renderer only");
    AddPath(verify, "--report", "FILE", golden.report, "Write an HTML report of the results",
            {".html"});
    return command;
}

} // namespace boxreel
