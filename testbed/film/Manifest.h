// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <recorder/FrameClock.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

/// The manifest FILE.json beside an incomplete film. FILE is its first picture for one of numbered
/// pictures, so that all its parts may be in one folder. It contains the command that makes the
/// film, and the state of its world where it may be continued or joined to another part. A run that
/// continues the film checks that film and simulation are the same. Used by record and merge.
namespace boxreel
{

struct Manifest
{
    std::string version;              ///< of this program
    std::vector<std::string> command; ///< the user's arguments, without the output
    Rational framesPerSecond;
    std::int64_t groupFrames = 100;
    int plays = 0;               ///< how often an animation plays; 0: forever
    std::int64_t frameCount = 0; ///< of the whole film
    std::int64_t first = 0;      ///< number of this part's first frame
    std::int64_t end = 0;        ///< one more than that of its last
    /// Checksum of the film's file, once it is closed. If the file is truncated, altered or
    /// replaced afterwards, it no longer matches the manifest.
    std::string checksum;
    /// State hashes by number of the frame that shows them: where groups begin, and at `end`.
    std::map<std::int64_t, std::string> states;
};

/// film.mkv becomes film.mkv.json.
std::filesystem::path ManifestPath(const std::filesystem::path& film);

/// Replaces an existing manifest.
Result<void> WriteManifest(const std::filesystem::path& film, const Manifest& manifest);

/// Error (Unusable) if there is no manifest or it is not readable, with this `remedy`.
Result<Manifest> ReadManifest(const std::filesystem::path& film, const std::string& remedy);

/// Returns the version of boxreel that wrote the file at the path of the manifest, even if the file
/// is not readable as a manifest. Empty if boxreel did not write it.
std::string WriterOfManifest(const std::filesystem::path& film);

/// Returns the checksum of a film and its size, or of those pictures from `first` to before `end`;
/// empty if a file is not readable.
std::string ChecksumOfFrames(const std::filesystem::path& film, std::int64_t first,
                             std::int64_t end);

/// Returns the command without the options that do not change a frame: its output, its progress
/// reports, the selected part, and --resume.
std::vector<std::string> CommandOfFilm(const std::vector<std::string>& arguments);

/// Returns the difference as a clause; empty if both make the same film.
std::string DifferenceOf(const Manifest& a, const Manifest& b);

} // namespace boxreel
