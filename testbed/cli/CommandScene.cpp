// SPDX-License-Identifier: MIT
// `boxreel check` and `boxreel export`: scene files looked at and made.
#include "Commands.h"

#include <base/AtomicFile.h>
#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <rube/RubeExport.h>
#include <rube/RubeFile.h>
#include <rube/RubeScene.h>
#include <rube/RubeText.h>
#include <rube/RubeWriter.h>
#include <session/SceneSession.h>

namespace boxreel
{
namespace
{} // namespace

Result<int> RunCheck(const CheckOptions& options)
{
    std::vector<std::string> leftOut;
    ASSIGN_OR_RETURN(const std::unique_ptr<Scene> scene, LoadRubeScene(options.file, leftOut));
    ASSIGN_OR_RETURN(const std::vector<std::string> traps, TrapsOfFile(options.file));
    const RubeScene& content = *ContentOfFile(*scene);
    std::string text;
    for (const std::string& sentence : leftOut)
    {
        text += "left out: " + sentence + "\n";
    }
    for (const std::string& sentence : traps)
    {
        text += "note: " + sentence + "\n";
    }
    text += options.file.string() + ": " + std::to_string(content.bodies.size()) +
            (content.bodies.size() == 1 ? " body, " : " bodies, ") +
            Counted(content.joints.size(), "joint") + ", " +
            Counted(content.images.size(), "image") + ", " + Counted(traps.size(), "note") + ", " +
            std::to_string(leftOut.size()) + " left out\n";
    RETURN_IF_ERROR(WriteOutput(text));
    return leftOut.empty() ? 0 : static_cast<int>(ErrorKind::Different);
}

Result<int> RunExport(const ExportOptions& options)
{
    ASSIGN_OR_RETURN(SceneSource source, OpenScene(options.scene));
    ASSIGN_OR_RETURN(SceneSession session, SceneSession::Open(std::move(source), options.look));
    session.AdvanceTo(options.at ? StepAt(*options.at, session.StepsPerSecond()) : options.step);
    std::vector<std::string> leftOut;
    const RubeScene said = ExportScene(session.CurrentScene(), session.Steps(),
                                       float32(session.StepsPerSecond().ToDouble()), leftOut);
    const std::string text = WriteRubeText(said);
    if (const Result<RubeScene> back = ParseRubeScene(text, session.Title()); !back)
    {
        return Error{ErrorKind::Unusable,
                     "The scene cannot be a scene file at this moment: " + back.GetError().Text()};
    }
    for (const std::string& sentence : leftOut)
    {
        WriteMessage("boxreel: " + sentence);
    }
    const Result<void> written =
        options.output == "-" ? WriteOutput(text) : WriteWhole(options.output, text, options.force);
    return written ? Result<int>(0) : written.GetError();
}

} // namespace boxreel
