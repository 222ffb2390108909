// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace boxreel
{
namespace
{

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
        return Error{ErrorKind::Unusable, name + " does not end in " + formats + "."};
    }
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (!std::filesystem::is_directory(folder, ignored))
    {
        return Error{ErrorKind::Unusable,
                     "There is no folder '" + folder.string() + "'; create it first."};
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0)
    {
        return Error{ErrorKind::Unusable, "Cannot write to the folder '" + folder.string() +
                                              "': " + std::strerror(errno) + "; choose another."};
    }
    if (!force && std::filesystem::exists(path, ignored))
    {
        return Error{ErrorKind::Unusable, name + " exists; --force overwrites it."};
    }
    return {};
}

} // namespace

Result<void> CheckPicturePath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, path.extension() == ".png",
                     ".png, the one format pictures are written in");
}

Result<void> CheckChartPath(const std::filesystem::path& path, bool force)
{
    return CheckPath(path, force, path.extension() == ".png" || path.extension() == ".svg",
                     ".png or .svg, the two formats charts are written in");
}

} // namespace boxreel
