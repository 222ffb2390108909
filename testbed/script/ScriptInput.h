// SPDX-License-Identifier: MIT
#pragma once

#include "Script.h"

#include <scenes/Scene.h>

#include <cstdint>
#include <string>
#include <vector>

/// What a script does to a scene, step by step. Which actions belong to a step hangs on the step
/// alone, so a simulation that goes on from a saved state gets the same ones.
namespace boxreel
{

class ScriptInput
{
public:
    ScriptInput() = default; ///< that does nothing

    /// Unusable, with file and line: a key that the scene does not answer to, a mouse that lets go
    /// of nothing.
    static Result<ScriptInput> Create(const Script& script, const Rational& stepsPerSecond,
                                      const Scene& scene);

    /// What is done before the step that begins after `step` steps.
    void Apply(Scene& scene, std::int64_t step) const;

private:
    struct Event
    {
        std::int64_t step = 0;
        ScriptAction action;  ///< a Drag is many moves here
        float32 share = 0.0f; ///< of the Drag's way, at the end of the step
    };

    Result<void> Add(const Script& script, const ScriptAction& action,
                     const Rational& stepsPerSecond);
    Result<void> FollowMouse(const Script& script);

    std::vector<Event> m_events; // by step, then by line
};

} // namespace boxreel
