// SPDX-License-Identifier: MIT
#include "../VerdictText.h"

#include <golden/Verdicts.h>

#include <base/ErrorMacros.h>
#include <base/Quoting.h>
#include <base/ReadWhole.h>
#include <base/Unusable.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <system_error>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kEnd = ".verdict.json";
constexpr const char* kRemedy =
    "run `boxreel golden verify` or your tests, and name their output folder";
constexpr std::uintmax_t kLargest = 1024 * 1024; // a message quotes a line or two of a draw list

/// Returns the severity: if shards disagree, the worst is shown.
std::ptrdiff_t RankOf(const std::string& status)
{
    return FindStatus(status) - AllStatusWords().data();
}

/// Replaces invalid UTF-8 by U+FFFD, because a line of a draw list may contain any bytes.
std::string Dumped(const json& value)
{
    return JsonForScript(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

/// Returns the limits as text, and the number of pixels not compared.
std::string LimitsOf(const json& file)
{
    const std::size_t regions = file.value("ignored", json::array()).size();
    const std::size_t bodies = file.value("ignoredBodies", json::array()).size();
    return file.value("limits", "") + (bodies > 0 ? "; bodies left out: " + std::to_string(bodies)
                                       : regions > 0
                                           ? "; rectangles left out: " + std::to_string(regions)
                                           : "");
}

/// Returns what tells the verdicts of two shards apart: the file without its sentences and without
/// what shards that agree may have of their own.
std::string DataOf(json file)
{
    for (const char* key :
         {"findings", "accept", "limits", "pixels", "renderer", "fingerprint", "view"})
    {
        file.erase(key);
    }
    return Dumped(file);
}

ReportedVerdict FromJson(const json& file)
{
    ReportedVerdict verdict;
    if (file.at("verdict") != 2)
    {
        throw std::runtime_error("unknown version");
    }
    verdict.name = file.at("name");
    verdict.status = file.at("status");
    verdict.findings = file.at("findings").get<std::vector<std::string>>();
    verdict.accept = file.value("accept", "");
    verdict.renderer = file.value("renderer", "");
    verdict.limits = LimitsOf(file);
    if (FindStatus(verdict.status) == nullptr)
    {
        throw std::runtime_error("unknown status");
    }
    if (file.value("accepted", false))
    {
        verdict.status = StatusWord(std::nullopt);
    }
    if (file.contains("firstStep"))
    {
        verdict.firstStep = file.at("firstStep").get<std::int64_t>();
        verdict.firstBodies = file.at("firstBodies").get<std::vector<int>>();
        verdict.firstHash = file.value("firstHash", "");
    }
    if (file.contains("step"))
    {
        verdict.lastStep = file.at("step").get<std::int64_t>();
    }
    verdict.json = Dumped(file);
    verdict.data = DataOf(file);
    return verdict;
}

Result<ReportedVerdict> ReadVerdict(const fs::path& path)
{
    ASSIGN_OR_RETURN(const std::string bytes, ReadWhole(path, kLargest));
    try // the parser reports invalid files by exceptions
    {
        // Parsed twice, so that invalid UTF-8 does not make the whole file unreadable.
        return FromJson(json::parse(json::parse(Dumped(bytes)).get<std::string>()));
    }
    catch (const std::exception&)
    {
        return Unusable(path.string(), "is not a verdict of a golden test",
                        "remove it, or run its test again");
    }
}

/// An unreadable file is reported as a verdict, so that the rest of the page remains usable.
ReportedVerdict Unreadable(const fs::path& path, const fs::path& folder, const Error& error)
{
    std::string name = path.lexically_relative(folder).generic_string();
    name.resize(name.size() - std::string_view(kEnd).size());
    return FromJson({{"verdict", 2},
                     {"name", name},
                     {"status", StatusWord(GoldenStatus::NotCompared)},
                     {"culprit", error.culprit.Text()},
                     {"findings", {error.Text()}}});
}

/// Returns the files of a folder, sorted, so that the same folders give the same page.
Result<std::vector<fs::path>> FindVerdicts(const fs::path& folder)
{
    std::error_code code;
    if (!fs::is_directory(folder, code))
    {
        return Unusable(folder.string(), "does not exist", kRemedy);
    }
    std::vector<fs::path> paths;
    for (fs::recursive_directory_iterator entry(folder, code), end; !code && entry != end;
         entry.increment(code))
    {
        std::error_code ignored;
        if (entry->path().filename().string().ends_with(kEnd) && entry->is_regular_file(ignored))
        {
            paths.push_back(entry->path());
        }
    }
    if (code)
    {
        return Unusable(folder.string(), "cannot be read: " + code.message(), "make it readable");
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// Returns the output folder: the path without the name.
std::string FolderOf(const fs::path& path, const std::string& name)
{
    std::string folder = path.generic_string();
    const std::string end = name + kEnd;
    if (folder.ends_with(end))
    {
        folder.resize(folder.size() - end.size());
    }
    while (folder.size() > 1 && folder.ends_with('/'))
    {
        folder.pop_back();
    }
    return folder.empty() ? "." : folder;
}

void Merge(ReportedMoment& moment, ReportedVerdict verdict)
{
    if (RankOf(verdict.status) < RankOf(moment.shown.status))
    {
        std::swap(moment.shown, verdict);
    }
    if (verdict.status != moment.shown.status || verdict.data != moment.shown.data)
    {
        moment.others.push_back(std::move(verdict));
    }
}

} // namespace

bool ReportedVerdict::Passed() const
{
    return status == StatusWord(GoldenStatus::Same);
}

std::string JsonText(const std::string& bytes)
{
    return Dumped(bytes);
}

Result<std::vector<ReportedMoment>> CollectVerdicts(const std::vector<fs::path>& folders)
{
    std::map<std::string, ReportedMoment> moments;
    for (const fs::path& folder : folders)
    {
        ASSIGN_OR_RETURN(const std::vector<fs::path> paths, FindVerdicts(folder));
        if (paths.empty())
        {
            return Unusable(folder.string(), "contains no verdict of a golden test", kRemedy);
        }
        for (const fs::path& path : paths)
        {
            Result<ReportedVerdict> verdict = ReadVerdict(path);
            if (!verdict)
            {
                verdict = Unreadable(path, folder, verdict.GetError());
            }
            verdict->folder = FolderOf(path, verdict->name);
            const std::string whole = path.string();
            verdict->base = whole.substr(0, whole.size() - std::string_view(kEnd).size());
            const auto [place, isNew] = moments.try_emplace(verdict->name);
            if (isNew)
            {
                place->second.shown = *std::move(verdict);
            }
            else
            {
                Merge(place->second, *std::move(verdict));
            }
        }
    }
    std::vector<ReportedMoment> sorted;
    sorted.reserve(moments.size());
    for (auto& [name, moment] : moments)
    {
        sorted.push_back(std::move(moment));
    }
    return sorted;
}

} // namespace boxreel
