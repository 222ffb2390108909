// SPDX-License-Identifier: MIT
#include "GoldenState.h"
#include "ChildProcess.h"
#include "Declare.h"
#include "GoldenState.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <options/OptionNames.h>

namespace boxreel
{
namespace
{

std::string StateText(const GoldenRun& run)
{
    return run.stateHash + "\n" + ToText(run.state);
}

/// A hundred times the size of the longest trace; enough time for a scene in a debug build.
constexpr ChildBounds kAgainst{64u << 20, 300.0};

/// The states of a scene in another program.
class OtherProgram
{
public:
    OtherProgram(std::filesystem::path program, std::string scene)
        : m_program(std::move(program)), m_scene(std::move(scene))
    {}

    Result<StateTrace> Trace(std::int64_t step) const
    {
        ASSIGN_OR_RETURN(const std::string text, Ask({"--trace", "--step", std::to_string(step)}));
        Result<StateTrace> trace = ParseStateTrace(text);
        return trace ? std::move(trace) : Result<StateTrace>(Odd(trace.GetError()));
    }

    Result<WorldState> State(std::int64_t step) const
    {
        ASSIGN_OR_RETURN(const std::string text, Ask({"--step", std::to_string(step)}));
        const std::size_t hashEnd = std::min(text.find('\n'), text.size() - 1) + 1;
        Result<WorldState> state = ParseWorldState(std::string_view(text).substr(hashEnd));
        return state ? std::move(state) : Result<WorldState>(Odd(state.GetError()));
    }

private:
    Result<std::string> Ask(std::vector<std::string> more) const
    {
        more.insert(more.begin(), {"golden", "state", m_scene});
        Result<std::string> text = OutputOf(m_program, more, kAgainst);
        if (!text)
        {
            return Error{ErrorKind::Unusable, "--against " + m_program.string(),
                         text.GetError().problem, "give another build of boxreel"};
        }
        if (text->empty())
        {
            return Odd({ErrorKind::Unusable, "no output"});
        }
        return text;
    }

    Error Odd(const Error& error) const
    {
        return Error{ErrorKind::Unusable, "--against " + m_program.string(),
                     "did not print scene states (" + TextInOptions(error) + ")",
                     "give another build of boxreel"};
    }

    std::filesystem::path m_program;
    std::string m_scene;
};

} // namespace

Result<std::filesystem::path> FindOtherProgram(const std::filesystem::path& program)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(program, ignored))
    {
        const bool isFolder = std::filesystem::is_directory(program, ignored);
        return Error{ErrorKind::Unusable, "--against " + program.string(),
                     isFolder ? "is a folder" : "does not exist",
                     "name the program of another build, such as ../before/boxreel"};
    }
    // A name without a folder would be looked for along PATH, where another program may have it.
    return std::filesystem::absolute(program);
}

Result<std::string> CompareWith(const std::filesystem::path& program,
                                const GoldenSelection& selection)
{
    const std::string scene = SceneSlug(selection.scene->name);
    ASSIGN_OR_RETURN(const GoldenRun ours, SimulateGolden(selection));
    const OtherProgram other(program, scene);
    const std::int64_t last = ours.trace.steps.empty() ? 0 : ours.trace.steps.back().step;
    ASSIGN_OR_RETURN(const StateTrace theirs, other.Trace(last));
    const std::optional<TraceDifference> parted = FirstDifference(theirs, ours.trace);
    if (!parted)
    {
        return std::string();
    }
    if (parted->isOfOne)
    {
        return scene + ": " + program.string() + " makes other steps than this program, " +
               Describe(*parted) + ".";
    }
    const Result<WorldState> before = other.State(parted->step);
    const Result<GoldenRun> now = SimulateGolden(selection, parted->step);
    if (!before || !now)
    {
        return !before ? before.GetError() : now.GetError();
    }
    return scene + ": differs from " + program.string() + " " + Describe(*parted) + " (" +
           Describe(DifferenceOf(*before, now->state)) + ").";
}

Result<int> Run(const GoldenStateOptions& options)
{
    ASSIGN_OR_RETURN(const GoldenSelection selection, SelectGolden(options.scene));
    ASSIGN_OR_RETURN(const GoldenRun run, SimulateGolden(selection, options.step));
    const Result<void> written = WriteOutput(options.trace ? ToText(run.trace) : StateText(run));
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

Command& Declare(Command& program, GoldenStateOptions& options)
{
    Command& command = AddCommand(Below(program, "golden"), "state",
                                  "Print a scene's state at a step, body by body");
    AddName(command, "SCENE", options.scene, "Simulate this scene of `boxreel list`")
        .Completes({Completion::Kind::Scenes, {}});
    AddValue(command, "--step", "N", options.step, WholeBetween(0, 1'000'000),
             "Print the state after N steps (300)");
    AddFlag(command, "--trace", options.trace, "Print the hash of every step instead");
    command.notes = {
        {"Prints the hash, then one body per line: number, x, y, angle and, if it moves,\n"
         "velocity x, y, angular. With --trace, prints one step per line: number, hash, one\n"
         "digit per body."}};
    command.examples = {"boxreel golden state pyramid --step 120",
                        "boxreel golden state car --trace --step 60"};
    return command;
}

Result<void> Check(GoldenStateOptions& options)
{
    return options.scene.empty() ? Missing("golden state", "SCENE", "boxreel golden state pyramid")
                                 : Result<void>();
}

} // namespace boxreel
