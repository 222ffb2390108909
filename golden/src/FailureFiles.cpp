// SPDX-License-Identifier: MIT
#include "FailureFiles.h"

#include <base/ErrorMacros.h>
#include <base/ReadWhole.h>
#include <golden/Compare.h>
#include <render/Png.h>

#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

constexpr const char* kExpectedPng = ".expected.png";
constexpr const char* kActualPng = ".actual.png";
constexpr const char* kDifferencePng = ".difference.png";
constexpr const char* kSideBySidePng = ".side-by-side.png";
constexpr const char* kExpectedTxt = ".expected.txt";
constexpr const char* kActualTxt = ".actual.txt";

constexpr const char* kExpectedState = ".expected.state.txt";
constexpr const char* kActualState = ".actual.state.txt";

constexpr const char* kVerdict = ".verdict.json";
constexpr std::uintmax_t kLargestVerdict = 1u << 20; // [bytes]

constexpr const char* kAll[] = {kExpectedPng,   kActualPng,   kDifferencePng,
                                kSideBySidePng, kExpectedTxt, kActualTxt,
                                kExpectedState, kActualState, kVerdict};

} // namespace

Result<FailureFiles> FailureFiles::At(const std::filesystem::path& output, const std::string& name)
{
    for (const char* suffix : kAll)
    {
        RETURN_IF_ERROR(PathInside(output, name + suffix));
    }
    return FailureFiles((output / name).string());
}

std::string FailureFiles::ActualPicture() const
{
    return m_base + kActualPng;
}

std::string FailureFiles::SideBySidePicture() const
{
    return m_base + kSideBySidePng;
}

std::string FailureFiles::ExpectedList() const
{
    return m_base + kExpectedTxt;
}

std::string FailureFiles::ActualList() const
{
    return m_base + kActualTxt;
}

Result<void> FailureFiles::Remove() const
{
    for (const char* suffix : kAll)
    {
        RETURN_IF_ERROR(RemoveFile(m_base + suffix));
    }
    return {};
}

Result<void> FailureFiles::WriteVerdict(const VerdictRecord& record) const
{
    return WriteAll({{m_base + kVerdict, ToJson(record)}});
}

Result<void> FailureFiles::NoteAccepted() const
{
    ASSIGN_OR_RETURN(const std::string json, ReadWhole(m_base + kVerdict, kLargestVerdict));
    std::optional<std::string> accepted = Accepted(json);
    if (!accepted)
    {
        return {};
    }
    return WriteAll({{m_base + kVerdict, *std::move(accepted)}});
}

Result<void> FailureFiles::Write(const Moment& expected, const Moment& actual,
                                 const Frame& difference) const
{
    std::vector<std::pair<const char*, const Frame*>> pictures;
    Frame sideBySide;
    if (actual.frame)
    {
        pictures.emplace_back(kActualPng, &*actual.frame);
    }
    if (expected.frame)
    {
        pictures.emplace_back(kExpectedPng, &*expected.frame);
    }
    if (expected.frame && actual.frame)
    {
        sideBySide = SideBySide(*expected.frame, *actual.frame, difference);
        pictures.emplace_back(kDifferencePng, &difference);
        pictures.emplace_back(kSideBySidePng, &sideBySide);
    }
    std::vector<FileToWrite> files;
    for (const auto& [suffix, frame] : pictures)
    {
        // A frame without pixels has no PNG file; the missing file shows the same.
        if (frame->rgba.empty())
        {
            continue;
        }
        ASSIGN_OR_RETURN(FileToWrite file,
                         Picture(m_base + suffix, *frame, PngSettings{}.compressionLevel));
        files.push_back(std::move(file));
    }
    if (expected.list)
    {
        files.push_back({m_base + kExpectedTxt, *expected.list});
    }
    if (actual.list)
    {
        files.push_back({m_base + kActualTxt, *actual.list});
    }
    for (const auto& [suffix, moment] :
         {std::pair(kExpectedState, &expected), {kActualState, &actual}})
    {
        if (moment->state && !moment->bodies.bodies.empty())
        {
            files.push_back({m_base + suffix, *moment->state + "\n" + ToText(moment->bodies)});
        }
    }
    return WriteAll(files);
}

} // namespace boxreel
