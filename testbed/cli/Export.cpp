// SPDX-License-Identifier: MIT
#include "Export.h"
#include "Declare.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <options/OptionNames.h>
#include <rube/RubeExport.h>
#include <rube/RubeFile.h>
#include <rube/RubeScene.h>
#include <rube/RubeText.h>
#include <rube/RubeWriter.h>
#include <session/SceneSession.h>

namespace boxreel
{
Result<int> Run(const ExportOptions& options)
{
    ASSIGN_OR_RETURN(SceneSource source, OpenScene(options.scene));
    ASSIGN_OR_RETURN(SceneSession session, SceneSession::Open(std::move(source), options.look));
    session.AdvanceTo(options.at ? StepAt(*options.at, session.StepsPerSecond())
                                 : options.step.value_or(0));
    RubeNotes leftOut;
    const RubeScene said = ExportScene(session.CurrentScene(), session.Steps(),
                                       float32(session.StepsPerSecond().ToDouble()), leftOut);
    const std::string text = WriteRubeText(said);
    if (const Result<RubeScene> back = ParseRubeScene(text, session.Title()); !back)
    {
        return Error{ErrorKind::Unusable, options.scene,
                     "cannot be exported at this moment: " + TextInOptions(back.GetError()),
                     "choose another --at"};
    }
    for (const RubeNote& part : leftOut)
    {
        WriteMessage("left out: " + part.Text());
    }
    const Result<void> written =
        options.output == "-" ? WriteOutput(text) : WriteWhole(options.output, text, options.force);
    return written ? Result<int>(0) : written.GetError();
}

Command& Declare(Command& program, ExportOptions& options)
{
    Command& command = AddCommand(program, "export", "Write a scene as a scene file");
    AddScene(command, options.scene);
    AddPath(command, "-o,--output", "FILE", options.output,
            "Write the scene file here: .json, or - for standard output", {".json"});
    AddForce(command, options.force);
    AddValue(command, "--at", "TIME", options.at, ParseDuration,
             "Export after this simulated time: 3s, 500ms, 2.5 (0s)");
    AddValue(command, "--step", "N", options.step, WholeBetween(0, 1'000'000'000),
             "Export after N steps instead");
    AddValue(command, "--hz", "RATE", options.look.simulation.stepsPerSecond,
             RatioBetween(1.0, 100000.0),
             "Set simulation steps per second (60; a scene file has its own)");
    AddValue(command, "--seed", "N", options.look.simulation.seed, WholeBetween(0, 0xffffffff),
             "Seed the scene's random numbers (1)");
    command.notes = {
        {"`boxreel record FILE` and the other commands restore bodies, shapes, joints and names\n"
         "bit-exactly. A scene file does not contain contact impulses, or what the scene's code\n"
         "does, such as steering and new bodies."}};
    command.examples = {"boxreel export pyramid -o pyramid.json",
                        "boxreel export bridge --at 2s -o sagging.json"};
    return command;
}

Result<void> Check(ExportOptions& options)
{
    if (options.scene.empty())
    {
        return Missing("export", "SCENE", "boxreel export pyramid -o pyramid.json");
    }
    if (options.output.empty())
    {
        return Missing("export", "-o FILE", "boxreel export pyramid -o pyramid.json");
    }
    if (options.output != "-" && options.output.extension() != ".json")
    {
        return Error{ErrorKind::Unusable, "-o " + options.output.string(), "unsupported extension",
                     "use .json, or - for standard output"};
    }
    if (options.at && options.step)
    {
        return Conflict("--at", "--step");
    }
    return {};
}

} // namespace boxreel
