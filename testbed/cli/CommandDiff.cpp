// SPDX-License-Identifier: MIT
#include "Commands.h"
#include "OutputPath.h"

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
        const Result<void> usable = CheckPicturePath(options.output, options.force);
        if (!usable)
        {
            return usable.GetError();
        }
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
    Result<Frame> expected = ReadPng(options.expected);
    if (!expected)
    {
        return expected.GetError();
    }
    Result<Frame> actual = ReadPng(options.actual);
    if (!actual)
    {
        return actual.GetError();
    }
    CompareSettings settings = Effective(options.compare);
    settings.paintsDifference = !options.output.empty();
    const Comparison comparison = Compare(*expected, *actual, settings);
    const Result<void> difference = WriteDifference(options, comparison);
    if (!difference)
    {
        return difference.GetError();
    }
    const Result<void> verdict = WriteOutput(comparison.verdict + "\n");
    if (!verdict)
    {
        return verdict.GetError();
    }
    return comparison.equal ? 0 : static_cast<int>(ErrorKind::Different);
}

} // namespace boxreel
