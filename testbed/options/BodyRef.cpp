// SPDX-License-Identifier: MIT
#include "BodyRef.h"
#include "Values.h"

#include <base/Nearest.h>
#include <base/Words.h>

#include <algorithm>

namespace boxreel
{
namespace
{

constexpr std::int64_t kMaxBodies = 1'000'000'000;

Error NoSuchBody(const std::string& option, const std::string& name,
                 const std::map<std::uint32_t, std::string>& names)
{
    std::vector<std::string> known;
    for (const auto& [number, body] : names)
    {
        known.push_back(body);
    }
    return BadValue(option, name, "no body has this name",
                    DidYouMean(name, known,
                               known.empty() ? "give a number; --labels shows them"
                                             : "--draw shapes,names shows the names"));
}

} // namespace

std::vector<std::string> SplitOutsideQuotes(std::string_view separator, std::string_view text)
{
    std::vector<std::string> parts(1);
    bool quoted = false;
    while (!text.empty())
    {
        const bool parted = !quoted && text.starts_with(separator);
        if (parted)
        {
            parts.emplace_back();
        }
        else
        {
            quoted = quoted != (text.front() == '"');
            parts.back() += text.front();
        }
        text.remove_prefix(parted ? separator.size() : 1);
    }
    return parts;
}

std::optional<BodyRef> ReadBodyRef(std::string_view text)
{
    if (text.size() > 2 && text.front() == '"' && text.back() == '"')
    {
        return BodyRef(std::string(text.substr(1, text.size() - 2)));
    }
    const bool isNumber = text.find_first_not_of("+-.0123456789") == std::string_view::npos;
    if (isNumber || text.find_first_of("\",:;") != std::string_view::npos || text.front() == ' ' ||
        text.back() == ' ')
    {
        const Result<std::int64_t> number = ParseWhole("", text, 0, kMaxBodies);
        return number ? std::optional(BodyRef(static_cast<int>(*number))) : std::nullopt;
    }
    return BodyRef(std::string(text));
}

std::optional<std::vector<BodyRef>> ReadBodyRefs(std::string_view text)
{
    std::vector<BodyRef> bodies;
    for (const std::string& part : SplitOutsideQuotes(",", text))
    {
        const std::optional<BodyRef> body = ReadBodyRef(part);
        if (!body)
        {
            return std::nullopt;
        }
        bodies.push_back(*body);
    }
    return bodies;
}

Result<void> FindNames(const std::string& option, const std::vector<BodyRef*>& bodies,
                       const std::map<std::uint32_t, std::string>& names)
{
    for (BodyRef* const body : bodies)
    {
        std::vector<std::uint32_t> numbers;
        for (const auto& [number, name] : names)
        {
            if (!body->name.empty() && name == body->name)
            {
                numbers.push_back(number);
            }
        }
        if (numbers.empty() && !body->name.empty())
        {
            return NoSuchBody(option, body->name, names);
        }
        if (numbers.size() > 1)
        {
            const std::string all = JoinedBy(
                ", ", numbers, [](std::uint32_t number) { return std::to_string(number); });
            return BadValue(option, body->name, "bodies " + all + " have this name",
                            "give the number of one");
        }
        if (!numbers.empty())
        {
            *body = BodyRef(static_cast<int>(numbers.front()));
        }
    }
    return {};
}

std::vector<int> NumbersOf(const std::vector<BodyRef>& bodies)
{
    std::vector<int> numbers;
    for (const BodyRef& body : bodies)
    {
        numbers.push_back(body.number);
    }
    return numbers;
}

} // namespace boxreel
