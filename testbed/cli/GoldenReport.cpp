// SPDX-License-Identifier: MIT
#include "GoldenReport.h"
#include "Declare.h"
#include "GoldenReport.h"
#include "GoldenState.h"
#include "Strips.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <golden/ReportPage.h>
#include <golden/Verdicts.h>

#include <algorithm>
#include <fstream>
#include <system_error>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

/// True if the file is a report page. Its second line identifies it.
bool IsReport(const fs::path& path)
{
    std::ifstream in(path);
    std::string first, second;
    return std::getline(in, first) && std::getline(in, second) &&
           second == "<!-- boxreel golden report -->";
}

std::string Size(std::size_t bytes)
{
    const std::size_t tenths = (bytes + 50'000) / 100'000; // of a megabyte
    return bytes < 100'000
               ? std::to_string((bytes + 999) / 1000) + " kB"
               : std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " MB";
}

} // namespace

Result<void> CheckGoldenReportPath(const fs::path& path, bool force)
{
    std::error_code code;
    if (fs::is_directory(path, code))
    {
        return Error{ErrorKind::Unusable, path.string(), "is a folder",
                     "name a file in it, such as " + (path / "report.html").string()};
    }
    if (fs::exists(path, code) && !fs::is_regular_file(path, code))
    {
        return Error{ErrorKind::Unusable, path.string(), "is not a regular file",
                     "name a file, such as report.html"};
    }
    if (!force && fs::exists(path, code) && !IsReport(path))
    {
        return Error{ErrorKind::Unusable, path.string(),
                     "already exists and is not a golden report",
                     "name another file, or remove this one"};
    }
    return CheckFolderOf(path);
}

Result<void> WriteGoldenReport(const GoldenReportOptions& options,
                               const std::set<std::string>& only)
{
    ASSIGN_OR_RETURN(const fs::path against,
                     options.against.empty() ? fs::path() : FindOtherProgram(options.against));
    std::vector<fs::path> folders = options.folders;
    if (folders.empty())
    {
        folders.push_back(DefaultGoldenOutput());
    }
    ASSIGN_OR_RETURN(std::vector<ReportedMoment> moments, CollectVerdicts(folders));
    if (!only.empty())
    {
        std::erase_if(moments, [&](const ReportedMoment& moment) {
            return !only.contains(moment.shown.name);
        });
    }
    const fs::path path = options.output.empty() ? folders.front() / "report.html" : options.output;
    RETURN_IF_ERROR(CheckGoldenReportPath(path, options.force));
    ASSIGN_OR_RETURN(const auto strips, MakeStrips(moments, against, options.backend));
    ASSIGN_OR_RETURN(const std::string page, ReportPage(moments, strips));
    RETURN_IF_ERROR(WriteWhole(path, page, true));
    RETURN_IF_ERROR(WriteOutput(DescribeOutcome(moments) + "; the report is '" + path.string() +
                                "' (" + Size(page.size()) + ")\n"));
    const bool lacksPages = std::any_of(strips.begin(), strips.end(), [](const auto& strip) {
        return !strip.second.pictures.empty() && strip.second.expectedPage.empty();
    });
    return lacksPages && !against.empty()
               ? Error{ErrorKind::Unusable, "--against " + options.against.string(),
                       "cannot record pages, so the report shows only its pictures",
                       "give a build with `boxreel record -o NAME.html`"}
               : Result<void>();
}

Result<int> Run(const GoldenReportOptions& options)
{
    const Result<void> written = WriteGoldenReport(options, {});
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

Command& Declare(Command& program, GoldenReportOptions& options)
{
    Command& command =
        AddCommand(Below(program, "golden"), "report", "Write an HTML report of golden tests");
    AddPaths(command, "FOLDERS", options.folders,
             "Read these output folders, one per shard\n"
             "(build/golden-output, or ./golden-output)")
        .Completes({Completion::Kind::Folders, {}});
    AddPath(command, "-o,--output", "FILE", options.output,
            "Write the report here (report.html in the first folder)", {".html"});
    AddPath(command, "--against", "FILE", options.against,
            "Show also the drawings of another build of boxreel around\n"
            "the first step that differs, and play both worlds");
    AddBackend(command, options.backend);
    AddForce(command, options.force);
    command.notes = {
        {"The report is one self-contained file: summary, filter, and for each moment that "
         "differs\n"
         "expected, actual, difference, blink, slider, the outlines of both worlds and the first\n"
         "step that differs. Exit code 0 when the report is written. For --against,\n"
         "`git worktree add ../before HEAD~1` checks out an older version; its script\n"
         "../before/boxreel builds it when it is run."}};
    command.examples = {"boxreel golden report",
                        "boxreel golden report shard-0 shard-1 -o report.html",
                        "boxreel golden report --against ../before/boxreel"};
    return command;
}

} // namespace boxreel
