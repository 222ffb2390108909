// SPDX-License-Identifier: MIT
#include "Program.h"

#include "CommandLine.h"
#include "Terminal.h"

namespace boxreel
{
namespace
{

struct Runner
{
    Result<int> operator()(const TextRequest& request) const
    {
        const Result<void> written = WriteOutput(request.text);
        if (!written)
        {
            return written.GetError();
        }
        return 0;
    }
    Result<int> operator()(const ListOptions& options) const { return RunList(options); }
    /// A film in which what the camera waits for has never come is a film all the same.
    Result<int> operator()(RecordOptions options) const
    {
        options.look.unmet = std::make_shared<std::string>();
        const Result<int> code = RunRecord(options);
        if (code && *code == 0 && !options.look.unmet->empty())
        {
            WriteMessage("boxreel: " + *options.look.unmet);
        }
        return code;
    }
    Result<int> operator()(const ShotOptions& options) const { return RunShot(options); }
    Result<int> operator()(const DiffOptions& options) const { return RunDiff(options); }
    Result<int> operator()(const GoldenOptions& options) const { return RunGolden(options); }
    Result<int> operator()(const BenchOptions& options) const { return RunBench(options); }
};

int Report(const Error& error)
{
    WriteMessage(Red("boxreel:", stderr) + " " + error.message);
    return static_cast<int>(error.kind);
}

} // namespace

int RunProgram(const std::vector<std::string>& arguments)
{
    const Result<Request> request = ParseCommandLine(arguments);
    if (!request)
    {
        return Report(request.GetError());
    }
    const Result<int> code = std::visit(Runner(), *request);
    return code ? *code : Report(code.GetError());
}

} // namespace boxreel
