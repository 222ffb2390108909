// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Nearest.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace boxreel
{
namespace
{

/// What a kind of file's name may end in.
struct Formats
{
    std::vector<std::string> ends;
    const char* what;
};

Formats PictureFormats()
{
    return {{".png"}, "the one format pictures are written in"};
}

Formats FigureFormats()
{
    return {FigureEnds(), "the formats pictures are written in"};
}

Result<void> CheckEnd(const std::filesystem::path& path, const Formats& formats)
{
    const std::vector<std::string>& ends = formats.ends;
    const std::string end = path.extension().string();
    if (std::find(ends.begin(), ends.end(), end) != ends.end())
    {
        return {};
    }
    std::string message = "'";
    message.append(path.string()).append("' does not end in ");
    for (const std::string& known : ends)
    {
        message.append(&known == &ends.front() ? "" : &known == &ends.back() ? " or " : ", ");
        message.append(known);
    }
    const std::string question = DidYouMean(end, ends);
    message.append(", ").append(formats.what).append(question.empty() ? "." : "; " + question);
    return Error{ErrorKind::Unusable, message};
}

std::filesystem::path WholePath(const std::filesystem::path& path)
{
    std::error_code failure;
    // Absolute first: of what does not exist nothing else makes a relative name whole.
    const std::filesystem::path whole =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path, failure), failure);
    return failure ? path : whole;
}

Result<void> CheckPath(const std::filesystem::path& path, bool force, const Formats& formats)
{
    const std::string name = std::string("'").append(path.string()).append("'");
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored) || !path.has_filename())
    {
        return Error{ErrorKind::Unusable,
                     name + " is a folder; name a file in it, such as picture.png."};
    }
    RETURN_IF_ERROR(CheckEnd(path, formats));
    RETURN_IF_ERROR(CheckFolderOf(path));
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

std::vector<std::string> FigureEnds()
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

Result<void> CheckFolderOf(const std::filesystem::path& path)
{
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code ignored;
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
    return {};
}

Result<void> CheckPicturePath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, PictureFormats());
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
    return CheckPath(path, force, FigureFormats());
}

} // namespace boxreel
