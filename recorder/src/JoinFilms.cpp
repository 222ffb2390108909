// SPDX-License-Identifier: MIT
#include <recorder/JoinFilms.h>

#include "AnimationCopy.h"
#include "FFmpegJoin.h"
#include "VideoFormat.h"

#include <base/ErrorMacros.h>

#include <cassert>

namespace boxreel
{

Result<JoinedFilm> JoinFilms(const std::vector<FilmPart>& parts, const std::filesystem::path& path,
                             const VideoSettings& settings, const std::function<bool()>& isStopped)
{
    assert(!parts.empty() && "parts of a film");
    RETURN_IF_ERROR(CheckVideoPath(path, settings));
    const VideoFormat format = *FormatOf(path, settings);
    for (const FilmPart& part : parts)
    {
        if (FormatOf(part.path, {}) != format)
        {
            return Error{ErrorKind::Unusable, part.path.string(),
                         "has another format than " + path.string(),
                         "use the same extension for the parts and the film"};
        }
    }
    if (IsPipe(path) || !HasParts(format) || format == VideoFormat::PngSequence)
    {
        return Error{
            ErrorKind::Unusable, path.string(), "has a format that cannot be joined",
            "record the parts in another format, or put parts of frames-####.png into one folder"};
    }
    if (IsAnimation(format))
    {
        return JoinAnimations(parts, path, settings, isStopped);
    }
    return JoinFFmpegFilms(parts, path, format, settings, isStopped);
}

} // namespace boxreel
