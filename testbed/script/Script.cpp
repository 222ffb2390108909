// SPDX-License-Identifier: MIT
#include "Script.h"
#include "ScriptWords.h"
#include "SolverSettings.h"

#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Quoting.h>
#include <base/ReadWhole.h>
#include <base/Unusable.h>
#include <base/Words.h>
#include <options/Values.h>
#include <options/ViewChoice.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace boxreel
{
namespace
{

constexpr std::int64_t kMaxSteps = 1'000'000'000;
constexpr std::uintmax_t kMaxBytes = 16'000'000; // of a script: many more than a person would do

/// "1.5s", exactly.
std::string TextOf(Duration time)
{
    std::string decimals = std::to_string(time.nanoseconds % 1'000'000'000 + 1'000'000'000);
    return std::to_string(time.nanoseconds / 1'000'000'000) + "." + decimals.substr(1) + "s";
}

/// Words of a line, taken one after the other.
class Words
{
public:
    explicit Words(std::vector<std::string> words) : m_words(std::move(words)) {}

    bool IsEmpty() const { return m_next == m_words.size(); }
    bool NextIs(const char* word) const { return !IsEmpty() && m_words[m_next] == word; }
    std::string Take() { return m_words[m_next++]; }
    std::vector<std::string> TakeRest()
    {
        std::vector<std::string> rest(m_words.begin() + std::ptrdiff_t(m_next), m_words.end());
        m_next = m_words.size();
        return rest;
    }

private:
    std::vector<std::string> m_words;
    std::size_t m_next = 0;
};

/// "1.5s", "500ms", "2.5" or "step 90".
Result<ScriptMoment> TakeMoment(Words& words, const std::string& after)
{
    if (words.IsEmpty())
    {
        return Unusable(Quoted(after), "requires a time", "for example 1.5s or step 90");
    }
    if (words.NextIs("step"))
    {
        words.Take();
        if (words.IsEmpty())
        {
            return Unusable(Quoted("step"), "requires a number", "for example step 90");
        }
        const Result<std::int64_t> step = ParseWhole("step", words.Take(), 0, kMaxSteps);
        return step ? Result<ScriptMoment>(ScriptMoment{*step}) : step.GetError();
    }
    const Result<Duration> time = ParseDuration(after, words.Take());
    return time ? Result<ScriptMoment>(ScriptMoment{*time}) : time.GetError();
}

/// "3.5,-4": a point [m] or a velocity [m/s].
Result<b2Vec2> TakePair(Words& words, const std::string& verb, const char* example)
{
    const Error wrong =
        Unusable(Quoted(verb), "requires X,Y", "for example " + verb + " " + example);
    if (words.IsEmpty())
    {
        return wrong;
    }
    const std::string text = words.Take();
    const std::vector<std::string> parts = SplitAt(',', text);
    if (parts.size() != 2)
    {
        return wrong;
    }
    const Result<double> x = ParseNumber(verb, parts[0]);
    const Result<double> y = ParseNumber(verb, parts[1]);
    // Beyond it, single precision cannot resolve a body.
    const auto isUsable = [](const Result<double>& number) {
        return number && *number >= -1e9 && *number <= 1e9;
    };
    if (!isUsable(x) || !isUsable(y))
    {
        return wrong;
    }
    return b2Vec2(static_cast<float32>(*x), static_cast<float32>(*y));
}

class Parser
{
public:
    explicit Parser(const std::filesystem::path& file) { m_script.file = file; }

    Result<void> Take(int line, Words words);
    Result<Script> Finish();

private:
    Result<void> TakeLine(Words& words);
    Result<void> TakeScene(Words& words);
    Result<void> TakeAt(Words& words);
    Result<void> TakeKey(const std::string& verb, ScriptMoment at, Words& words);
    Result<void> TakeMouse(const std::string& verb, ScriptAction action, Words& words);
    Result<void> TakeBomb(ScriptAction action, Words& words);
    Result<void> TakeSetting(ScriptAction action, Words& words);
    Result<void> TakePanels(const std::string& verb, ScriptAction action, Words& words);
    Result<void> TakeProduct(const std::string& verb, std::optional<ScriptMoment> at, Words& words);
    Result<void> TakeExpectation(ScriptMoment at, Words& words);
    Result<void> TakeCamera(const ScriptMoment& at, Words& words);
    static Result<void> CheckEnd(const Words& words, const std::string& verb);

    Script m_script;
    int m_line = 0;
    Duration m_lastCamera;
};

Result<void> Parser::CheckEnd(const Words& words, const std::string& verb)
{
    Words rest = words;
    return rest.IsEmpty()
               ? Result<void>()
               : Unusable(Quoted(rest.Take()), "too many arguments after " + Quoted(verb));
}

Result<void> Parser::TakeScene(Words& words)
{
    if (!m_script.scene.empty())
    {
        return Unusable(Quoted("scene"),
                        "the scene is already set in line " + std::to_string(m_script.sceneLine),
                        "use one scene per script");
    }
    if (words.IsEmpty())
    {
        return Unusable(Quoted("scene"), "requires a name or a file", "for example scene dominos");
    }
    m_script.scene = words.Take();
    m_script.sceneLine = m_line;
    m_script.options = words.TakeRest();
    return {};
}

Result<void> Parser::TakeKey(const std::string& verb, ScriptMoment at, Words& words)
{
    const std::string key = words.IsEmpty() ? "" : words.Take();
    if (key.size() != 1)
    {
        return Unusable(Quoted(verb), "requires a key", "for example " + verb + " d");
    }
    ScriptAction action;
    action.line = m_line;
    action.at = at;
    action.key = key.front();
    if (verb != "release")
    {
        action.kind = ScriptAction::Kind::Press;
        m_script.actions.push_back(action);
    }
    if (verb != "press")
    {
        action.kind = ScriptAction::Kind::Release;
        m_script.actions.push_back(action);
    }
    return CheckEnd(words, verb);
}

Result<void> Parser::TakeMouse(const std::string& verb, ScriptAction action, Words& words)
{
    using Kind = ScriptAction::Kind;
    action.kind = verb == "grab"    ? Kind::Grab
                  : verb == "move"  ? Kind::Move
                  : verb == "drag"  ? Kind::Drag
                  : verb == "shift" ? Kind::Shift
                                    : Kind::Drop;
    if (action.kind != Kind::Drop)
    {
        ASSIGN_OR_RETURN(const b2Vec2 point, TakePair(words, verb, "3.5,4"));
        action.point = point;
    }
    m_script.actions.push_back(action);
    return CheckEnd(words, verb);
}

Result<void> Parser::TakeBomb(ScriptAction action, Words& words)
{
    action.kind = ScriptAction::Kind::Bomb;
    if (!words.IsEmpty())
    {
        ASSIGN_OR_RETURN(const b2Vec2 place, TakePair(words, "bomb", "0,30 5,-40"));
        const Result<b2Vec2> velocity = TakePair(words, "bomb", "0,30 5,-40");
        if (!velocity)
        {
            return Unusable(Quoted("bomb"), "requires a place and a velocity, or neither",
                            "for example bomb 0,30 5,-40");
        }
        action.kind = ScriptAction::Kind::Sling;
        action.point = place;
        action.velocity = *velocity;
    }
    m_script.actions.push_back(action);
    return CheckEnd(words, "bomb");
}

Result<void> Parser::TakeSetting(ScriptAction action, Words& words)
{
    action.kind = ScriptAction::Kind::Set;
    action.name = words.IsEmpty() ? "" : words.Take();
    ASSIGN_OR_RETURN(const int value,
                     ParseSetting(action.name, words.IsEmpty() ? "" : words.Take()));
    action.value = value;
    m_script.actions.push_back(action);
    return CheckEnd(words, "set");
}

/// Reads the actions for panels. The panels themselves check the names.
Result<void> Parser::TakePanels(const std::string& verb, ScriptAction action, Words& words)
{
    using Kind = ScriptAction::Kind;
    action.kind = verb == "click" ? Kind::Click : verb == "type" ? Kind::Type : Kind::Hit;
    if (words.IsEmpty())
    {
        return action.kind == Kind::Click ? Unusable(Quoted("click"), "requires a control",
                                                     "for example click Solver/Sleep")
               : action.kind == Kind::Type
                   ? Unusable(Quoted("type"), "requires letters", "for example type dominos")
                   : Unusable(Quoted("hit"), "requires a key", "for example hit ctrl+o");
    }
    action.name = words.Take();
    m_script.actions.push_back(action);
    return CheckEnd(words, verb);
}

Result<void> Parser::TakeExpectation(ScriptMoment at, Words& words)
{
    ScriptProduct product;
    product.line = m_line;
    product.at = at;
    std::vector<std::string> rest = words.TakeRest();
    if (rest.empty())
    {
        return Unusable(Quoted("expect"), "requires a condition", "for example expect ball.y < 2");
    }
    if (rest.front() == "state")
    {
        product.kind = ScriptProduct::Kind::ExpectState;
        rest.erase(rest.begin());
    }
    product.name = JoinedBy(" ", rest);
    m_script.products.push_back(std::move(product));
    return {};
}

/// A key of the camera's path.
Result<void> Parser::TakeCamera(const ScriptMoment& at, Words& words)
{
    const auto* time = std::get_if<Duration>(&at.when);
    if (time == nullptr)
    {
        return Unusable(Quoted("camera"), "requires a time, not a step",
                        "for example at 1.5s camera 0,5,20");
    }
    if (!m_script.camera.empty() && *time <= m_lastCamera)
    {
        return Unusable(Quoted("camera"), "comes after a camera at " + TextOf(m_lastCamera),
                        "sort camera lines by time");
    }
    const std::string view = words.IsEmpty() ? "" : words.Take();
    const Result<ViewChoice> parsed = ParseView("camera", view);
    if (!parsed || !std::holds_alternative<FixedView>(*parsed))
    {
        return Unusable(Quoted("camera"), "requires a centre and a height in metres",
                        "for example camera 0,5,20");
    }
    m_lastCamera = *time;
    m_script.camera.push_back({TextOf(*time), view});
    return CheckEnd(words, "camera");
}

Result<void> Parser::TakeProduct(const std::string& verb, std::optional<ScriptMoment> at,
                                 Words& words)
{
    using Kind = ScriptProduct::Kind;
    ScriptProduct product;
    product.line = m_line;
    product.kind = verb == "shot" ? Kind::Shot : verb == "golden" ? Kind::Golden : Kind::Record;
    if (words.IsEmpty() || words.NextIs("-o") || words.NextIs("--output"))
    {
        return product.kind == Kind::Golden
                   ? Unusable(Quoted("golden"), "requires the name of a reference",
                              "for example golden ramp/2s")
                   : Unusable(Quoted(verb), "requires a file",
                              "for example " + verb + (verb == "shot" ? " ramp.png" : " ramp.mp4"));
    }
    product.name = words.Take();
    product.options = words.TakeRest();
    if (product.kind == Kind::Golden && !at)
    {
        return Unusable(Quoted("golden"), "requires a moment",
                        "for example at 2s golden " + product.name);
    }
    if (product.kind == Kind::Shot && at)
    {
        const std::vector<std::string> moment = at->AsOption();
        product.options.insert(product.options.end(), moment.begin(), moment.end());
    }
    product.at = at.value_or(ScriptMoment{});
    m_script.products.push_back(std::move(product));
    return {};
}

/// "at TIME VERB …", "at TIME to TIME drag X,Y".
Result<void> Parser::TakeAt(Words& words)
{
    ASSIGN_OR_RETURN(const ScriptMoment at, TakeMoment(words, "at"));
    ScriptAction action;
    action.line = m_line;
    action.at = at;
    const bool hasEnd = words.NextIs("to");
    if (hasEnd)
    {
        words.Take();
        ASSIGN_OR_RETURN(const ScriptMoment until, TakeMoment(words, "to"));
        action.until = until;
    }
    static const std::vector<std::string> kVerbs{
        "press",  "release", "tap",   "grab", "move", "drag", "drop",   "bomb",  "shift",
        "camera", "set",     "click", "type", "hit",  "shot", "golden", "expect"};
    const std::string verb = words.IsEmpty() ? "" : words.Take();
    if (std::find(kVerbs.begin(), kVerbs.end(), verb) == kVerbs.end())
    {
        return Unusable(Quoted(verb.empty() ? "at" : verb),
                        verb.empty() ? "requires an action" : "unknown action",
                        DidYouMean(verb, kVerbs, "use one of " + JoinedBy(", ", kVerbs)));
    }
    if (hasEnd != (verb == "drag"))
    {
        return hasEnd ? Unusable(Quoted(verb), "takes one moment", "remove 'to'")
                      : Unusable(Quoted("drag"), "requires a start and an end",
                                 "for example at 1s to 2s drag 3.5,4");
    }
    if (verb == "press" || verb == "release" || verb == "tap")
    {
        return TakeKey(verb, at, words);
    }
    if (verb == "bomb")
    {
        return TakeBomb(action, words);
    }
    if (verb == "set")
    {
        return TakeSetting(action, words);
    }
    if (verb == "click" || verb == "type" || verb == "hit")
    {
        return TakePanels(verb, action, words);
    }
    if (verb == "camera")
    {
        return TakeCamera(at, words);
    }
    if (verb == "expect")
    {
        return TakeExpectation(at, words);
    }
    return verb == "shot" || verb == "golden" ? TakeProduct(verb, at, words)
                                              : TakeMouse(verb, action, words);
}

Result<void> Parser::Take(int line, Words words)
{
    m_line = line;
    const std::size_t actions = m_script.actions.size();
    const std::string text = LineOf(Words(words).TakeRest()) + "\n";
    const Result<void> taken = TakeLine(words);
    m_script.actionText += m_script.actions.size() > actions ? text : "";
    return taken;
}

Result<void> Parser::TakeLine(Words& words)
{
    const std::string verb = words.Take();
    if (verb != "scene" && m_script.scene.empty())
    {
        return Unusable(Quoted(verb), "comes before the scene",
                        "begin with a line such as scene dominos");
    }
    if (verb == "scene")
    {
        return TakeScene(words);
    }
    if (verb == "at")
    {
        return TakeAt(words);
    }
    if (verb == "record" || verb == "shot" || verb == "golden")
    {
        return TakeProduct(verb, std::nullopt, words);
    }
    static const std::vector<std::string> kVerbs{"scene", "at", "record", "shot"};
    return Unusable(Quoted(verb), "unknown statement",
                    DidYouMean(verb, kVerbs, "use scene, at, record or shot"));
}

Result<Script> Parser::Finish()
{
    if (m_script.scene.empty())
    {
        return Unusable(m_script.file.string(), "has no scene",
                        "begin with a line such as scene dominos");
    }
    return std::move(m_script);
}

} // namespace

std::int64_t ScriptMoment::Step(const Rational& stepsPerSecond) const
{
    const auto* time = std::get_if<Duration>(&when);
    return time != nullptr ? StepAt(*time, stepsPerSecond) : std::get<std::int64_t>(when);
}

std::vector<std::string> ScriptMoment::AsOption() const
{
    const auto* time = std::get_if<Duration>(&when);
    return time != nullptr
               ? std::vector<std::string>{"--at", TextOf(*time)}
               : std::vector<std::string>{"--step", std::to_string(std::get<std::int64_t>(when))};
}

Error Script::At(int line, const Error& error) const
{
    return AtLine(file, line, error);
}

bool Script::ThrowsBombs() const
{
    return std::any_of(actions.begin(), actions.end(), [](const ScriptAction& action) {
        return action.kind == ScriptAction::Kind::Bomb || action.kind == ScriptAction::Kind::Sling;
    });
}

bool Script::UsesPanels() const
{
    return std::any_of(actions.begin(), actions.end(),
                       [](const ScriptAction& action) { return action.IsForPanels(); });
}

std::vector<std::string> Script::SceneOptions() const
{
    std::vector<std::string> all = options;
    if (camera.empty())
    {
        return all;
    }
    std::string path = "path:";
    for (const auto& [time, view] : camera)
    {
        path += (path.back() == ':' ? "" : ";") + time + "=" + view;
    }
    all.push_back("--camera");
    all.push_back(camera.size() == 1 ? camera.front().second : path);
    return all;
}

Error AtLine(const std::filesystem::path& file, int line, const Error& error)
{
    return Error{error.kind, file.string() + ":" + std::to_string(line) + ": " + error.culprit,
                 error.problem, error.remedy};
}

Result<Script> ParseScript(const std::string& text, const std::filesystem::path& file)
{
    constexpr std::string_view kMark = "\xEF\xBB\xBF"; // some editors begin UTF-8 with it
    Parser parser(file);
    int number = 0;
    const std::string plain = text.starts_with(kMark) ? text.substr(kMark.size()) : text;
    for (const std::string& line : SplitAt('\n', plain))
    {
        ++number;
        const auto fail = [&](const Error& error) { return AtLine(file, number, error); };
        Result<std::vector<std::string>> words = WordsOf(line);
        if (!words)
        {
            return fail(words.GetError());
        }
        if (words->empty())
        {
            continue;
        }
        if (const Result<void> taken = parser.Take(number, Words(std::move(*words))); !taken)
        {
            return fail(taken.GetError());
        }
    }
    return parser.Finish();
}

Result<Script> ReadScript(const std::filesystem::path& file)
{
    const Result<std::string> text = ReadWhole(file, kMaxBytes);
    if (!text)
    {
        Error error = text.GetError();
        if (error.remedy.empty())
        {
            error.remedy = "name a script, such as car.play";
        }
        return error;
    }
    if (text->find('\0') != std::string::npos)
    {
        return Error{ErrorKind::Unusable, file.string(), "is not a text file", "name a script"};
    }
    return ParseScript(*text, file);
}

} // namespace boxreel
