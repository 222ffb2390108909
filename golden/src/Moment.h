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

/// One moment of a scene at three depths, as it is stored and as it is compared. Used by the
/// reference store only; knows where each depth lies and in which form, and judges nothing.
namespace boxreel
{

/// A depth that is absent is not compared.
struct Moment
{
    std::optional<std::string> state; ///< 16 hex digits
    WorldState bodies;                ///< none: only the hash is kept
    std::optional<StateTrace> trace;
    std::optional<std::string> list; ///< as text
    std::optional<Frame> frame;
    std::string fingerprint;          ///< of the renderer that drew the frame; empty: not known
    std::optional<std::string> sheet; ///< which moments of a film the frame shows, and where
};

/// What was approved under a name; everything absent when nothing was.
/// The picture is that of this renderer (a Description(), or empty) where it has its own. An Error
/// for what is damaged: it names the file.
Result<Moment> ReadReference(const std::filesystem::path& references, const std::string& name,
                             const std::string& renderer);

/// A candidate without a state does not ask for that depth. An empty list or frame does not either,
/// unless something was approved: then it is a scene that stopped drawing.
Moment Take(const GoldenCandidate& candidate, const Moment& expected);

/// What the text of a sheet says; none when it is not one that Take wrote.
std::optional<SheetLayout> LayoutOf(const std::string& sheet);

/// Whether this renderer has a picture of its own under the name.
bool HasOwnPicture(const std::filesystem::path& references, const std::string& name,
                   const std::string& renderer);

/// The files, relative to the references, that the actual moment's depths need and that are not
/// there; one at least when the moment has no depth at all.
std::vector<std::string> MissingFiles(const std::string& name, const Moment& expected,
                                      const Moment& actual);

/// Makes the moment the reference, and removes the depths it does not have. With a renderer, the
/// picture becomes that of this one only.
Result<void> Store(const std::filesystem::path& references, const std::string& name,
                   const Moment& moment, const std::string& renderer);

/// Names that have a reference at any depth, sorted.
std::vector<std::string> ReferenceNames(const std::filesystem::path& references);

/// A frame as the bytes of a PNG file, zlib level 1 (fast) to 9 (small), with the fingerprint of
/// the renderer that drew it unless that is empty.
Result<FileToWrite> Picture(const std::filesystem::path& path, const Frame& frame,
                            int compressionLevel, const std::string& fingerprint = "");

} // namespace boxreel
