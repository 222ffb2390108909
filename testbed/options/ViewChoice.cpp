// SPDX-License-Identifier: MIT
#include "ViewChoice.h"
#include "Values.h"

#include <base/Nearest.h>
#include <base/Words.h>

#include <charconv>
#include <cmath>

namespace boxreel
{
namespace
{

// Single precision has 24 bits: farther out, or seen closer, neighbouring pixels are the same
// point.
constexpr double kFarthest = 1e6;        // [m]
constexpr double kSmallestHeight = 1e-3; // [m]
constexpr double kLargestHeight = 1e6;   // [m]

/// A number from `lowest` to `highest`.
std::optional<double> ReadBetween(std::string_view text, double lowest, double highest)
{
    const Result<double> number = ParseNumber("", text);
    return number && *number >= lowest && *number <= highest ? std::optional(*number)
                                                             : std::nullopt;
}

std::optional<FixedView> ReadFixed(std::string_view text)
{
    const std::vector<std::string> parts = SplitAt(',', text);
    if (parts.size() != 3)
    {
        return std::nullopt;
    }
    const std::optional<double> x = ReadBetween(parts[0], -kFarthest, kFarthest);
    const std::optional<double> y = ReadBetween(parts[1], -kFarthest, kFarthest);
    const std::optional<double> height = ReadBetween(parts[2], kSmallestHeight, kLargestHeight);
    return x && y && height ? std::optional(FixedView{*x, *y, *height}) : std::nullopt;
}

/// Returns "the height 1e-5 is not from 0.001 to 1000000 m" for a number out of its limits,
/// otherwise nothing.
std::string WhyOutside(const char* what, std::string_view text, double lowest, double highest)
{
    const Result<double> number = ParseNumber("", text);
    if (!number || (*number >= lowest && *number <= highest))
    {
        return "";
    }
    std::string why = "the ";
    return why.append(what)
        .append(" ")
        .append(text)
        .append(" is not from ")
        .append(lowest < 0.0 ? "-1000000 to 1000000 m" : "0.001 to 1000000 m");
}

std::string WhyOutsideHeights(std::string_view text)
{
    return WhyOutside("height", text, kSmallestHeight, kLargestHeight);
}

/// Returns which of the three numbers "X,Y,HEIGHT" is out of its limits, and the limits.
std::string WhyNotFixed(std::string_view text)
{
    const std::vector<std::string> parts = SplitAt(',', text);
    if (parts.size() != 3)
    {
        return "";
    }
    for (const std::string& why :
         {WhyOutside("centre's x", parts[0], -kFarthest, kFarthest),
          WhyOutside("centre's y", parts[1], -kFarthest, kFarthest), WhyOutsideHeights(parts[2])})
    {
        if (!why.empty())
        {
            return why;
        }
    }
    return "";
}

std::optional<FollowView> ReadFollow(std::string_view text)
{
    const std::vector<std::string> parts = SplitOutsideQuotes(":", text);
    const std::optional<std::vector<BodyRef>> bodies = ReadBodyRefs(parts.front());
    if (!bodies || parts.size() > 2)
    {
        return std::nullopt;
    }
    FollowView view{*bodies, std::nullopt};
    if (parts.size() == 2)
    {
        view.height = ReadBetween(parts[1], kSmallestHeight, kLargestHeight);
        return view.height ? std::optional(view) : std::nullopt;
    }
    return view;
}

/// "3s=10,5,12"
std::optional<CameraKey> ReadKey(std::string_view text)
{
    const std::vector<std::string> parts = SplitAt('=', text);
    if (parts.size() != 2)
    {
        return std::nullopt;
    }
    const Result<Duration> time = ParseDuration("", parts[0]);
    const std::optional<FixedView> view = ReadFixed(parts[1]);
    if (!time || !view)
    {
        return std::nullopt;
    }
    return CameraKey{double(time->nanoseconds) / 1e9, view->centerX, view->centerY, view->height};
}

Result<ViewChoice> ParsePath(const std::string& option, std::string_view keys)
{
    PathView path;
    for (const std::string& part : SplitAt(';', keys))
    {
        const std::optional<CameraKey> key = ReadKey(part);
        if (!key)
        {
            const std::string why = WhyNotFixed(SplitAt('=', part).back());
            return BadValue(option + " path:", part,
                            why.empty() ? "must be TIME=X,Y,HEIGHT, such as 3s=10,5,12" : why);
        }
        path.keys.push_back(*key);
    }
    const std::string why = WhyNotPath(path.keys);
    return why.empty() ? Result<ViewChoice>(path)
                       : BadValue(option, "path:" + std::string(keys), why);
}

/// Each the shortest that is read as the same number.
std::string Exactly(std::initializer_list<double> numbers)
{
    return JoinedBy(",", numbers, [](double number) {
        char text[40];
        char* const end = std::to_chars(text, text + sizeof text, number).ptr;
        return std::string(&text[0], end);
    });
}

std::string TextOf(const std::vector<BodyRef>& bodies)
{
    return JoinedBy(",", bodies, [](const BodyRef& body) {
        return body.name.empty() ? std::to_string(body.number) : '"' + body.name + '"';
    });
}

struct Describer
{
    std::string operator()(const SceneView&) const { return "scene"; }
    std::string operator()(const FitView& view) const
    {
        return view.wholeWorld ? "fit:world" : "fit";
    }
    std::string operator()(const FitBodiesView& view) const
    {
        return std::string("fit:").append(TextOf(view.bodies));
    }
    std::string operator()(const FixedView& view) const
    {
        return Exactly({view.centerX, view.centerY, view.height});
    }
    std::string operator()(const FollowView& view) const
    {
        std::string text = std::string("follow:").append(TextOf(view.bodies));
        return view.height ? text.append(1, ':').append(Exactly({*view.height})) : text;
    }
    std::string operator()(const PathView& view) const
    {
        std::string text = "path:";
        for (const CameraKey& key : view.keys)
        {
            text.append(Exactly({key.time, key.centerX, key.centerY, key.height})).append(1, ';');
        }
        return text;
    }
};

} // namespace

std::string TextOf(const ViewChoice& view)
{
    return std::visit(Describer(), view);
}

std::vector<BodyRef*> BodiesOf(ViewChoice& view)
{
    std::vector<BodyRef>* bodies = nullptr;
    if (auto* fit = std::get_if<FitBodiesView>(&view))
    {
        bodies = &fit->bodies;
    }
    else if (auto* follow = std::get_if<FollowView>(&view))
    {
        bodies = &follow->bodies;
    }
    std::vector<BodyRef*> all;
    for (std::size_t i = 0; bodies != nullptr && i < bodies->size(); ++i)
    {
        all.push_back(&(*bodies)[i]);
    }
    return all;
}

Result<ViewChoice> ParseView(const std::string& option, const std::string& text)
{
    const std::size_t colon = text.find(':');
    const std::string kind = text.substr(0, colon);
    const std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (text == "scene")
    {
        return ViewChoice(SceneView{});
    }
    if (text == "fit" || text == "fit:world")
    {
        return ViewChoice(FitView{text != "fit"});
    }
    if (kind == "path")
    {
        return ParsePath(option, rest);
    }
    if (kind == "fit")
    {
        const std::optional<std::vector<BodyRef>> bodies = ReadBodyRefs(rest);
        return bodies ? Result<ViewChoice>(FitBodiesView{*bodies})
                      : BadValue(option, text,
                                 "must be fit:world, or numbers or names of bodies, such as "
                                 "fit:3,17");
    }
    if (kind == "follow")
    {
        const std::optional<FollowView> follow = ReadFollow(rest);
        const std::vector<std::string> parts = SplitOutsideQuotes(":", rest);
        const std::string why = parts.size() == 2 ? WhyOutsideHeights(parts.back()) : "";
        if (!why.empty())
        {
            return BadValue(option, text, why);
        }
        return follow ? Result<ViewChoice>(*follow)
                      : BadValue(option, text,
                                 "must be numbers or names of bodies, then an optional height of "
                                 "the view in metres, such as follow:3,17:12");
    }
    const std::optional<FixedView> fixed = ReadFixed(text);
    if (const std::string why = WhyNotFixed(text); !why.empty())
    {
        return BadValue(option, text, why);
    }
    return fixed ? Result<ViewChoice>(*fixed)
                 : BadValue(option, text,
                            "must be scene, fit, fit:world, fit:3,17, follow:17, a centre and a "
                            "height in metres such as 0,20,50, or path:0s=0,20,50;3s=10,5,12",
                            DidYouMean(kind, {"scene", "fit", "follow", "path"}));
}

} // namespace boxreel
