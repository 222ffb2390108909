// SPDX-License-Identifier: MIT
#pragma once

#include "Script.h"

#include <scenes/Scene.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// Applies a script to a scene, step by step. The actions of a step depend only on its number, so a
/// simulation that continues from a saved state gets the same ones.
namespace boxreel
{

/// Performs the action on the scene immediately. A Drag moves the mouse to its point. Ignores
/// actions for panels.
void Perform(const ScriptAction& action, Scene& scene, StepSettings& steps);

class ScriptInput
{
public:
    ScriptInput() = default; ///< that does nothing

    /// Unusable, with file and line: a key that the scene does not answer to, a mouse that lets go
    /// of nothing.
    static Result<ScriptInput> Create(const Script& script, const Rational& stepsPerSecond,
                                      const Scene& scene);

    /// Performs the actions before the step that begins after `step` steps, except those for
    /// panels.
    void Apply(Scene& scene, StepSettings& steps, std::int64_t step) const;

    /// Returns the actions for panels before that step.
    std::vector<ScriptAction> ForPanels(std::int64_t step) const;

private:
    struct Event
    {
        std::int64_t step = 0;
        ScriptAction action;  ///< a Drag is many moves here
        float32 share = 0.0f; ///< of the Drag's path, at the end of the step
    };

    Result<void> Add(const Script& script, const ScriptAction& action,
                     const Rational& stepsPerSecond);
    Result<void> FollowMouse(const Script& script);
    std::span<const Event> At(std::int64_t step) const;

    std::vector<Event> m_events; // by step, then by line
};

} // namespace boxreel
