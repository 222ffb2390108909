// SPDX-License-Identifier: MIT
#include "ScriptWriter.h"
#include "SolverSettings.h"

#include "ScriptWords.h"

#include <cstdio>
#include <utility>

namespace boxreel
{
namespace
{

using Kind = ScriptAction::Kind;

std::string TextOf(const ScriptMoment& moment)
{
    if (const auto* step = std::get_if<std::int64_t>(&moment.when))
    {
        return "step " + std::to_string(*step);
    }
    const std::vector<std::string> option = moment.AsOption(); // "--at", "1.5s"
    return option.back();
}

std::string PairOf(const b2Vec2& pair)
{
    char text[80];
    std::snprintf(text, sizeof text, "%.9g,%.9g", double(pair.x), double(pair.y));
    return text;
}

/// Returns the words after the moment.
std::vector<std::string> ActionWords(const ScriptAction& action)
{
    switch (action.kind)
    {
    case Kind::Press:
        return {"press", std::string(1, action.key)};
    case Kind::Release:
        return {"release", std::string(1, action.key)};
    case Kind::Grab:
        return {"grab", PairOf(action.point)};
    case Kind::Move:
        return {"move", PairOf(action.point)};
    case Kind::Drag:
        return {"drag", PairOf(action.point)};
    case Kind::Drop:
        return {"drop"};
    case Kind::Bomb:
        return {"bomb"};
    case Kind::Sling:
        return {"bomb", PairOf(action.point), PairOf(action.velocity)};
    case Kind::Shift:
        return {"shift", PairOf(action.point)};
    case Kind::Set:
        return {"set", action.name, SettingText(action.name, action.value)};
    case Kind::Click:
        return {"click", action.name};
    case Kind::Type:
        return {"type", action.name};
    case Kind::Hit:
        break;
    }
    return {"hit", action.name};
}

std::string ActionLine(const ScriptAction& action)
{
    const std::string until =
        action.kind == Kind::Drag ? " to " + TextOf(action.until) : std::string();
    return "at " + TextOf(action.at) + until + " " + LineOf(ActionWords(action)) + "\n";
}

std::string ProductLine(const ScriptProduct& product)
{
    using Made = ScriptProduct::Kind;
    std::vector<std::string> words{product.name};
    words.insert(words.end(), product.options.begin(), product.options.end());
    switch (product.kind)
    {
    case Made::Expect:
        return "at " + TextOf(product.at) + " expect " + product.name + "\n";
    case ScriptProduct::Kind::ExpectState:
        return "at " + TextOf(product.at) + " expect state " + product.name + "\n";
    case Made::Golden:
        return "at " + TextOf(product.at) + " golden " + LineOf(words) + "\n";
    case Made::Shot:
        return "shot " + LineOf(words) + "\n"; // its moment is among its options
    case Made::Record:
        break;
    }
    return "record " + LineOf(words) + "\n";
}

} // namespace

std::string WriteScript(const Script& script)
{
    std::vector<std::string> scene{"scene", script.scene};
    scene.insert(scene.end(), script.options.begin(), script.options.end());
    std::string text = LineOf(scene) + "\n";
    for (const auto& [time, view] : script.camera)
    {
        text.append("at ").append(time).append(" camera ").append(view).append("\n");
    }
    for (const ScriptAction& action : script.actions)
    {
        text += ActionLine(action);
    }
    for (const ScriptProduct& product : script.products)
    {
        text += ProductLine(product);
    }
    return text;
}

} // namespace boxreel
