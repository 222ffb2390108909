// SPDX-License-Identifier: MIT
#pragma once

#include "Moment.h"
#include "VerdictFile.h"

#include <base/Result.h>

#include <filesystem>
#include <string>

/// The files of a comparison in the output folder: its verdict and, for a failure, pictures and
/// texts. Used by the reference store and by golden checks; never changes references.
namespace boxreel
{

class FailureFiles
{
public:
    /// An Error when a link in the folder leads out of it.
    static Result<FailureFiles> At(const std::filesystem::path& output, const std::string& name);

    std::string ActualPicture() const;
    std::string SideBySidePicture() const;
    std::string ExpectedList() const;
    std::string ActualList() const;

    /// Removes the files of an earlier comparison, to avoid confusion with this one.
    Result<void> Remove() const;

    /// Writes the pictures and lists that both moments have; with both frames also the difference
    /// and all three side by side.
    Result<void> Write(const Moment& expected, const Moment& actual, const Frame& difference) const;

    Result<void> WriteVerdict(const VerdictRecord& record) const;

    /// Records in the verdict that the candidate was accepted.
    Result<void> NoteAccepted() const;

private:
    explicit FailureFiles(std::string base) : m_base(std::move(base)) {}
    std::string m_base; // path prefix: output folder and name
};

} // namespace boxreel
