// SPDX-License-Identifier: MIT
#include "Moment.h"

#include <debugdraw/DrawListText.h>
#include <render/Png.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* kState = "state";
constexpr const char* kDrawList = "drawlist";
constexpr const char* kFrames = "frames";
// Written once and kept for years: as small as it gets.
constexpr int kReferenceCompression = 9;

fs::path Relative(const char* depth, const std::string& name, const char* extension)
{
    return fs::path(depth) / (name + extension);
}

Result<std::optional<std::string>> ReadState(const fs::path& root, const std::string& name)
{
    const Result<fs::path> path = PathInside(root, Relative(kState, name, ".txt"));
    if (!path)
    {
        return path.GetError();
    }
    const Result<bool> isThere = IsFile(*path);
    if (!isThere)
    {
        return isThere.GetError();
    }
    if (!*isThere)
    {
        return std::optional<std::string>();
    }
    Result<std::string> text = ReadBytes(*path);
    if (!text)
    {
        return text.GetError();
    }
    const auto isDigit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    if (text->size() != 17 || text->back() != '\n' ||
        !std::all_of(text->begin(), text->end() - 1, isDigit))
    {
        return Error{ErrorKind::Unusable, path->string() +
                                              " does not hold a state of 16 hex digits; "
                                              "restore it or accept it again."};
    }
    text->pop_back();
    return std::optional<std::string>(*std::move(text));
}

Result<std::optional<Frame>> ReadFrame(const fs::path& root, const std::string& name)
{
    const Result<fs::path> path = PathInside(root, Relative(kFrames, name, ".png"));
    if (!path)
    {
        return path.GetError();
    }
    const Result<bool> isThere = IsFile(*path);
    if (!isThere)
    {
        return isThere.GetError();
    }
    if (!*isThere)
    {
        return std::optional<Frame>();
    }
    Result<Frame> frame = ReadPng(*path);
    if (!frame)
    {
        return frame.GetError();
    }
    return std::optional<Frame>(*std::move(frame));
}

void CollectNames(const fs::path& folder, std::initializer_list<std::string_view> extensions,
                  std::set<std::string>& names)
{
    std::error_code code;
    for (fs::recursive_directory_iterator
             entry(folder, fs::directory_options::skip_permission_denied, code),
         end;
         !code && entry != end; entry.increment(code))
    {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored))
        {
            continue;
        }
        const std::string name = entry->path().lexically_relative(folder).generic_string();
        for (const std::string_view extension : extensions)
        {
            const std::string stem =
                name.substr(0, name.size() - std::min(extension.size(), name.size()));
            if (name.ends_with(extension) && WhyNotUsable(stem).empty())
            {
                names.insert(stem);
                break;
            }
        }
    }
}

// Every file that a reference can consist of. PathInside for each, so that no link leads out.
Result<std::vector<fs::path>> Places(const fs::path& references, const std::string& name)
{
    std::vector<fs::path> places;
    for (const fs::path& relative :
         {Relative(kState, name, ".txt"), Relative(kDrawList, name, ".txt"),
          Relative(kDrawList, name, ".txt.gz"), Relative(kFrames, name, ".png")})
    {
        Result<fs::path> place = PathInside(references, relative);
        if (!place)
        {
            return place.GetError();
        }
        places.push_back(*std::move(place));
    }
    return places;
}

Result<std::vector<FileToWrite>> Encode(const fs::path& references, const std::string& name,
                                        const Moment& moment)
{
    std::vector<FileToWrite> files;
    if (moment.state)
    {
        files.push_back({references / Relative(kState, name, ".txt"), *moment.state + "\n"});
    }
    if (moment.list)
    {
        Result<FileToWrite> file =
            StoredText(references / Relative(kDrawList, name, ".txt"), *moment.list);
        if (!file)
        {
            return file.GetError();
        }
        files.push_back(*std::move(file));
    }
    if (moment.frame)
    {
        Result<FileToWrite> file = Picture(references / Relative(kFrames, name, ".png"),
                                           *moment.frame, kReferenceCompression);
        if (!file)
        {
            return file.GetError();
        }
        files.push_back(*std::move(file));
    }
    return files;
}

} // namespace

Result<Moment> ReadReference(const fs::path& root, const std::string& name)
{
    Result<std::optional<std::string>> state = ReadState(root, name);
    if (!state)
    {
        return state.GetError();
    }
    Result<std::optional<std::string>> list =
        ReadStoredText(root, Relative(kDrawList, name, ".txt"));
    if (!list)
    {
        return list.GetError();
    }
    Result<std::optional<Frame>> frame = ReadFrame(root, name);
    if (!frame)
    {
        return frame.GetError();
    }
    return Moment{*std::move(state), *std::move(list), *std::move(frame)};
}

Moment Take(const GoldenCandidate& candidate, const Moment& expected)
{
    Moment moment;
    if (!candidate.stateHash.empty())
    {
        moment.state = candidate.stateHash;
    }
    if (!candidate.list.items.empty() || expected.list)
    {
        moment.list = ToText(candidate.list);
    }
    if (!candidate.frame.rgba.empty() || expected.frame)
    {
        moment.frame = candidate.frame;
    }
    return moment;
}

std::vector<std::string> MissingFiles(const std::string& name, const Moment& expected,
                                      const Moment& actual)
{
    std::vector<std::string> files;
    if (actual.state && !expected.state)
    {
        files.push_back(Relative(kState, name, ".txt").string());
    }
    if (actual.list && !expected.list)
    {
        files.push_back(Relative(kDrawList, name, ".txt").string());
    }
    if (actual.frame && !expected.frame)
    {
        files.push_back(Relative(kFrames, name, ".png").string());
    }
    if (!actual.state && !actual.list && !actual.frame)
    {
        files.push_back(Relative(kFrames, name, ".png").string());
    }
    return files;
}

Result<FileToWrite> Picture(const fs::path& path, const Frame& frame, int compressionLevel)
{
    Result<std::vector<std::uint8_t>> png = EncodePng(frame, compressionLevel);
    if (!png)
    {
        return Error{png.GetError().kind, path.string() + ": " + png.GetError().message};
    }
    return FileToWrite{path, std::string(png->begin(), png->end())};
}

Result<void> Store(const fs::path& references, const std::string& name, const Moment& moment)
{
    const Result<std::vector<fs::path>> places = Places(references, name);
    if (!places)
    {
        return places.GetError();
    }
    const Result<std::vector<FileToWrite>> files = Encode(references, name, moment);
    if (!files)
    {
        return files.GetError();
    }
    if (files->empty())
    {
        return Error{ErrorKind::Unusable,
                     name + " has neither a state nor a draw list nor a frame to accept."};
    }
    if (const Result<void> written = WriteAll(*files); !written)
    {
        return written;
    }
    // What the candidate does not have was approved for another one.
    for (const fs::path& place : *places)
    {
        const bool isWritten = std::any_of(files->begin(), files->end(),
                                           [&](const FileToWrite& f) { return f.path == place; });
        if (const Result<void> removed = isWritten ? Result<void>() : RemoveFile(place); !removed)
        {
            return removed;
        }
    }
    return {};
}

std::vector<std::string> ReferenceNames(const fs::path& references)
{
    std::set<std::string> names;
    CollectNames(references / kState, {".txt"}, names);
    CollectNames(references / kDrawList, {".txt.gz", ".txt"}, names);
    CollectNames(references / kFrames, {".png"}, names);
    return {names.begin(), names.end()};
}

} // namespace boxreel
