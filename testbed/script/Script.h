// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>
#include <base/Result.h>
#include <options/Values.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// A parsed script: a scene, the actions and their times, the outputs, and the expectations. The
/// same file serves as a test, a film and a figure. docs/scripts.md has the format. Reading a
/// script opens only its file.
namespace boxreel
{

/// A time or the number of a step. The scene's rate converts a time to a step.
struct ScriptMoment
{
    std::variant<Duration, std::int64_t> when;

    /// The last step at or before it.
    std::int64_t Step(const Rational& stepsPerSecond) const;
    /// Returns the option with this time: {"--at", "1.5s"} or {"--step", "90"}.
    std::vector<std::string> AsOption() const;
};

/// A keyboard or mouse action of a person, before the step that begins at `at`.
struct ScriptAction
{
    enum class Kind
    {
        Press,   ///< a key
        Release, ///< a key
        Grab,    ///< the mouse's button goes down
        Move,    ///< the mouse, at once
        Drag,    ///< the mouse, straight to `point` until `until`
        Drop,    ///< the button goes up
        Bomb,    ///< from somewhere above
        Sling,   ///< a bomb from `point` with `velocity`
        Shift,   ///< of the origin, to `point`
        Set,     ///< a setting of the solver, `name`, to `value`
        Click,   ///< on a control of the panels, `name`
        Type,    ///< letters into the panels, `name`
        Hit,     ///< a key that the panels or the window know, `name`: "ctrl+o"
    };
    Kind kind = Kind::Press;
    int line = 0;
    ScriptMoment at;
    ScriptMoment until;          ///< of Drag
    char key = 0;                ///< of Press and Release
    b2Vec2 point{0.0f, 0.0f};    ///< [m]
    b2Vec2 velocity{0.0f, 0.0f}; ///< of Sling [m/s]
    std::string name{};          ///< of Set, Click, Type and Hit
    int value = 0;               ///< of Set

    /// It is done with the panels, not with the scene.
    bool IsForPanels() const
    {
        return kind == Kind::Click || kind == Kind::Type || kind == Kind::Hit;
    }
};

/// An expectation or an output of a script.
struct ScriptProduct
{
    enum class Kind
    {
        Expect,
        ExpectState,
        Shot,
        Golden,
        Record,
    };
    Kind kind = Kind::Expect;
    int line = 0;
    ScriptMoment at;                  ///< of Expect, ExpectState and Golden
    std::string name;                 ///< condition, state hash, file or reference name
    std::vector<std::string> options; ///< as the command of that name takes them
};

struct Script
{
    std::filesystem::path file;
    int sceneLine = 0;
    std::string scene;
    std::vector<std::string> options; ///< of the scene, as `boxreel shot` takes them
    std::vector<std::pair<std::string, std::string>> camera; ///< times and views, from one to the
                                                             ///< next
    std::vector<ScriptAction> actions;
    std::string actionText; ///< the same for the same actions
    std::vector<ScriptProduct> products;

    bool ThrowsBombs() const;
    bool UsesPanels() const;

    /// The options of the scene, and the camera's path.
    std::vector<std::string> SceneOptions() const;

    /// AtLine of its file.
    Error At(int line, const Error& error) const;
};

/// The error with "walk.play:12: " in front of its culprit.
Error AtLine(const std::filesystem::path& file, int line, const Error& error);

/// An Error (Unusable) contains file, line, problem and remedy. Failed: the file cannot be read.
Result<Script> ReadScript(const std::filesystem::path& file);

/// `file`: for messages.
Result<Script> ParseScript(const std::string& text, const std::filesystem::path& file);

} // namespace boxreel
