// SPDX-License-Identifier: MIT
#include <base/AtomicFile.h>

#include <base/ErrorMacros.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

Error CannotWrite(ErrorKind kind, const fs::path& path, const std::string& problem,
                  const ErrorText& remedy)
{
    return Error{kind, path.string(), "cannot be written: " + problem, remedy};
}

// A full disk, an I/O error or a lock is Failed; all other errors of opening are caused by the
// name.
Error CannotOpen(const fs::path& path, int code)
{
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    switch (code)
    {
    case ENOENT: {
        // The folder exists but does not accept files, as /proc.
        std::error_code ignored;
        const bool isThere = fs::is_directory(folder, ignored);
        return CannotWrite(ErrorKind::Unusable, path,
                           "the folder " + folder.string() +
                               (isThere ? " does not accept files" : " does not exist"),
                           isThere ? "choose another folder"
                                   : "create it or choose another folder");
    }
    case ENOTDIR:
        return CannotWrite(ErrorKind::Unusable, path, folder.string() + " is not a folder",
                           "choose another folder");
    case EACCES:
    case EPERM:
    case EROFS:
        return CannotWrite(ErrorKind::Failed, path,
                           "no permission to write in the folder " + folder.string(),
                           "choose another folder");
    case ENAMETOOLONG:
        return CannotWrite(ErrorKind::Unusable, path, "the name is too long",
                           "choose a shorter name");
    case ENOSPC:
    case EDQUOT:
        return CannotWrite(ErrorKind::Failed, path, "the disk is full", "free some space");
    default:
        return CannotWrite(ErrorKind::Failed, path, std::generic_category().message(code),
                           "check the disk");
    }
}

Error CannotFinish(const fs::path& path, int code)
{
    const bool isFull = code == ENOSPC || code == EDQUOT || code == EFBIG;
    return CannotWrite(ErrorKind::Failed, path,
                       isFull ? "the disk is full, or the file is too large"
                              : std::generic_category().message(code),
                       isFull ? "free some space" : "check the disk");
}

Error AlreadyExists(const fs::path& path)
{
    return CannotWrite(
        ErrorKind::Unusable, path, "it already exists",
        ErrorText::AnyOf(
            {"choose another name",
             "allow overwriting (" +
                 ErrorSetting{BOXREEL_MEMBER(AtomicFileSettings, overwrite), {"true"}} + ")"}));
}

Error PartExists(const fs::path& path, const fs::path& part)
{
    return CannotWrite(ErrorKind::Unusable, path,
                       part.string() + ", its temporary name, is a folder, a link or a device",
                       "move that file or choose another name");
}

// Opens and locks the part file. The previous owner of the lock may have renamed or removed the
// file meanwhile. Then the descriptor and the name differ, and the attempt is repeated.
Result<int> OpenLocked(const fs::path& part, const fs::path& path,
                       const AtomicFileSettings& settings)
{
    for (int attempt = 0; attempt < 100; ++attempt)
    {
        // O_NONBLOCK: opening a pipe would wait for the other end.
        const int descriptor =
            ::open(part.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
        if (descriptor < 0)
        {
            const bool isOther = errno == EISDIR || errno == ELOOP || errno == ENXIO;
            return isOther ? PartExists(path, part) : CannotOpen(path, errno);
        }
        // File systems without locks return another code; concurrent writers are then not detected.
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
        {
            ::close(descriptor);
            return CannotWrite(ErrorKind::Failed, path,
                               "another program is writing it (" + part.string() + ")",
                               "wait for it or choose another name");
        }
        struct stat opened = {};
        struct stat named = {};
        if (::fstat(descriptor, &opened) == 0 && !S_ISREG(opened.st_mode))
        {
            ::close(descriptor);
            return PartExists(path, part);
        }
        if (::fstat(descriptor, &opened) == 0 && ::stat(part.c_str(), &named) == 0 &&
            opened.st_dev == named.st_dev && opened.st_ino == named.st_ino)
        {
            if (!settings.replacesLeftover && opened.st_size > 0)
            {
                ::close(descriptor);
                return CannotWrite(ErrorKind::Unusable, path,
                                   part.string() + " was left by a stopped run",
                                   settings.leftoverRemedy);
            }
            if (::ftruncate(descriptor, 0) == 0)
            {
                return descriptor;
            }
            const int code = errno;
            ::close(descriptor);
            return CannotOpen(path, code);
        }
        ::close(descriptor);
    }
    return CannotWrite(ErrorKind::Failed, path, "other programs keep writing it",
                       "choose another name");
}

// Renames without replacing, where the file system supports it; returns 0 or an errno.
int Rename(const fs::path& from, const fs::path& to, bool overwrite)
{
#ifdef RENAME_NOREPLACE
    if (!overwrite)
    {
        if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0)
        {
            return 0;
        }
        if (errno != EINVAL && errno != ENOSYS)
        {
            return errno;
        }
    }
#endif
    std::error_code ignored;
    if (!overwrite && fs::exists(fs::symlink_status(to, ignored)))
    {
        return EEXIST;
    }
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

} // namespace

Result<void> CheckFolderOf(const fs::path& path)
{
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code code;
    if (fs::exists(folder, code) && !fs::is_directory(folder, code))
    {
        return CannotOpen(path, ENOTDIR);
    }
    const bool takesFiles = ::access(folder.c_str(), W_OK | X_OK) == 0;
    return takesFiles ? Result<void>() : CannotOpen(path, errno);
}

std::filesystem::path PartPath(const std::filesystem::path& path, std::string_view mark)
{
    fs::path part = path;
    part.replace_filename(path.stem().string() + "." + std::string(mark) +
                          path.extension().string());
    return part;
}

bool IsBeingWritten(const std::filesystem::path& part)
{
    const int descriptor = ::open(part.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
    {
        return false;
    }
    const bool isLocked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(descriptor);
    return isLocked;
}

Result<AtomicFile> AtomicFile::Create(const std::filesystem::path& path, bool overwrite)
{
    return Create(path, {.overwrite = overwrite});
}

Result<AtomicFile> AtomicFile::Create(const std::filesystem::path& path,
                                      const AtomicFileSettings& settings)
{
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    if (!path.has_filename())
    {
        return CannotWrite(ErrorKind::Unusable, path.empty() ? fs::path("''") : path,
                           "is not a file name", "add a file name");
    }
    if (fs::is_directory(status))
    {
        return CannotWrite(ErrorKind::Unusable, path, "is a folder", "add a file name");
    }
    if (fs::exists(status) && !fs::is_regular_file(status))
    {
        return CannotWrite(ErrorKind::Unusable, path, "is a device or a pipe",
                           "choose the name of a regular file");
    }
    if (!settings.overwrite && fs::exists(fs::symlink_status(path, ignored)))
    {
        return AlreadyExists(path);
    }
    AtomicFile file;
    file.m_path = path;
    if (fs::is_symlink(fs::symlink_status(path, ignored)))
    {
        // Keep a symbolic link and replace its target.
        file.m_path = fs::weakly_canonical(path, ignored);
        file.m_path = ignored ? path : file.m_path;
    }
    file.m_part = boxreel::PartPath(file.m_path, settings.mark);
    file.m_overwrite = settings.overwrite;
    ASSIGN_OR_RETURN(int descriptor, OpenLocked(file.m_part, path, settings));
    file.m_descriptor = descriptor;
    return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : m_path(std::move(other.m_path)), m_part(std::move(other.m_part)),
      m_overwrite(other.m_overwrite), m_descriptor(std::exchange(other.m_descriptor, -1))
{}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept
{
    if (this != &other)
    {
        Discard();
        m_path = std::move(other.m_path);
        m_part = std::move(other.m_part);
        m_overwrite = other.m_overwrite;
        m_descriptor = std::exchange(other.m_descriptor, -1);
    }
    return *this;
}

AtomicFile::~AtomicFile()
{
    Discard();
}

void AtomicFile::Discard()
{
    if (m_descriptor >= 0)
    {
        // Remove before releasing the lock, so that another process's part file is not removed.
        ::unlink(m_part.c_str());
        ::close(std::exchange(m_descriptor, -1));
    }
}

Result<void> AtomicFile::Write(std::span<const std::uint8_t> bytes)
{
    assert(m_descriptor >= 0 && "AtomicFile::Write after Commit");
    while (!bytes.empty())
    {
        const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
        {
            return CannotFinish(m_path, errno);
        }
        bytes = bytes.subspan(static_cast<std::size_t>(written < 0 ? 0 : written));
    }
    return {};
}

Result<void> AtomicFile::WriteAt(std::int64_t offset, std::span<const std::uint8_t> bytes)
{
    assert(m_descriptor >= 0 && "AtomicFile::WriteAt after Commit");
    while (!bytes.empty())
    {
        const ssize_t written = ::pwrite(m_descriptor, bytes.data(), bytes.size(), offset);
        if (written < 0 && errno != EINTR)
        {
            return CannotFinish(m_path, errno);
        }
        const std::size_t done = static_cast<std::size_t>(written < 0 ? 0 : written);
        bytes = bytes.subspan(done);
        offset += static_cast<std::int64_t>(done);
    }
    return {};
}

Result<std::size_t> AtomicFile::ReadAt(std::int64_t offset, std::span<std::uint8_t> bytes) const
{
    assert(m_descriptor >= 0 && "AtomicFile::ReadAt after Commit");
    while (true)
    {
        const ssize_t got = ::pread(m_descriptor, bytes.data(), bytes.size(), offset);
        if (got >= 0)
        {
            return static_cast<std::size_t>(got);
        }
        if (errno != EINTR)
        {
            return CannotFinish(m_path, errno);
        }
    }
}

Result<void> AtomicFile::Commit()
{
    assert(m_descriptor >= 0 && "AtomicFile::Commit twice");
    // Without the flush, a power failure could leave the final name on an empty file.
    if (::fsync(m_descriptor) != 0 && errno != EINVAL)
    {
        return CannotFinish(m_path, errno);
    }
    const int code = Rename(m_part, m_path, m_overwrite);
    if (code == EEXIST)
    {
        return AlreadyExists(m_path);
    }
    if (code != 0)
    {
        return CannotFinish(m_path, code);
    }
    ::close(std::exchange(m_descriptor, -1));
    return {};
}

Result<void> AtomicFile::Leave()
{
    assert(m_descriptor >= 0 && "AtomicFile::Leave after Commit");
    if (::fsync(m_descriptor) != 0 && errno != EINVAL)
    {
        return CannotFinish(m_path, errno);
    }
    ::close(std::exchange(m_descriptor, -1));
    return {};
}

Result<void> AtomicFile::Mark(std::string_view mark)
{
    const fs::path part = boxreel::PartPath(m_path, mark);
    if (::rename(m_part.c_str(), part.c_str()) != 0)
    {
        return CannotFinish(m_path, errno);
    }
    m_part = part;
    return {};
}

Result<void> WriteWhole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                        bool overwrite)
{
    ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(path, overwrite));
    const Result<void> written = file.Write(bytes);
    return written ? file.Commit() : written;
}

Result<void> WriteWhole(const std::filesystem::path& path, std::string_view text, bool overwrite)
{
    return WriteWhole(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()},
                      overwrite);
}

} // namespace boxreel
