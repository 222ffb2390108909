// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <recorder/FrameClock.h>
#include <script/Script.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class b2World;

/// The user's actions on a scene since it began, as a script that repeats them.
namespace boxreel
{

class WorkbenchLog
{
public:
    /// Begins a scene and clears the log.
    void Begin(std::string scene, std::vector<std::string> options, const Rational& stepsPerSecond);

    /// Is about to be done to `world`, before the step that begins after `step` steps.
    void Add(ScriptAction action, std::int64_t step, const b2World& world);
    /// The same for a picture or a film, whose options say its moments.
    void Add(ScriptProduct product) { m_script.products.push_back(std::move(product)); }

    /// Logs the view at a step; `isChosen`: true if the user has moved the view.
    void See(const Camera& view, std::int64_t step, bool isChosen);

    /// Returns the script up to `step`, which expects the world's state at the end of that step.
    /// Later actions appear only in the next step.
    std::string Text(std::int64_t step, const b2World& world) const;

private:
    struct Seen
    {
        std::int64_t step = 0;
        double x = 0.0; ///< [m]
        double y = 0.0;
        double height = 0.0;
    };
    std::vector<Seen> Keys() const;

    Script m_script;
    Rational m_stepsPerSecond{60, 1};
    std::vector<Seen> m_seen; // where it changed, with the step before
    bool m_isChosen = false;
    std::int64_t m_lastStep = -1; // before which something was done …
    std::string m_stateBefore;    // … and the world's state then
};

} // namespace boxreel
