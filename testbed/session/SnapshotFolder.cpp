// SPDX-License-Identifier: MIT
#include "SnapshotFolder.h"

#include <base/AtomicFile.h>
#include <base/Bytes.h>
#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>
#include <base/Terminal.h>
#include <options/OptionNames.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace boxreel
{
namespace
{

// Version of the file format, in its heading. Increase it with every change of a state's content.
constexpr const char* kFormat = "boxreel snapshot 1";

// Parts of a film begin with a group of frames, 100 unless the user says otherwise.
constexpr std::int64_t kFirstGap = 100;
// The gap is doubled when the simulation is this many gaps long. With more there are more files,
// with fewer more steps are simulated again.
constexpr std::int64_t kGapsInWay = 32;

// A larger file is not a snapshot: 100,000 bodies in a contact island have about 100 MB.
constexpr std::uintmax_t kMaxBytes = 4'000'000'000;

constexpr const char* kExtension = ".snapshot";
constexpr int kStepDigits = 10;

/// Returns the mark of incomplete files of this machine.
std::string HostMark()
{
    char host[256] = "";
    ::gethostname(host, sizeof host - 1);
    return "part-" + SceneSlug(host) + "-";
}

/// A name that no other process has, wherever it runs.
std::string OwnMark()
{
    return HostMark() + std::to_string(::getpid());
}

/// True for the incomplete file of a killed run. Only the same machine can tell whether a file is
/// being written, and only some time after its creation.
bool IsLeftover(const std::filesystem::directory_entry& entry)
{
    constexpr std::chrono::minutes kMoment{1};
    const std::string name = entry.path().filename().string();
    std::error_code error;
    const auto age = std::filesystem::file_time_type::clock::now() - entry.last_write_time(error);
    return !error && name.ends_with(kExtension) &&
           name.find("." + HostMark()) != std::string::npos && age > kMoment &&
           !IsBeingWritten(entry.path());
}

void RemoveLeftovers(const std::filesystem::path& folder)
{
    std::error_code error;
    std::vector<std::filesystem::path> leftovers;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error))
    {
        if (IsLeftover(*entry))
        {
            leftovers.push_back(entry->path());
        }
    }
    for (const std::filesystem::path& leftover : leftovers)
    {
        std::filesystem::remove(leftover, error);
    }
}

std::string WithDigits(std::int64_t step)
{
    char text[32];
    std::snprintf(text, sizeof text, "%0*lld", kStepDigits, static_cast<long long>(step));
    return text;
}

std::span<const std::uint8_t> BytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The last line of the heading.
std::string SumLine(std::span<const std::uint8_t> state)
{
    return "bytes " + std::to_string(state.size()) + " " + HexText(ChecksumOf(state)) + "\n";
}

} // namespace

bool IsSnapshotDue(std::int64_t step, std::optional<std::int64_t> every)
{
    std::int64_t gap = every.value_or(kFirstGap);
    while (!every && gap <= step / kGapsInWay)
    {
        gap *= 2;
    }
    return step > 0 && step % gap == 0;
}

Result<SnapshotFolder> SnapshotFolder::Open(const std::filesystem::path& folder,
                                            std::optional<std::int64_t> every)
{
    std::error_code error;
    const std::string culprit = "--snapshots " + folder.string();
    std::filesystem::create_directory(folder, error);
    if (!std::filesystem::is_directory(folder, error))
    {
        const std::filesystem::path parent = std::filesystem::absolute(folder, error).parent_path();
        const bool isMisnamed =
            std::filesystem::exists(folder, error) || !std::filesystem::is_directory(parent, error);
        return Error{isMisnamed ? ErrorKind::Unusable : ErrorKind::Failed, culprit,
                     "is not a folder and cannot be created",
                     "choose a new name in an existing folder"};
    }
    const Result<AtomicFile> attempt =
        AtomicFile::Create(folder / "attempt", {.overwrite = true, .mark = OwnMark()});
    if (!attempt)
    {
        return Error{ErrorKind::Failed, culprit, "is not writable",
                     "choose another folder or check permissions and disk"};
    }
    RemoveLeftovers(folder);
    return SnapshotFolder(folder, every);
}

std::filesystem::path SnapshotFolder::PathOf(std::int64_t step) const
{
    return m_folder / (m_name + WithDigits(step) + kExtension);
}

/// Returns the steps of the existing files.
std::set<std::int64_t> SnapshotFolder::Steps() const
{
    std::set<std::int64_t> steps;
    std::error_code error;
    for (std::filesystem::directory_iterator entry(m_folder, error), end; !error && entry != end;
         entry.increment(error))
    {
        const std::string name = entry->path().filename().string();
        const std::string digits =
            name.starts_with(m_name) ? name.substr(m_name.size(), kStepDigits) : "";
        const bool isNumber =
            !digits.empty() &&
            std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (isNumber && name == m_name + digits + kExtension)
        {
            steps.insert(std::stoll(digits));
        }
    }
    return steps;
}

/// Returns the heading before the state, without its last line. It is readable, and compared as a
/// whole.
std::string SnapshotFolder::Heading(std::int64_t step) const
{
    std::string heading = kFormat;
    heading += "\nversion " BOXREEL_VERSION "\n" + m_origin;
    heading += "step " + std::to_string(step) + "\n";
    return heading;
}

/// Empty when the session has gone on from the file.
std::string SnapshotFolder::WhyNot(SceneSession& session, std::int64_t step) const
{
    const Result<std::string> read = ReadWhole(PathOf(step), kMaxBytes);
    const std::string file = read ? *read : "";
    const std::string heading = Heading(step);
    const std::size_t versionEnds = heading.find(m_origin);
    if (file.empty())
    {
        return "is empty or cannot be read";
    }
    if (!file.starts_with(heading.substr(0, versionEnds)))
    {
        return "is not a snapshot of this version of boxreel";
    }
    if (!file.starts_with(heading))
    {
        return "belongs to another film";
    }
    const std::size_t sumEnds = std::min(file.find('\n', heading.size()), file.size() - 1) + 1;
    const auto state = BytesOf(file).subspan(sumEnds);
    if (file.substr(heading.size(), sumEnds - heading.size()) != SumLine(state) ||
        !session.RestoreState(state))
    {
        return "is damaged";
    }
    return "";
}

void SnapshotFolder::Begin(SceneSession& session, std::int64_t latest)
{
    m_origin = session.DescribeOrigin();
    m_name = SceneSlug(session.Title()).substr(0, 40) + "-" + HexText(ChecksumOf(m_origin)) + "-";
    const std::set<std::int64_t> steps = Steps();
    for (auto step = steps.upper_bound(latest); step != steps.begin();)
    {
        --step;
        const std::string why = WhyNot(session, *step);
        if (why.empty())
        {
            return;
        }
        if (m_broken.empty())
        {
            WriteMessage("boxreel: " + PathOf(*step).string() + " " + why +
                         "; it is ignored and written again.");
        }
        m_broken.insert(*step);
    }
}

Result<void> SnapshotFolder::Write(SceneSession& session) const
{
    ASSIGN_OR_RETURN(AtomicFile file, AtomicFile::Create(PathOf(session.Step()),
                                                         {.overwrite = true, .mark = OwnMark()}));
    const std::vector<std::uint8_t> state = session.SaveState();
    const std::string heading = Heading(session.Step()) + SumLine(state);
    for (const std::span<const std::uint8_t> bytes : {BytesOf(heading), std::span(state)})
    {
        RETURN_IF_ERROR(file.Write(bytes));
    }
    return file.Commit();
}

void SnapshotFolder::Offer(SceneSession& session)
{
    const std::int64_t step = session.Step();
    const bool isBroken = m_broken.count(step) > 0;
    std::error_code ignored;
    if (m_isFull || !(isBroken || (IsSnapshotDue(step, m_every) &&
                                   !std::filesystem::exists(PathOf(step), ignored))))
    {
        return;
    }
    if (const Result<void> written = Write(session); !written)
    {
        WriteMessage("boxreel: " + TextInOptions(written.GetError()) +
                     " This run writes no more snapshots.");
        m_isFull = true;
    }
}

} // namespace boxreel
