// SPDX-License-Identifier: MIT
#include "CommandGoldenReport.h"
#include "CommandGoldenState.h"
#include "Strips.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <golden/ReportPage.h>
#include <golden/Verdicts.h>

#include <fstream>
#include <system_error>

namespace boxreel
{
namespace
{

namespace fs = std::filesystem;

/// Its second line says what it is.
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
        return Error{ErrorKind::Unusable, "'" + path.string() +
                                              "' is a folder; name a file in it, such as '" +
                                              (path / "report.html").string() + "'."};
    }
    if (fs::exists(path, code) && !fs::is_regular_file(path, code))
    {
        return Error{ErrorKind::Unusable,
                     "'" + path.string() + "' is no plain file; name one, such as 'report.html'."};
    }
    if (!force && fs::exists(path, code) && !IsReport(path))
    {
        return Error{ErrorKind::Unusable, "'" + path.string() +
                                              "' is there and is no golden report; name another "
                                              "file, or remove this one."};
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, code))
    {
        return Error{ErrorKind::Unusable, "There is no folder '" + folder.string() +
                                              "' to write '" + path.string() +
                                              "' to; make it first."};
    }
    return {};
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
    return WriteOutput(DescribeOutcome(moments) + "; the report is '" + path.string() + "' (" +
                       Size(page.size()) + ")\n");
}

Result<int> RunGoldenReport(const GoldenReportOptions& options)
{
    const Result<void> written = WriteGoldenReport(options, {});
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace boxreel
