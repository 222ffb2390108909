// SPDX-License-Identifier: MIT
#include <recorder/FrameRange.h>

#include <base/Quoting.h>
#include <base/Words.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <optional>

namespace boxreel
{

namespace
{

constexpr std::int64_t kMaxFrame = 1'000'000'000'000;

/// `why` describes the word at fault.
Error Refused(std::string_view text, std::string_view word, std::string_view why)
{
    const std::string problem = Quoted(word) + " " + std::string(why);
    return Error{ErrorKind::Unusable, Quoted(text), problem,
                 "give frames as 200-399 or 1-3,5,7-20:2"};
}

std::optional<std::int64_t> Whole(std::string_view text)
{
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool isWhole = error == std::errc() && end == text.data() + text.size();
    return isWhole && value >= 0 && value < kMaxFrame ? std::optional(value) : std::nullopt;
}

/// Parses "7", "7-20" or "7-20:2".
std::optional<FrameRun> ParseRun(std::string_view text)
{
    const std::size_t colon = text.find(':');
    const std::string_view numbers = text.substr(0, colon);
    const std::size_t dash = numbers.find('-');
    const std::optional<std::int64_t> first = Whole(numbers.substr(0, dash));
    const std::optional<std::int64_t> last =
        dash == std::string_view::npos ? first : Whole(numbers.substr(dash + 1));
    const std::optional<std::int64_t> step =
        colon == std::string_view::npos ? 1 : Whole(text.substr(colon + 1));
    if (!first || !last || !step || *step < 1)
    {
        return std::nullopt;
    }
    return FrameRun{*first, *last, *step};
}

std::string TextOf(const FrameRun& run)
{
    std::string text = std::to_string(run.first);
    if (run.last > run.first)
    {
        text.append("-").append(std::to_string(run.last));
    }
    if (run.step > 1)
    {
        text.append(":").append(std::to_string(run.step));
    }
    return text;
}

} // namespace

Result<FrameRange> FrameRange::Parse(std::string_view text)
{
    FrameRange range;
    range.m_runs.clear();
    std::string_view rest = text;
    while (true)
    {
        const std::size_t comma = rest.find(',');
        const std::string_view word = rest.substr(0, comma);
        const std::optional<FrameRun> run = ParseRun(word);
        if (!run)
        {
            return Refused(text, word, "is not a range of whole numbers");
        }
        if (run->last < run->first)
        {
            return Refused(text, word, "ends before it begins");
        }
        if (!range.m_runs.empty() && run->first <= range.m_runs.back().last)
        {
            return Refused(text, word, "must begin after the end of the previous range");
        }
        range.m_runs.push_back(*run);
        if (comma == std::string_view::npos)
        {
            return range;
        }
        rest = rest.substr(comma + 1);
    }
}

std::int64_t FrameRange::Count() const
{
    std::int64_t count = 0;
    for (const FrameRun& run : m_runs)
    {
        count += run.Count();
    }
    return count;
}

std::int64_t FrameRange::At(std::int64_t index) const
{
    for (const FrameRun& run : m_runs)
    {
        if (index < run.Count())
        {
            return run.first + index * run.step;
        }
        index -= run.Count();
    }
    assert(false && "there are not so many frames");
    return m_runs.back().last;
}

FrameRange FrameRange::Below(std::int64_t count) const
{
    FrameRange range;
    range.m_runs.clear();
    for (FrameRun run : m_runs)
    {
        run.last = std::min(run.last, count - 1);
        if (run.Count() > 0)
        {
            range.m_runs.push_back(run);
        }
    }
    if (range.m_runs.empty())
    {
        range.m_runs.push_back(FrameRun{0, -1, 1});
    }
    return range;
}

std::string FrameRange::Text() const
{
    return JoinedBy(",", m_runs, TextOf);
}

} // namespace boxreel
