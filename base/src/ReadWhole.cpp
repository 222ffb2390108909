// SPDX-License-Identifier: MIT
#include <base/Counting.h>
#include <base/ReadWhole.h>

#include <fstream>

namespace boxreel
{

Error FileNotFound(const std::filesystem::path& path)
{
    return Error{ErrorKind::Unusable, path.string(), "does not exist", "check the name"};
}

Result<std::string> ReadWhole(const std::filesystem::path& path, std::uintmax_t limit)
{
    const auto unusable = [&](const std::string& problem, const std::string& remedy) {
        return Error{ErrorKind::Unusable, path.string(), problem, remedy};
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
    {
        return FileNotFound(path);
    }
    if (error)
    {
        return unusable("cannot be read: " + error.message(), "");
    }
    if (!std::filesystem::is_regular_file(status))
    {
        return unusable("is not a regular file", "");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error || size > limit)
    {
        return unusable("is larger than " + SizeText(limit), "");
    }
    std::ifstream file(path, std::ios::binary);
    if (!file)
    {
        return unusable("cannot be opened", "check its permissions");
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
    {
        return Error{ErrorKind::Failed, path.string(), "cannot be read to its end",
                     "check the disk"};
    }
    return bytes;
}

} // namespace boxreel
