// SPDX-License-Identifier: MIT
#include "ReferenceFiles.h"

#include <base/AtomicFile.h>
#include <base/ErrorMacros.h>
#include <base/Gzip.h>
#include <base/ReadWhole.h>
#include <base/Unusable.h>

#include <algorithm>
#include <system_error>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

// Leaves space for a suffix and ".part" in the 255 bytes that file systems allow.
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kPlainTextLimit = 4 * 1024;
constexpr std::size_t kLargestText = 64 * 1024 * 1024;

bool IsNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}

bool IsInside(const fs::path& root, const fs::path& path)
{
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

fs::path Packed(fs::path pathTxt)
{
    pathTxt += ".gz";
    return pathTxt;
}

} // namespace

std::string WhyNotUsable(const std::string& name)
{
    if (name.empty() || name.size() > kLongestName)
    {
        return "must have 1 to " + std::to_string(kLongestName) + " characters";
    }
    // Split at every slash, including the ends: an absolute name starts with an empty part.
    for (std::size_t begin = 0; begin <= name.size();)
    {
        const std::size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = std::string_view(name).substr(begin, end - begin);
        if (part.empty() || part.front() == '.')
        {
            return "has a part between slashes that is empty or starts with a dot";
        }
        if (!std::all_of(part.begin(), part.end(), IsNameCharacter))
        {
            return "may only contain a-z, 0-9, '.', '_', '-' and '/'";
        }
        begin = end + 1;
    }
    // A file being written is called so until it is whole.
    return name.ends_with(".part") ? "must not end with .part, the extension of unfinished files"
                                   : "";
}

Result<fs::path> PathInside(const fs::path& root, const fs::path& relative)
{
    fs::path here = root;
    for (const fs::path& part : relative)
    {
        here /= part;
        std::error_code code;
        if (!fs::is_symlink(fs::symlink_status(here, code)))
        {
            continue;
        }
        const fs::path realRoot = fs::canonical(root, code);
        const fs::path target = code ? fs::path() : fs::canonical(here, code);
        if (code || !IsInside(realRoot, target))
        {
            return Unusable(here.string(), "is a link to a place outside " + root.string(),
                            "remove it");
        }
    }
    return here;
}

Result<bool> IsFile(const fs::path& path)
{
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found)
    {
        return false;
    }
    if (code)
    {
        return Unusable(path.string(), "cannot be read: " + code.message(), "make it readable");
    }
    if (!fs::is_regular_file(status))
    {
        return Unusable(path.string(), "is not a regular file", "move it");
    }
    return true;
}

Result<std::optional<std::string>> ReadStoredText(const fs::path& root, const fs::path& relativeTxt)
{
    const Result<fs::path> plain = PathInside(root, relativeTxt);
    const Result<fs::path> packed = PathInside(root, Packed(relativeTxt));
    if (!plain || !packed)
    {
        return !plain ? plain.GetError() : packed.GetError();
    }
    const Result<bool> hasPlain = IsFile(*plain);
    const Result<bool> hasPacked = IsFile(*packed);
    if (!hasPlain || !hasPacked)
    {
        return !hasPlain ? hasPlain.GetError() : hasPacked.GetError();
    }
    if (*hasPlain && *hasPacked)
    {
        return Unusable(plain->string(), packed->filename().string() + " also exists",
                        "remove one of them");
    }
    if (!*hasPlain && !*hasPacked)
    {
        return std::optional<std::string>();
    }
    ASSIGN_OR_RETURN(std::string bytes, ReadWhole(*hasPlain ? *plain : *packed, kLargestText));
    if (*hasPlain)
    {
        return std::optional<std::string>(std::move(bytes));
    }
    Result<std::string> text = Gunzip(packed->string(), bytes, kLargestText);
    if (!text)
    {
        Error error = std::move(text).TakeError();
        error.remedy = "restore it";
        return error;
    }
    return std::optional<std::string>(*std::move(text));
}

Result<FileToWrite> StoredText(const fs::path& pathTxt, std::string text)
{
    if (text.size() <= kPlainTextLimit)
    {
        return FileToWrite{pathTxt, std::move(text)};
    }
    const fs::path path = Packed(pathTxt);
    ASSIGN_OR_RETURN(std::string packed, Gzip(path.string(), text));
    return FileToWrite{path, std::move(packed)};
}

Result<void> WriteAll(const std::vector<FileToWrite>& files)
{
    std::vector<AtomicFile> written;
    for (const FileToWrite& file : files)
    {
        std::error_code code;
        fs::create_directories(file.path.parent_path(), code);
        if (code)
        {
            return Unusable(file.path.parent_path().string(),
                            "cannot be created: " + code.message(), "choose another folder");
        }
        ASSIGN_OR_RETURN(AtomicFile opened, AtomicFile::Create(file.path, true));
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(file.bytes.data());
        RETURN_IF_ERROR(opened.Write({bytes, file.bytes.size()}));
        written.push_back(std::move(opened));
    }
    for (AtomicFile& file : written)
    {
        RETURN_IF_ERROR(file.Commit());
    }
    return {};
}

Result<void> RemoveFile(const fs::path& path)
{
    std::error_code code;
    fs::remove(path, code);
    if (code && code != std::errc::not_a_directory)
    {
        return Error{ErrorKind::Failed, path.string(), "cannot be removed: " + code.message()};
    }
    return {};
}

} // namespace boxreel
