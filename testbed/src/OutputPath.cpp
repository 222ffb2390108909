// SPDX-License-Identifier: MIT
#include "OutputPath.h"

#include <cerrno>
#include <cstring>
#include <unistd.h>

namespace boxreel
{

Result<void> CheckPicturePath(const std::filesystem::path& path, bool force)
{
    const std::string name = std::string("'").append(path.string()).append("'");
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored) || !path.has_filename())
    {
        return Error{ErrorKind::Unusable,
                     name + " is a folder; name a file in it, such as picture.png."};
    }
    if (path.extension() != ".png")
    {
        return Error{ErrorKind::Unusable,
                     name + " does not end in .png, the one format pictures are written in."};
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

} // namespace boxreel
