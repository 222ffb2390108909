// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

/// @file
/// Files that appear under their name whole or not at all. What is written goes to NAME.part.EXT in
/// the same folder and gets its name by Commit; what is not committed is removed. Used by
/// everything that writes results: pictures, films, texts. Never asks, never prints.
namespace boxreel
{

/// How a file is made and what becomes of one that is there.
struct AtomicFileSettings
{
    bool overwrite = false;         ///< false: an existing file is an Error
    std::string_view mark = "part"; ///< NAME.MARK.EXT is what it is called until Commit
    bool replacesLeftover = true;   ///< false: a part file that somebody left is an Error, too
};

/// A file that appears under its name only when it is whole.
class AtomicFile
{
public:
    /// Opens the part file for writing, empty. An Error when `path` exists and `overwrite` is
    /// false, is not a regular file, lies in a folder that cannot be written, or is being written
    /// by someone else.
    static Result<AtomicFile> Create(const std::filesystem::path& path, bool overwrite);
    /// The same, with more to say, and the same Errors.
    static Result<AtomicFile> Create(const std::filesystem::path& path,
                                     const AtomicFileSettings& settings);

    /// The other may only be assigned to or destroyed.
    AtomicFile(AtomicFile&& other) noexcept;
    /// The other may only be assigned to or destroyed.
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile(); ///< removes the part file unless it was committed

    /// Where the bytes are until then. A library that wants a name may open and write it itself.
    const std::filesystem::path& PartPath() const { return m_part; }

    /// Appends all of the bytes. An Error (Failed) when the disk takes less.
    Result<void> Write(std::span<const std::uint8_t> bytes);

    /// For formats that go back to fill in what they know only at the end. Neither moves the place
    /// where Write goes on. An Error (Failed) as of Write. `offset`: from the beginning, 0 or more
    /// [bytes].
    Result<void> WriteAt(std::int64_t offset, std::span<const std::uint8_t> bytes);
    /// How many bytes were read, from `offset` on [bytes]: fewer than were asked for at the end of
    /// the file. An Error (Failed) when the disk does not give them.
    Result<std::size_t> ReadAt(std::int64_t offset, std::span<std::uint8_t> bytes) const;

    /// Flushes to the disk and renames. Nothing may follow. An Error when the disk takes less, or
    /// when `overwrite` is false and a file of the name has come meanwhile; the name is then left
    /// as it was.
    Result<void> Commit();

    /// Flushes to the disk and leaves the part file as it is. Nothing may follow. An Error (Failed)
    /// when the disk takes less.
    Result<void> Leave();

    /// Calls the part file NAME.`mark`.EXT from now on, in place of whatever had that name. An
    /// Error when it cannot be renamed.
    Result<void> Mark(std::string_view mark);

private:
    AtomicFile() = default;
    void Discard();

    std::filesystem::path m_path; // the final name
    std::filesystem::path m_part;
    bool m_overwrite = false;
    int m_descriptor = -1; // -1: committed or moved from
};

/// dir/film.mp4 becomes dir/film.part.mp4: the extension stays, since libraries go by it.
std::filesystem::path PartPath(const std::filesystem::path& path, std::string_view mark = "part");

/// Whether some program has this part file open as an AtomicFile. False where there are no locks.
bool IsBeingWritten(const std::filesystem::path& part);

/// Create, Write and Commit in one, with their Errors.
Result<void> WriteWhole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                        bool overwrite);
/// The same for text.
Result<void> WriteWhole(const std::filesystem::path& path, std::string_view text, bool overwrite);

} // namespace boxreel
