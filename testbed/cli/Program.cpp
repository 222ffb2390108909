// SPDX-License-Identifier: MIT
#include "Program.h"
#include "CommandLine.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <film/Progress.h>
#include <options/OptionNames.h>

namespace boxreel
{
namespace
{

Result<int> Run(const TextRequest& request)
{
    RETURN_IF_ERROR(WriteOutput(request.text));
    return 0;
}

/// True if a render farm reads the output, even if the arguments are wrong.
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
    WriteMessage(Red("boxreel:", stderr) + " " + TextInOptions(error));
    if (AsksForOpenJd(arguments))
    {
        // If this cannot be written, there is no other way to report it.
        (void)WriteOutput(FailOpenJdText(TextInOptions(error)) + "\n");
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
    const Result<int> code = std::visit([](const auto& options) { return Run(options); }, *request);
    return code ? *code : Report(code.GetError(), arguments);
}

} // namespace boxreel
