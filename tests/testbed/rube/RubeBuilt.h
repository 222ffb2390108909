// SPDX-License-Identifier: MIT
#pragma once

#include <rube/RubeBuilder.h>
#include <rube/RubeText.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// For tests of what scene files become.
namespace boxreel
{

/// A world built from a text.
struct Built
{
    explicit Built(const std::string& text) : world(b2Vec2(0.0f, -10.0f))
    {
        const Result<RubeScene> scene = ParseRubeScene(text, "scene.json");
        if (scene)
        {
            BuildRubeScene(*scene, world, leftOut);
        }
        else
        {
            ADD_FAILURE() << scene.GetError().Text();
        }
    }

    /// The parts that are left out.
    std::vector<std::string> Missing() const
    {
        std::vector<std::string> parts;
        for (const RubeNote& note : leftOut)
        {
            parts.push_back(note.part);
        }
        return parts;
    }

    b2World world;
    RubeNotes leftOut;
};

} // namespace boxreel
