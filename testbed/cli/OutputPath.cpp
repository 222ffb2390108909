// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Nearest.h>
#include <base/Words.h>
#include <recorder/VideoWriter.h>

#include <algorithm>

namespace boxreel
{
namespace
{

Result<void> CheckExtension(const std::filesystem::path& path, const std::vector<std::string>& ends)
{
    const std::string end = path.extension().string();
    if (std::find(ends.begin(), ends.end(), end) != ends.end())
    {
        return {};
    }
    std::string all;
    for (const std::string& known : ends)
    {
        all.append(all.empty() ? "" : &known == &ends.back() ? " or " : ", ").append(known);
    }
    return Error{ErrorKind::Unusable, path.string(),
                 end.empty() ? "has no extension" : "unsupported extension " + end, "use " + all};
}

std::filesystem::path WholePath(const std::filesystem::path& path)
{
    std::error_code failure;
    // Made absolute first, because a relative name of a missing file cannot be resolved otherwise.
    const std::filesystem::path whole =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path, failure), failure);
    return failure ? path : whole;
}

Result<void> CheckPath(const std::filesystem::path& path, bool force,
                       const std::vector<std::string>& ends)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored) || !path.has_filename())
    {
        return Error{ErrorKind::Unusable, path.string(), "is a folder",
                     "name a file in it, such as picture.png"};
    }
    RETURN_IF_ERROR(CheckExtension(path, ends));
    if (!force && std::filesystem::exists(path, ignored))
    {
        return Error{ErrorKind::Unusable, path.string(), "already exists",
                     "use --force to overwrite it"};
    }
    // Permissions are not sufficient: /proc has them but accepts no file, like a full disk. The
    // trial file is removed with its owner.
    const Result<AtomicFile> attempt = AtomicFile::Create(path, force);
    return attempt ? Result<void>() : Result<void>(attempt.GetError());
}

} // namespace

std::vector<std::string> FigureExtensions()
{
    return {".png", ".svg", ".pdf"};
}

bool IsFrameOf(const std::filesystem::path& picture, const std::filesystem::path& film)
{
    const std::string pattern = film.filename().string();
    const std::string name = picture.filename().string();
    const std::size_t first = pattern.find('#');
    const std::size_t last = pattern.rfind('#');
    std::error_code ignored;
    const auto folder = [&](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path).parent_path(),
                                                 ignored);
    };
    if (first == std::string::npos || folder(picture) != folder(film))
    {
        return false;
    }
    const std::string before = pattern.substr(0, first);
    const std::string behind = pattern.substr(last + 1);
    const std::size_t around = before.size() + behind.size();
    if (name.size() < around + (last + 1 - first) || !name.starts_with(before) ||
        !name.ends_with(behind))
    {
        return false;
    }
    const std::string number = name.substr(before.size(), name.size() - around);
    return number.find_first_not_of("0123456789") == std::string::npos;
}

bool IsSameFile(const std::filesystem::path& a, const std::filesystem::path& b)
{
    return WholePath(a) == WholePath(b) || IsFrameOf(a, b) || IsFrameOf(b, a);
}

std::vector<std::string> FilmExtensions()
{
    std::vector<std::string> all = VideoEnds();
    all.emplace_back(".png");
    return all;
}

std::vector<std::string> RecordExtensions()
{
    std::vector<std::string> all = FilmExtensions();
    all.emplace_back(".html");
    return all;
}

Result<void> CheckRecordExtension(const std::filesystem::path& path)
{
    const std::string end = Lower(path.extension().string());
    const std::vector<std::string> ends = RecordExtensions();
    const bool isForOthers = path == "-" || path.stem().empty();
    if (isForOthers || std::find(ends.begin(), ends.end(), end) != ends.end())
    {
        return {};
    }
    return Error{ErrorKind::Unusable, path.string(),
                 end.empty() ? "has no extension"
                             : "unsupported extension " + path.extension().string(),
                 DidYouMean(end, ends,
                            "use " + JoinedBy(", ", VideoEnds()) +
                                ", .html or a name like frames-####.png")};
}

Result<void> CheckPicturePath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, {".png"});
}

std::optional<PictureFormat> PictureFormatOf(const std::filesystem::path& path)
{
    const std::string end = path.extension().string();
    return end == ".png"   ? std::optional(PictureFormat::Png)
           : end == ".svg" ? std::optional(PictureFormat::Svg)
           : end == ".pdf" ? std::optional(PictureFormat::Pdf)
                           : std::nullopt;
}

Result<void> CheckFigurePath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, FigureExtensions());
}

/// Unfinished films end in .part.EXT, so a finished one cannot.
Result<void> CheckFilmName(const std::filesystem::path& film)
{
    return film.stem().extension() == ".part"
               ? Error{ErrorKind::Unusable, "-o " + film.string(),
                       "is reserved for unfinished films", "choose a name without .part"}
               : Result<void>();
}

} // namespace boxreel
