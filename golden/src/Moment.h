// SPDX-License-Identifier: MIT
#pragma once

#include "ReferenceFiles.h"

#include <base/Result.h>
#include <golden/ContactSheet.h>
#include <golden/ReferenceStore.h>
#include <render/Frame.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// One moment of a scene at three depths, as it is stored and compared. Used by the reference store
/// only; defines the path and format of each depth, and does not compare.
namespace boxreel
{

/// A missing depth is not compared.
struct Moment
{
    std::optional<std::string> state; ///< 16 hex digits
    WorldState bodies;                ///< empty: only the hash is stored
    std::optional<StateTrace> trace;
    std::optional<std::string> list; ///< as text
    std::optional<Frame> frame;
    std::string fingerprint;          ///< of the renderer that drew the frame; empty: unknown
    std::optional<std::string> sheet; ///< moments of a film in the frame, and their positions
};

/// Reads the reference of that name; all depths are empty if there is none. The picture is that of
/// this renderer (a Description(), or empty) if it has its own. An Error names the damaged file.
Result<Moment> ReadReference(const std::filesystem::path& references, const std::string& name,
                             const std::string& renderer);

/// Converts a candidate. A candidate without a state skips that depth. Nor is an empty list or
/// frame, unless the reference has one: then the scene has stopped drawing.
Moment Take(const GoldenCandidate& candidate, const Moment& expected);

/// Parses the text of a sheet; none if Take did not write it.
std::optional<SheetLayout> LayoutOf(const std::string& sheet);

/// True if this renderer has its own picture of that name.
bool HasOwnPicture(const std::filesystem::path& references, const std::string& name,
                   const std::string& renderer);

/// Returns the missing files for the actual moment's depths, relative to the references; at least
/// one if the moment has no depth.
std::vector<std::string> MissingFiles(const std::string& name, const Moment& expected,
                                      const Moment& actual);

/// Makes the moment the reference, and removes the depths it does not have. With a renderer, only
/// its own picture is replaced.
Result<void> Store(const std::filesystem::path& references, const std::string& name,
                   const Moment& moment, const std::string& renderer);

/// Returns the names with a reference at any depth, sorted.
std::vector<std::string> ReferenceNames(const std::filesystem::path& references);

/// Encodes a frame as PNG, zlib level 1 (fast) to 9 (small), with the renderer's fingerprint unless
/// it is empty.
Result<FileToWrite> Picture(const std::filesystem::path& path, const Frame& frame,
                            int compressionLevel, const std::string& fingerprint = "");

} // namespace boxreel
