// SPDX-License-Identifier: MIT
#include "VerdictText.h"

#include <algorithm>
#include <array>

namespace boxreel
{
namespace
{

constexpr std::array kStatuses{
    StatusWords{"error", "not compared",
                "the reference is damaged, or a body to leave out is not there", false},
    StatusWords{"state", "state", "the worlds differ: some body is elsewhere or moves otherwise",
                false},
    StatusWords{"drawlist", "geometry", "the same world draws something else", false},
    StatusWords{"pixels", "pixels", "the same geometry, other pixels", false},
    StatusWords{"missing", "missing", "never approved", false},
    StatusWords{"accepted", "accepted",
                "became the reference in this run; look at it before you commit it", true},
    StatusWords{"same", "as approved", "within the limits", true},
};

} // namespace

std::span<const StatusWords> AllStatusWords()
{
    return kStatuses;
}

const StatusWords* FindStatus(std::string_view word)
{
    const auto* const found =
        std::find_if(kStatuses.begin(), kStatuses.end(),
                     [&](const StatusWords& status) { return word == status.word; });
    return found == kStatuses.end() ? nullptr : found;
}

const char* StatusWord(GoldenStatus status)
{
    switch (status)
    {
    case GoldenStatus::Same:
        return "same";
    case GoldenStatus::Missing:
        return "missing";
    case GoldenStatus::State:
        return "state";
    case GoldenStatus::DrawList:
        return "drawlist";
    case GoldenStatus::Pixels:
        return "pixels";
    case GoldenStatus::NotCompared:
        break;
    }
    return "error";
}

const char* LimitsWord(LimitsChoice choice)
{
    switch (choice)
    {
    case LimitsChoice::AsGiven:
        return "as given";
    case LimitsChoice::SameRenderer:
        return "same renderer";
    case LimitsChoice::OtherRenderer:
        break;
    }
    return "other renderer";
}

std::string JoinedFindings(const std::vector<std::string>& findings)
{
    std::string text;
    for (const std::string& finding : findings)
    {
        text.append(text.empty() ? "" : "; ").append(finding);
    }
    return text;
}

std::string GoldenVerdict::Text(const std::string& remedy) const
{
    std::string text = name + ": " + JoinedFindings(findings) + ".";
    for (const std::string& file : look)
    {
        text.append(&file == look.data() ? " Look at " : ", ").append(file);
    }
    text += look.empty() ? "" : ".";
    const bool wouldHelp =
        status != GoldenStatus::Same && (!accept.empty() || status != GoldenStatus::NotCompared);
    const std::string usual = accept.empty() ? "" : "run `" + accept + "`";
    const std::string& what = remedy.empty() ? usual : remedy;
    return text + (wouldHelp && !what.empty() ? " If it is right, " + what + "." : "");
}

} // namespace boxreel
