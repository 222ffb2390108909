// SPDX-License-Identifier: MIT
#include "SceneFileRound.h"

#include <golden/StateHash.h>
#include <rube/RubeExport.h>
#include <rube/RubeFile.h>
#include <rube/RubeScene.h>
#include <rube/RubeText.h>
#include <rube/RubeTraps.h>
#include <rube/RubeWriter.h>

#include <algorithm>

namespace fuzz
{

namespace
{

using namespace boxreel;

constexpr char kSource[] = "scene.json"; ///< what messages call the text
constexpr std::size_t kLongest = 700;    ///< of a line: two names, a path and reasons
constexpr int kSteps = 3;

/// True if printable and of limited length.
bool IsLine(const std::string& text)
{
    const bool isPrintable = std::none_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    });
    return isPrintable && text.size() <= kLongest;
}

std::string WhyBadRefusal(const Error& error)
{
    if (error.kind != ErrorKind::Unusable || !error.culprit.Text().starts_with(kSource))
    {
        return "the refusal does not blame the file: " + error.Text();
    }
    return IsLine(error.Text()) ? "" : "this is not a line: " + error.Text();
}

bool IsFinite(const b2World& world)
{
    for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext())
    {
        if (!body->GetPosition().IsValid() || !b2IsValid(body->GetAngle()) ||
            !body->GetLinearVelocity().IsValid() || !b2IsValid(body->GetAngularVelocity()))
        {
            return false;
        }
    }
    return true;
}

/// A mouse joint's point is in the world in a file and in its body in the engine: it comes back
/// rounded.
bool IsExact(const b2World& world)
{
    for (const b2Joint* joint = world.GetJointList(); joint != nullptr; joint = joint->GetNext())
    {
        if (joint->GetType() == e_mouseJoint)
        {
            return false;
        }
    }
    return true;
}

std::string Export(Scene& scene)
{
    const StepSettings steps = scene.PreferredSteps();
    RubeNotes leftOut;
    return WriteRubeText(ExportScene(scene, steps, ContentOfFile(scene)->stepsPerSecond, leftOut));
}

/// Steps as the file requests, but with fewer iterations, to save time.
void Step(Scene& scene)
{
    StepSettings steps = scene.PreferredSteps();
    steps.velocityIterations = std::min(steps.velocityIterations, 8);
    steps.positionIterations = std::min(steps.positionIterations, 3);
    scene.Step(steps);
}

/// Compares a scene with the scene of its export, after no step and after some. The scene must not
/// have been stepped before, because a file does not contain the state of contacts and joints.
std::string WhyDifferent(Scene& scene, const std::string& exported, int steps)
{
    RubeNotes leftOut;
    const Result<std::unique_ptr<Scene>> back = SceneOfText(exported, kSource, leftOut);
    if (!back)
    {
        return "its export is refused: " + back.GetError().Text();
    }
    if (!leftOut.empty())
    {
        return "of its export is left out: " + leftOut.front().Text();
    }
    if (!IsExact(scene.World()))
    {
        return "";
    }
    if (const std::string again = Export(**back); again != exported)
    {
        return "its export is\n" + exported + "and the export of that is\n" + again;
    }
    for (int i = 0; i < steps; ++i)
    {
        Step(scene);
        Step(**back);
    }
    return StateHash((*back)->World()) == StateHash(scene.World())
               ? ""
               : "its export is in another state after " + std::to_string(steps) + " steps";
}

} // namespace

std::string WhyWrong(const std::string& text)
{
    RubeNotes leftOut;
    const Result<std::unique_ptr<Scene>> loaded = SceneOfText(text, kSource, leftOut);
    const Result<RubeNotes> traps = RubeTraps(text, kSource);
    if (!loaded)
    {
        return WhyBadRefusal(loaded.GetError());
    }
    if (!traps)
    {
        return "it is built but its traps are refused: " + traps.GetError().Text();
    }
    for (const RubeNotes& notes : {leftOut, *traps})
    {
        for (const RubeNote& note : notes)
        {
            if (!IsLine(note.Text()))
            {
                return "this is not a line: " + note.Text();
            }
        }
    }
    Scene& scene = **loaded;
    if (const std::string why = WhyDifferent(scene, Export(scene), kSteps); !why.empty())
    {
        return why;
    }
    if (!IsFinite(scene.World()))
    {
        return "its world has numbers that are not finite after some steps";
    }
    // Bodies beyond the format's limits may be refused by now, as in `boxreel export`.
    const std::string later = Export(scene);
    return ParseRubeScene(later, kSource) ? WhyDifferent(scene, later, 0) : "";
}

} // namespace fuzz
