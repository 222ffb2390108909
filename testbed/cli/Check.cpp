// SPDX-License-Identifier: MIT
#include "Check.h"
#include "Declare.h"

#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <rube/RubeFile.h>
#include <rube/RubeNames.h>
#include <rube/RubeScene.h>

namespace boxreel
{
Result<int> Run(const CheckOptions& options)
{
    RubeNotes leftOut;
    ASSIGN_OR_RETURN(const std::unique_ptr<Scene> scene, LoadRubeScene(options.file, leftOut));
    ASSIGN_OR_RETURN(const RubeNotes traps, TrapsOfFile(options.file));
    const RubeScene& content = *ContentOfFile(*scene);
    std::string text;
    for (const RubeNote& part : leftOut)
    {
        text += "left out: " + part.Text() + "\n";
    }
    for (const RubeNote& note : traps)
    {
        text += "note: " + note.Text() + "\n";
    }
    text += options.file.string() + ": " + Counted(content.bodies.size(), "body") + ", " +
            Counted(content.joints.size(), "joint") + ", " +
            Counted(content.images.size(), "image") + ", " + Counted(traps.size(), "note") + ", " +
            std::to_string(leftOut.size()) + " left out\n";
    RETURN_IF_ERROR(WriteOutput(text));
    return leftOut.empty() ? 0 : static_cast<int>(ErrorKind::Different);
}

Result<void> Check(CheckOptions& options)
{
    return options.file.empty() ? Missing("check", "FILE", "boxreel check machine.json")
                                : Result<void>();
}

Command& Declare(Command& program, CheckOptions& options)
{
    Command& command =
        AddCommand(program, "check", "List the parts of a scene file that cannot be built");
    AddPath(command, "FILE", "", options.file, "Check this R.U.B.E. .json file", {".json"});
    command.notes = {
        {"Lists each part that is left out, with the reason, and each default of the format that\n"
         "differs from the engine's. Exit code 0: all parts can be built, 2: parts are left out,\n"
         "1: not a scene file."}};
    command.examples = {"boxreel check machine.json"};
    return command;
}

} // namespace boxreel
