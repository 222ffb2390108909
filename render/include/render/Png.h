// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// @file
/// Frames to and from PNG files. Only Png.cpp uses libpng.
namespace boxreel
{

/// A text chunk (tEXt) of a PNG file.
struct PngText
{
    std::string keyword; ///< 1 to 79 letters, digits or single spaces between them, asserted
    std::string text;    ///< Latin-1, without line breaks
};

/// Options for writing a PNG.
struct PngSettings
{
    int compressionLevel = 3; ///< zlib level, 1 (fast) to 9 (small), asserted; does not change the
                              ///< pixels
    bool overwrite = false;   ///< false: an existing file is an Error
};

/// Reads any PNG type and depth as 8-bit RGBA; gamma and colour profiles are ignored. The file is
/// not trusted: sizes are limited, and a truncated, damaged or foreign file is an Error that names
/// it.
Result<Frame> ReadPng(const std::filesystem::path& path);

/// Writes a PNG file, complete or not at all: as NAME.part.png, then renamed. RGB when the frame is
/// opaque. An Error when the file exists or cannot be written.
Result<void> WritePng(const std::filesystem::path& path, const Frame& frame,
                      const PngSettings& settings = {});

/// Returns the bytes of a PNG file. Same frame and level (1 to 9), same bytes. Thread-safe. `texts`
/// are stored before the pixels. An Error (Unusable) for a frame without pixels, or with a size
/// that does not match them.
Result<std::vector<std::uint8_t>> EncodePng(const Frame& frame, int compressionLevel = 3,
                                            const std::vector<PngText>& texts = {});

/// Returns the text with this keyword before the pixels; empty if there is none. Errors as in
/// ReadPng, for the part before the pixels.
Result<std::string> ReadPngText(const std::filesystem::path& path, const std::string& keyword);

} // namespace boxreel
