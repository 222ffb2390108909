// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

/// @file
/// Temporary folders of a command, below TMPDIR.
namespace boxreel
{

/// A temporary folder, removed with its content.
class WorkFolder
{
public:
    /// Creates an empty folder below TMPDIR. An Error (Failed) if it cannot be written.
    static Result<WorkFolder> Create()
    {
        std::error_code error;
        const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
        std::string pattern = (parent / "boxreel-XXXXXX").string();
        if (error || mkdtemp(pattern.data()) == nullptr)
        {
            return Error{ErrorKind::Failed, "TMPDIR",
                         "no folder for temporary files can be created",
                         "set it to a writable folder"};
        }
        return WorkFolder(pattern);
    }
    /// Takes the folder over.
    WorkFolder(WorkFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}
    WorkFolder& operator=(WorkFolder&&) = delete;
    ~WorkFolder()
    {
        std::error_code ignored;
        if (!m_path.empty())
        {
            std::filesystem::remove_all(m_path, ignored);
        }
    }
    /// Returns the folder; empty after a move.
    const std::filesystem::path& Path() const { return m_path; }

private:
    explicit WorkFolder(std::filesystem::path path) : m_path(std::move(path)) {}
    std::filesystem::path m_path;
};

} // namespace boxreel
