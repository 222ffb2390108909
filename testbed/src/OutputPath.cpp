// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <debugdraw/AtomicFile.h>

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace boxreel
{
namespace
{

constexpr const char* kChartFormats = ".png or .svg, the two formats charts are written in";

bool IsChartName(const std::filesystem::path& path)
{
    return path.extension() == ".png" || path.extension() == ".svg";
}

Error WrongEnd(const std::filesystem::path& path, const std::string& formats)
{
    return Error{ErrorKind::Unusable, std::string("'")
                                          .append(path.string())
                                          .append("' does not end in ")
                                          .append(formats)
                                          .append(".")};
}

/// `isFormat`: the name's end is one of those that can be written; `formats` says which these are.
Result<void> CheckPath(const std::filesystem::path& path, bool force, bool isFormat,
                       const std::string& formats)
{
    const std::string name = std::string("'").append(path.string()).append("'");
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored) || !path.has_filename())
    {
        return Error{ErrorKind::Unusable,
                     name + " is a folder; name a file in it, such as picture.png."};
    }
    if (!isFormat)
    {
        return WrongEnd(path, formats);
    }
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, ignored))
    {
        return Error{ErrorKind::Unusable,
                     "There is no folder '" + folder.string() + "'; create it first."};
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0)
    {
        return Error{ErrorKind::Failed, "Cannot write to the folder '" + folder.string() +
                                            "': " + std::strerror(errno) + "; choose another."};
    }
    if (!force && std::filesystem::exists(path, ignored))
    {
        return Error{ErrorKind::Unusable, name + " exists; --force overwrites it."};
    }
    // Permissions are not all: /proc has them and takes no file, as a full disk. What is made here
    // goes with its owner.
    const Result<AtomicFile> attempt = AtomicFile::Create(path, force);
    return attempt ? Result<void>() : Result<void>(attempt.GetError());
}

} // namespace

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

Result<void> CheckPicturePath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, path.extension() == ".png",
                     ".png, the one format pictures are written in");
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
    return CheckPath(path, force, PictureFormatOf(path).has_value(),
                     ".png, .svg or .pdf, the formats pictures are written in");
}

Result<void> CheckChartName(const std::filesystem::path& path)
{
    return IsChartName(path) ? Result<void>() : WrongEnd(path, kChartFormats);
}

Result<void> CheckChartPath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, IsChartName(path), kChartFormats);
}

Result<void> CheckNoneTwice(const std::vector<std::filesystem::path>& paths,
                            const std::string& option)
{
    const auto plain = [](const std::filesystem::path& path) {
        std::error_code failure;
        // Absolute first: of what does not exist nothing else makes a relative name whole.
        const std::filesystem::path whole =
            std::filesystem::weakly_canonical(std::filesystem::absolute(path, failure), failure);
        return failure ? path : whole;
    };
    for (auto later = paths.begin(); later != paths.end(); ++later)
    {
        for (auto earlier = paths.begin(); earlier != later; ++earlier)
        {
            if (plain(*earlier) == plain(*later))
            {
                return Error{ErrorKind::Unusable,
                             option + " names '" + later->string() + "' twice; give it once."};
            }
        }
    }
    return {};
}

} // namespace boxreel
