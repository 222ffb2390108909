// SPDX-License-Identifier: MIT
#include "../VerdictText.h"
#include "PageTexts.h"
#include <base/Counting.h>
#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/ReadWhole.h>
#include <base/Words.h>
#include <golden/ReportPage.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <system_error>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

std::string LabelOf(const std::string& status)
{
    const StatusWords* const words = FindStatus(status);
    return words ? words->label : status;
}

bool IsFailure(const ReportedMoment& moment)
{
    const StatusWords* const words = FindStatus(moment.shown.status);
    return words == nullptr || !words->passes;
}

constexpr std::uintmax_t kLargestFile = 256u << 20; // a picture or a draw list [bytes]

/// Returns the content; empty if the file does not exist.
Result<std::string> ReadIfThere(const fs::path& path)
{
    std::error_code code;
    return fs::exists(path, code) ? ReadWhole(path, kLargestFile) : std::string();
}

std::string Png(const std::string& bytes)
{
    return "\"data:image/png;base64," + Base64(bytes) + "\"";
}

std::string StripJson(const FilmStrip& strip)
{
    std::string text = "{\"note\":" + JsonText(strip.note) +
                       ",\"earlier\":" + JsonText(strip.earlier) +
                       ",\"width\":" + std::to_string(strip.width) +
                       ",\"height\":" + std::to_string(strip.height) + ",\"pictures\":[";
    for (const FilmStrip::Picture& picture : strip.pictures)
    {
        text += (&picture == strip.pictures.data() ? "" : ",") + std::string("{\"step\":") +
                std::to_string(picture.step) + ",\"actual\":" + Png(picture.actual);
        text += picture.closeUp.empty() ? "" : ",\"closeUp\":" + Png(picture.closeUp);
        text += picture.expected.empty() ? "" : ",\"expected\":" + Png(picture.expected);
        text += picture.expectedCloseUp.empty()
                    ? ""
                    : ",\"expectedCloseUp\":" + Png(picture.expectedCloseUp);
        text += ",\"mark\":[";
        for (std::size_t i = 0; i < picture.mark.size(); ++i)
        {
            text += (i > 0 ? "," : "") + std::to_string(picture.mark[i]);
        }
        text += "]}";
    }
    text += "]";
    if (!strip.actualPage.empty() && !strip.expectedPage.empty())
    {
        text += ",\"actualPage\":" + JsonText(strip.actualPage) +
                ",\"expectedPage\":" + JsonText(strip.expectedPage);
    }
    return text + "}";
}

/// Returns the data of a moment for the script, as JSON.
Result<std::string> DataOf(const ReportedMoment& moment, const FilmStrip* strip)
{
    struct Part
    {
        const char* name;
        const char* end;
        bool isPicture;
    };
    constexpr Part kParts[] = {
        {"expectedPicture", ".expected.png", true},
        {"actualPicture", ".actual.png", true},
        {"differencePicture", ".difference.png", true},
        {"expectedList", ".expected.txt", false},
        {"actualList", ".actual.txt", false},
        {"expectedState", ".expected.state.txt", false},
        {"actualState", ".actual.state.txt", false},
    };
    std::string text = "{\"verdict\":" + moment.shown.json;
    for (const Part& part : kParts)
    {
        ASSIGN_OR_RETURN(const std::string bytes,
                         ReadIfThere(moment.shown.base.string() + part.end));
        if (!bytes.empty())
        {
            text += std::string(",\"") + part.name +
                    "\":" + (part.isPicture ? Png(bytes) : JsonText(bytes));
        }
    }
    return text + (strip != nullptr ? ",\"strip\":" + StripJson(*strip) : "") + "}";
}

std::string Message(const ReportedVerdict& verdict)
{
    std::string text = "<ul class=\"message\">\n";
    for (const std::string& finding : verdict.findings)
    {
        text += "<li>" + MarkupEscaped(finding) + "</li>\n";
    }
    return text + "</ul>\n";
}

Result<std::string> Card(const ReportedMoment& moment, const FilmStrip* strip)
{
    ASSIGN_OR_RETURN(const std::string data, DataOf(moment, strip));
    const ReportedVerdict& shown = moment.shown;
    const std::string name = MarkupEscaped(shown.name);
    std::string text = "<article class=\"moment\" id=\"" + name +
                       "\" tabindex=\"-1\" data-status=\"" + shown.status + "\" data-name=\"" +
                       name + "\">\n<h2><a href=\"#" + name + "\">" + name +
                       "</a> <span class=\"badge " + shown.status + "\">" +
                       MarkupEscaped(LabelOf(shown.status)) + "</span></h2>\n" + Message(shown);
    if (!shown.accept.empty() && IsFailure(moment))
    {
        const bool isMissing = shown.status == StatusWord(GoldenStatus::Missing);
        text += "<p>If the picture is right, accept it: <code>" + MarkupEscaped(shown.accept) +
                "</code>, or run the test with <code>BOXREEL_GOLDEN_ACCEPT=" +
                (isMissing ? "missing" : "changed") + "</code>.</p>\n";
    }
    for (const ReportedVerdict& other : moment.others)
    {
        text += "<p class=\"other\">This is of " + MarkupEscaped(shown.folder) + "; " +
                MarkupEscaped(other.folder) + " says <b>" + MarkupEscaped(LabelOf(other.status)) +
                "</b>: " + MarkupEscaped(JoinedBy("; ", other.findings)) + "</p>\n";
    }
    return text + "<div class=\"views\"></div>\n<script type=\"application/json\">" + data +
           "</script>\n</article>\n";
}

std::string Buttons(const std::vector<ReportedMoment>& moments)
{
    std::string text;
    for (const StatusWords& look : AllStatusWords())
    {
        std::size_t number = 0;
        for (const ReportedMoment& moment : moments)
        {
            number += moment.shown.status == look.word ? 1 : 0;
        }
        if (number > 0)
        {
            text += std::string("<button type=\"button\" class=\"badge ") + look.word +
                    "\" data-status=\"" + look.word + "\" aria-pressed=\"true\" title=\"" +
                    look.meaning + "\">" + std::to_string(number) + " " + look.label +
                    "</button>\n";
        }
    }
    return text;
}

std::string Terms(const char* what, const std::set<std::string>& values)
{
    std::string text;
    for (const std::string& value : values)
    {
        text += value.empty() ? "" : "<dd>" + MarkupEscaped(value) + "</dd>";
    }
    return text.empty() ? "" : std::string("<dt>") + what + "</dt>" + text + "\n";
}

std::string Facts(const std::vector<ReportedMoment>& moments)
{
    std::set<std::string> renderers;
    std::set<std::string> limits;
    for (const ReportedMoment& moment : moments)
    {
        renderers.insert(moment.shown.renderer);
        limits.insert(moment.shown.limits);
    }
    return Terms("Drawn by", renderers) + Terms("Limits", limits);
}

std::string Passed(const std::vector<ReportedMoment>& moments)
{
    std::string list;
    std::size_t number = 0;
    for (const ReportedMoment& moment : moments)
    {
        if (moment.shown.Passed())
        {
            ++number;
            const std::string name = MarkupEscaped(moment.shown.name);
            list += "<li data-name=\"" + name + "\">" + name + "</li>\n";
        }
    }
    return number == 0 ? ""
                       : "<details id=\"passed\" data-status=\"" +
                             std::string(StatusWord(GoldenStatus::Same)) + "\"" +
                             std::string(number == moments.size() ? " open" : "") + "><summary>" +
                             Counted(number, "moment") + " as approved</summary>\n<ul>\n" + list +
                             "</ul>\n</details>\n";
}

} // namespace

std::string DescribeOutcome(const std::vector<ReportedMoment>& moments)
{
    const auto failures = std::count_if(moments.begin(), moments.end(), IsFailure);
    const auto accepted =
        std::count_if(moments.begin(), moments.end(), [](const ReportedMoment& moment) {
            return moment.shown.status == StatusWord(std::nullopt);
        });
    return Counted(moments.size(), "moment") + ": " +
           (failures == 0 ? "all as approved" : std::to_string(failures) + " not as approved") +
           (accepted == 0 ? "" : ", " + std::to_string(accepted) + " accepted just now");
}

Result<std::string> ReportPage(const std::vector<ReportedMoment>& moments,
                               const std::map<std::string, FilmStrip>& strips)
{
    std::string cards;
    for (const ReportedMoment& moment : moments)
    {
        // A moment that passed everywhere has no different verdicts.
        if (moment.shown.Passed())
        {
            continue;
        }
        const auto strip = strips.find(moment.shown.name);
        ASSIGN_OR_RETURN(const std::string card,
                         Card(moment, strip == strips.end() ? nullptr : &strip->second));
        cards += card;
    }
    const std::string outcome = DescribeOutcome(moments);
    const std::string buttons = Buttons(moments);
    const std::string facts = Facts(moments);
    const std::string passed = Passed(moments);
    return FilledTemplate(kPageHtml, {{"outcome", outcome},
                                      {"class", cards.empty() ? "good" : "bad"},
                                      {"style", kPageCss},
                                      {"script", kPageJs},
                                      {"buttons", buttons},
                                      {"facts", facts},
                                      {"cards", cards},
                                      {"passed", passed}});
}

} // namespace boxreel
