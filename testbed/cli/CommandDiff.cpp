// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "OutputPath.h"

#include <base/ErrorMacros.h>
#include <base/Terminal.h>
#include <render/Png.h>

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
        WriteMessage("boxreel: Pictures of different sizes have no picture of differences; '" +
                     options.output.string() + "' was not written.");
        return {};
    }
    return WritePng(options.output, comparison.difference, {.overwrite = options.force});
}

} // namespace

Result<int> RunDiff(const DiffOptions& options)
{
    if (!options.output.empty())
    {
        RETURN_IF_ERROR(CheckPicturePath(options.output, options.force));
        for (const std::filesystem::path& picture : {options.expected, options.actual})
        {
            std::error_code none; // such as one that is not there yet
            if (std::filesystem::equivalent(options.output, picture, none))
            {
                return Error{ErrorKind::Unusable, "'" + options.output.string() +
                                                      "' is one of the pictures that are compared; "
                                                      "name another file for the difference."};
            }
        }
    }
    ASSIGN_OR_RETURN(Frame expected, ReadPng(options.expected));
    ASSIGN_OR_RETURN(Frame actual, ReadPng(options.actual));
    CompareSettings settings = Effective(options.compare);
    settings.paintsDifference = !options.output.empty();
    const Comparison comparison = Compare(expected, actual, settings);
    RETURN_IF_ERROR(WriteDifference(options, comparison));
    RETURN_IF_ERROR(WriteOutput(comparison.verdict + "\n"));
    return comparison.equal ? 0 : static_cast<int>(ErrorKind::Different);
}

} // namespace boxreel
