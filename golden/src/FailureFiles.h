// SPDX-License-Identifier: MIT
#pragma once

#include "Moment.h"
#include "VerdictFile.h"

#include <base/Result.h>

#include <filesystem>
#include <string>

/// What a comparison leaves under the output folder: its verdict and, when it failed, what a person
/// looks at. Used by the reference store and by golden checks; never touches the references.
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

    /// Those of an earlier comparison, so that nobody takes them for this one's.
    Result<void> Remove() const;

    /// The pictures and the lists of both moments as far as they have them; with both frames, the
    /// difference and all three side by side.
    Result<void> Write(const Moment& expected, const Moment& actual, const Frame& difference) const;

    Result<void> WriteVerdict(const VerdictRecord& record) const;

    /// What the verdict is of has become the reference.
    Result<void> NoteAccepted() const;

private:
    explicit FailureFiles(std::string base) : m_base(std::move(base)) {}
    std::string m_base; // the output folder and the name
};

} // namespace boxreel
