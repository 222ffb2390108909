// SPDX-License-Identifier: MIT
#include "Moment.h"

#include <base/ErrorMacros.h>
#include <debugdraw/DrawListText.h>
#include <render/Png.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace boxreel
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* kState = "state";
constexpr const char* kTrace = "trace";
constexpr const char* kDrawList = "drawlist";
constexpr const char* kFrames = "frames";
constexpr const char* kSheet = "sheet";
// Maximum compression: written once and kept for years.
constexpr int kReferenceCompression = 9;
constexpr const char* kFingerprint = "Renderer fingerprint"; // keyword of a PNG's text

fs::path Relative(const char* depth, const std::string& name, const char* extension)
{
    return fs::path(depth) / (name + extension);
}

/// The stored text of a depth and its path, if any.
struct Kept
{
    std::optional<std::string> text;
    std::string path;
};

Error Damaged(const Kept& kept, const std::string& what)
{
    return Error{ErrorKind::Unusable, kept.path, what, "restore it"};
}

Result<Kept> Read(const fs::path& root, const fs::path& relative)
{
    Kept kept{{}, (root / relative).string()};
    ASSIGN_OR_RETURN(kept.text, ReadStoredText(root, relative));
    // A checkout may convert line ends; every line would then differ invisibly.
    if (kept.text && kept.text->find("\r\n") != std::string::npos)
    {
        return Damaged(kept, "has lines that end in CR LF (give its folder the attribute -text in "
                             ".gitattributes)");
    }
    return kept;
}

/// Reads the state: a line with its hash, then one line per body.
Result<void> ReadState(const fs::path& root, const std::string& name, Moment& moment)
{
    const Result<Kept> kept = Read(root, Relative(kState, name, ".txt"));
    if (!kept || !kept->text)
    {
        return kept ? Result<void>() : Result<void>(kept.GetError());
    }
    const auto isDigit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
    const std::string& text = *kept->text;
    if (text.size() < 17 || text[16] != '\n' ||
        !std::all_of(text.begin(), text.begin() + 16, isDigit))
    {
        return Damaged(*kept, "does not begin with a state hash of 16 hex digits");
    }
    Result<WorldState> bodies = ParseWorldState(std::string_view(text).substr(17));
    if (!bodies)
    {
        return Damaged(*kept, bodies.GetError().Text());
    }
    moment.state = text.substr(0, 16);
    moment.bodies = *std::move(bodies);
    return {};
}

Result<void> ReadTrace(const fs::path& root, const std::string& name, Moment& moment)
{
    const Result<Kept> kept = Read(root, Relative(kTrace, name, ".txt"));
    if (!kept || !kept->text)
    {
        return kept ? Result<void>() : Result<void>(kept.GetError());
    }
    Result<StateTrace> trace = ParseStateTrace(*kept->text);
    if (!trace)
    {
        return Damaged(*kept, trace.GetError().Text());
    }
    if (trace->steps.empty())
    {
        return Damaged(*kept, "has no step");
    }
    moment.trace = *std::move(trace);
    return {};
}

/// Returns a name with the renderer's description:
/// "pyramid/2s@osmesa-llvmpipe-llvm-15.0.6-256-bits". '@' is not allowed in names.
std::string KeyedName(const std::string& name, const std::string& renderer)
{
    std::string key;
    for (const char c : renderer)
    {
        const bool isUpper = c >= 'A' && c <= 'Z';
        const char lower = isUpper ? char(c - 'A' + 'a') : c;
        const bool isKept = (lower >= 'a' && lower <= 'z') || (c >= '0' && c <= '9') || c == '.';
        if (isKept || (!key.empty() && key.back() != '-'))
        {
            key += isKept ? lower : '-';
        }
    }
    return renderer.empty() ? name : name + "@" + key;
}

/// Returns the moments of a film on its contact sheet and their layout, in two readable lines.
std::string SheetText(const SheetLayout& layout)
{
    std::array<char, 32> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), layout.stepsPerSecond).ptr;
    return "every " + std::to_string(layout.every) + " steps, " + std::string(digits.data(), end) +
           " a second\n" + std::to_string(layout.pictures) + " pictures of " +
           std::to_string(layout.width) + "x" + std::to_string(layout.height) + ", " +
           std::to_string(layout.columns) + " in a row\n";
}

/// Reads the frame and its renderer, if there is a picture of that name.
Result<void> ReadFrame(const fs::path& root, const std::string& name, Moment& moment)
{
    ASSIGN_OR_RETURN(const fs::path path, PathInside(root, Relative(kFrames, name, ".png")));
    ASSIGN_OR_RETURN(const bool isThere, IsFile(path));
    if (!isThere)
    {
        return {};
    }
    ASSIGN_OR_RETURN(Frame frame, ReadPng(path));
    ASSIGN_OR_RETURN(moment.fingerprint, ReadPngText(path, kFingerprint));
    moment.frame = std::move(frame);
    return {};
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

// Returns all possible files of a reference, each checked by PathInside against links that lead
// out.
Result<std::vector<fs::path>> Places(const fs::path& references, const std::string& name)
{
    std::vector<fs::path> places;
    for (const fs::path& relative :
         {Relative(kState, name, ".txt"), Relative(kState, name, ".txt.gz"),
          Relative(kTrace, name, ".txt"), Relative(kTrace, name, ".txt.gz"),
          Relative(kDrawList, name, ".txt"), Relative(kDrawList, name, ".txt.gz"),
          Relative(kSheet, name, ".txt"), Relative(kFrames, name, ".png")})
    {
        ASSIGN_OR_RETURN(fs::path place, PathInside(references, relative));
        places.push_back(std::move(place));
    }
    return places;
}

Result<std::vector<FileToWrite>> Encode(const fs::path& references, const std::string& name,
                                        const Moment& moment, const std::string& renderer)
{
    std::vector<FileToWrite> files;
    std::vector<std::pair<const char*, std::string>> texts;
    if (moment.state)
    {
        texts.emplace_back(kState, *moment.state + "\n" + ToText(moment.bodies));
    }
    if (moment.trace)
    {
        texts.emplace_back(kTrace, ToText(*moment.trace));
    }
    if (moment.list)
    {
        texts.emplace_back(kDrawList, *moment.list);
    }
    if (moment.sheet)
    {
        texts.emplace_back(kSheet, *moment.sheet);
    }
    for (auto& [depth, text] : texts)
    {
        ASSIGN_OR_RETURN(FileToWrite file,
                         StoredText(references / Relative(depth, name, ".txt"), std::move(text)));
        files.push_back(std::move(file));
    }
    if (moment.frame)
    {
        ASSIGN_OR_RETURN(FileToWrite file,
                         Picture(references / Relative(kFrames, KeyedName(name, renderer), ".png"),
                                 *moment.frame, kReferenceCompression, moment.fingerprint));
        files.push_back(std::move(file));
    }
    return files;
}

} // namespace

Result<Moment> ReadReference(const fs::path& root, const std::string& name,
                             const std::string& renderer)
{
    Moment moment;
    for (const auto read : {ReadState, ReadTrace})
    {
        RETURN_IF_ERROR(read(root, name, moment));
    }
    const std::pair<const char*, std::optional<std::string>&> texts[] = {{kDrawList, moment.list},
                                                                         {kSheet, moment.sheet}};
    for (const auto& [depth, text] : texts)
    {
        ASSIGN_OR_RETURN(Kept kept, Read(root, Relative(depth, name, ".txt")));
        text = std::move(kept.text);
    }
    for (const std::string& picture : {KeyedName(name, renderer), name})
    {
        RETURN_IF_ERROR(ReadFrame(root, picture, moment));
        if (moment.frame)
        {
            break;
        }
    }
    return moment;
}

bool HasOwnPicture(const fs::path& references, const std::string& name, const std::string& renderer)
{
    std::error_code code;
    return !renderer.empty() &&
           fs::exists(references / Relative(kFrames, KeyedName(name, renderer), ".png"), code);
}

std::optional<SheetLayout> LayoutOf(const std::string& sheet)
{
    SheetLayout layout;
    if (std::sscanf(sheet.c_str(),
                    "every %18" SCNd64
                    " steps, %40lf a second\n%3zu pictures of %5dx%5d, %3d in a row",
                    &layout.every, &layout.stepsPerSecond, &layout.pictures, &layout.width,
                    &layout.height, &layout.columns) != 6)
    {
        return std::nullopt;
    }
    const bool isUsable = layout.pictures >= 1 && layout.pictures <= kMaxSheetPictures &&
                          layout.width >= 1 && layout.height >= 1 && layout.columns >= 1 &&
                          SheetText(layout) == sheet;
    return isUsable ? std::optional(layout) : std::nullopt;
}

Moment Take(const GoldenCandidate& candidate, const Moment& expected)
{
    Moment moment;
    if (!candidate.stateHash.empty())
    {
        moment.state = candidate.stateHash;
        moment.bodies = candidate.state;
    }
    if (!candidate.trace.steps.empty())
    {
        moment.trace = candidate.trace;
    }
    if (!candidate.list.items.empty() || expected.list)
    {
        moment.list = ToText(candidate.list);
    }
    if (!candidate.frame.rgba.empty() || expected.frame)
    {
        moment.frame = candidate.frame;
        moment.fingerprint = candidate.fingerprint;
    }
    if (candidate.sheet)
    {
        moment.sheet = SheetText(*candidate.sheet);
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
    if (actual.trace && !expected.trace)
    {
        files.push_back(Relative(kTrace, name, ".txt").string());
    }
    if (actual.list && !expected.list)
    {
        files.push_back(Relative(kDrawList, name, ".txt").string());
    }
    if (actual.sheet && !expected.sheet)
    {
        files.push_back(Relative(kSheet, name, ".txt").string());
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

Result<FileToWrite> Picture(const fs::path& path, const Frame& frame, int compressionLevel,
                            const std::string& fingerprint)
{
    std::vector<PngText> texts;
    if (!fingerprint.empty())
    {
        texts.push_back({kFingerprint, fingerprint});
    }
    Result<std::vector<std::uint8_t>> png = EncodePng(frame, compressionLevel, texts);
    if (!png)
    {
        const Error& error = png.GetError();
        return Error{error.kind, path.string() + ": " + error.culprit, error.problem, error.remedy};
    }
    return FileToWrite{path, std::string(png->begin(), png->end())};
}

Result<void> Store(const fs::path& references, const std::string& name, const Moment& moment,
                   const std::string& renderer)
{
    ASSIGN_OR_RETURN(const std::vector<fs::path> places, Places(references, name));
    ASSIGN_OR_RETURN(const std::vector<FileToWrite> files,
                     Encode(references, name, moment, renderer));
    if (files.empty())
    {
        return Error{ErrorKind::Unusable, name, "has no state, draw list or frame to accept"};
    }
    RETURN_IF_ERROR(WriteAll(files));
    // Depths that the candidate does not have belong to an older one.
    for (const fs::path& place : places)
    {
        const bool isKept =
            std::any_of(files.begin(), files.end(),
                        [&](const FileToWrite& f) { return f.path == place; }) ||
            (!renderer.empty() && place.extension() == ".png"); // keep the common picture of the
                                                                // other renderers
        RETURN_IF_ERROR(isKept ? Result<void>() : RemoveFile(place));
    }
    return {};
}

std::vector<std::string> ReferenceNames(const fs::path& references)
{
    std::set<std::string> names;
    CollectNames(references / kState, {".txt.gz", ".txt"}, names);
    CollectNames(references / kDrawList, {".txt.gz", ".txt"}, names);
    CollectNames(references / kFrames, {".png"}, names);
    return {names.begin(), names.end()};
}

} // namespace boxreel
