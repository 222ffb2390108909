// SPDX-License-Identifier: MIT
#include "CommandGoldenReport.h"
#include "CommandGoldenState.h"
#include "Strips.h"

#include <base/AtomicFile.h>
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
    const Result<fs::path> against =
        options.against.empty() ? fs::path() : FindOtherProgram(options.against);
    if (!against)
    {
        return against.GetError();
    }
    std::vector<fs::path> folders = options.folders;
    if (folders.empty())
    {
        folders.push_back(DefaultGoldenOutput());
    }
    Result<std::vector<ReportedMoment>> moments = CollectVerdicts(folders);
    if (!moments)
    {
        return moments.GetError();
    }
    if (!only.empty())
    {
        std::erase_if(*moments, [&](const ReportedMoment& moment) {
            return !only.contains(moment.shown.name);
        });
    }
    const fs::path path = options.output.empty() ? folders.front() / "report.html" : options.output;
    if (const Result<void> usable = CheckGoldenReportPath(path, options.force); !usable)
    {
        return usable;
    }
    const Result<std::map<std::string, FilmStrip>> strips =
        MakeStrips(*moments, *against, options.backend);
    if (!strips)
    {
        return strips.GetError();
    }
    const Result<std::string> page = ReportPage(*moments, *strips);
    if (!page)
    {
        return page.GetError();
    }
    if (const Result<void> written = WriteWhole(path, *page, true); !written)
    {
        return written;
    }
    return WriteOutput(DescribeOutcome(*moments) + "; the report is '" + path.string() + "' (" +
                       Size(page->size()) + ")\n");
}

Result<int> RunGoldenReport(const GoldenReportOptions& options)
{
    const Result<void> written = WriteGoldenReport(options, {});
    return written ? Result<int>(0) : Result<int>(written.GetError());
}

} // namespace boxreel
