// SPDX-License-Identifier: MIT
#include "Diff.h"
#include "Declare.h"
#include "OutputPath.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <render/Png.h>

#include <future>

namespace boxreel
{
namespace
{

Result<void> WriteDifference(const DiffOptions& options, const Comparison& comparison)
{
    if (options.output.empty())
    {
        return {};
    }
    if (!comparison.sameSize)
    {
        WriteMessage("boxreel: Pictures of different sizes have no difference picture; '" +
                     options.output.string() + "' was not written.");
        return {};
    }
    return WritePng(options.output, comparison.difference, {.overwrite = options.force});
}

} // namespace

Result<int> Run(const DiffOptions& options)
{
    if (!options.output.empty())
    {
        RETURN_IF_ERROR(CheckPicturePath(options.output, options.force));
        for (const std::filesystem::path& picture : {options.expected, options.actual})
        {
            std::error_code none; // such as one that is not there yet
            if (std::filesystem::equivalent(options.output, picture, none))
            {
                return Error{ErrorKind::Unusable, "-o " + options.output.string(),
                             "is one of the compared pictures", "choose another name"};
            }
        }
    }
    // Side by side: reading takes longer than comparing.
    std::future<Result<Frame>> other =
        std::async(std::launch::async, [&options] { return ReadPng(options.actual); });
    ASSIGN_OR_RETURN(const Frame expected, ReadPng(options.expected));
    ASSIGN_OR_RETURN(const Frame actual, other.get());
    CompareSettings settings = Effective(options.compare);
    settings.paintsDifference = !options.output.empty();
    const Comparison comparison = Compare(expected, actual, settings);
    RETURN_IF_ERROR(WriteDifference(options, comparison));
    RETURN_IF_ERROR(WriteOutput(comparison.Text() + "\n"));
    return comparison.equal ? 0 : static_cast<int>(ErrorKind::Different);
}

Command& Declare(Command& program, DiffOptions& diff)
{
    Command& command = AddCommand(program, "diff", "Compare two pictures");
    AddPath(command, "A", "", diff.expected, "Take this picture as correct, .png", {".png"});
    AddPath(command, "B", "", diff.actual, "Compare this picture with it, .png", {".png"});
    AddPath(command, "-o,--output", "FILE", diff.output, "Write a picture of the differences, .png",
            {".png"});
    AddForce(command, diff.force);
    AddCompare(command, diff.compare, "same-machine");
    command.notes = {{"Exit code 0: equal, 2: different, 1: a picture cannot be read."}};
    command.examples = {
        "boxreel diff before.png after.png",
        "boxreel diff before.png after.png --preset exact -o diff.png",
        "boxreel diff mine.png yours.png --preset cross-machine --ignore 0,0,200x30"};
    return command;
}

Result<void> Check(DiffOptions& options)
{
    if (options.expected.empty() || options.actual.empty())
    {
        return Missing("diff", "two pictures", "boxreel diff before.png after.png");
    }
    return {};
}

} // namespace boxreel
