// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

/// @file
/// Files that appear under their name only when complete. Data is written to NAME.part.EXT in the
/// same folder; Commit renames it, and the destructor removes it otherwise. All writers of results
/// use it: pictures, films, texts. Never prompts or prints.
namespace boxreel
{

/// Options for creating a file and for handling an existing one.
struct AtomicFileSettings
{
    bool overwrite = false;         ///< false: an existing file is an Error
    std::string_view mark = "part"; ///< the temporary name is NAME.MARK.EXT
    bool replacesLeftover = true;   ///< false: a leftover part file is an Error too
    ErrorText leftoverRemedy{};     ///< remedy of that Error
};

/// A file that appears under its name only when complete.
class AtomicFile
{
public:
    /// Opens an empty part file for writing. An Error when `path` exists and `overwrite` is false,
    /// or is not a regular file. Also when its folder is not writable, or another process is
    /// writing it.
    static Result<AtomicFile> Create(const std::filesystem::path& path, bool overwrite);
    /// Same as above, with all settings and the same Errors.
    static Result<AtomicFile> Create(const std::filesystem::path& path,
                                     const AtomicFileSettings& settings);

    /// Leaves the source in a moved-from state.
    AtomicFile(AtomicFile&& other) noexcept;
    /// Leaves the source in a moved-from state.
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile(); ///< removes the part file unless it was committed

    /// Returns the path of the part file. A library that needs a file name may open and write it.
    const std::filesystem::path& PartPath() const { return m_part; }

    /// Appends all bytes. An Error (Failed) when the disk is full.
    Result<void> Write(std::span<const std::uint8_t> bytes);

    /// Writes at an offset [bytes], >= 0, for formats that complete earlier fields at the end.
    /// ReadAt and WriteAt do not change the position of Write. An Error (Failed) as in Write.
    Result<void> WriteAt(std::int64_t offset, std::span<const std::uint8_t> bytes);
    /// Reads from `offset` [bytes] and returns the number of bytes read. This is less than
    /// requested only at the end of the file. An Error (Failed) when reading fails.
    Result<std::size_t> ReadAt(std::int64_t offset, std::span<std::uint8_t> bytes) const;

    /// Flushes to the disk and renames. The object cannot be used afterwards. An Error when the
    /// disk is full, or when `overwrite` is false and the file was created meanwhile; that file is
    /// unchanged.
    Result<void> Commit();

    /// Flushes to the disk and keeps the part file. The object cannot be used afterwards. An Error
    /// (Failed) when the disk is full.
    Result<void> Leave();

    /// Renames the part file to NAME.`mark`.EXT, replacing an existing file. An Error when that
    /// fails.
    Result<void> Mark(std::string_view mark);

private:
    AtomicFile() = default;
    void Discard();

    std::filesystem::path m_path; // the final name
    std::filesystem::path m_part;
    bool m_overwrite = false;
    int m_descriptor = -1; // -1: committed or moved from
};

/// Checks that the folder of `path` exists and takes files, with the Errors of Create.
Result<void> CheckFolderOf(const std::filesystem::path& path);

/// Returns the path of a part file: dir/film.mp4 becomes dir/film.part.mp4. The extension stays,
/// because libraries choose the format by it.
std::filesystem::path PartPath(const std::filesystem::path& path, std::string_view mark = "part");

/// True if a process has this part file open as an AtomicFile. False where file locks are not
/// supported.
bool IsBeingWritten(const std::filesystem::path& part);

/// Creates, writes and commits a file, with the Errors of these functions.
Result<void> WriteWhole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                        bool overwrite);
/// Same as above, for text.
Result<void> WriteWhole(const std::filesystem::path& path, std::string_view text, bool overwrite);

} // namespace boxreel
