// SPDX-License-Identifier: MIT
#include "Program.h"
#include "CommandLine.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <film/Progress.h>

namespace boxreel
{
namespace
{

struct Runner
{
    Result<int> operator()(const TextRequest& request) const
    {
        RETURN_IF_ERROR(WriteOutput(request.text));
        return 0;
    }
    Result<int> operator()(const ListOptions& options) const { return RunList(options); }
    Result<int> operator()(const RecordOptions& options) const { return RunRecord(options); }
    Result<int> operator()(const MergeOptions& options) const { return RunMerge(options); }
    Result<int> operator()(const ShotOptions& options) const { return RunShot(options); }
    Result<int> operator()(const DiffOptions& options) const { return RunDiff(options); }
    Result<int> operator()(const GoldenOptions& options) const { return RunGolden(options); }
    Result<int> operator()(const GoldenReportOptions& options) const
    {
        return RunGoldenReport(options);
    }
    Result<int> operator()(const GoldenStateOptions& options) const
    {
        return RunGoldenState(options);
    }
    Result<int> operator()(const DoctorOptions& options) const { return RunDoctor(options); }
    Result<int> operator()(const CheckOptions& options) const { return RunCheck(options); }
    Result<int> operator()(const ExportOptions& options) const { return RunExport(options); }
    Result<int> operator()(const PlayOptions& options) const { return RunPlay(options); }
    Result<int> operator()(const UiOptions& options) const { return RunUi(options); }
};

/// Whether an agent of a farm reads along; it does so too when the arguments are not understood.
bool AsksForOpenJd(const std::vector<std::string>& arguments)
{
    for (auto word = arguments.begin(); word != arguments.end(); ++word)
    {
        const auto next = std::next(word);
        if (*word == "--progress=openjd" ||
            (*word == "--progress" && next != arguments.end() && *next == "openjd"))
        {
            return true;
        }
    }
    return false;
}

int Report(const Error& error, const std::vector<std::string>& arguments)
{
    WriteMessage(Red("boxreel:", stderr) + " " + error.Text());
    if (AsksForOpenJd(arguments))
    {
        // Who cannot be told this cannot be told that, either.
        (void)WriteOutput(FailOpenJdText(error.Text()) + "\n");
    }
    return static_cast<int>(error.kind);
}

} // namespace

int RunProgram(const std::vector<std::string>& arguments)
{
    const Result<Request> request = ParseCommandLine(arguments);
    if (!request)
    {
        return Report(request.GetError(), arguments);
    }
    const Result<int> code = std::visit(Runner(), *request);
    return code ? *code : Report(code.GetError(), arguments);
}

} // namespace boxreel
