// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// @file
/// Frames to and from PNG files, through libpng. Only Png.cpp knows that library.
namespace boxreel
{

/// A text that a PNG file carries beside its pixels (chunk tEXt).
struct PngText
{
    std::string keyword; ///< 1 to 79 letters, digits or single spaces between them, asserted
    std::string text;    ///< Latin-1, without line breaks
};

/// What a PNG is to be like.
struct PngSettings
{
    int compressionLevel = 3; ///< zlib, 1 (fast) to 9 (small), asserted; the pixels are the same
    bool overwrite = false;   ///< false: an existing file is an error
};

/// Reads any PNG type and depth as 8-bit RGBA; gamma and colour profiles are not applied. Never
/// trusts the file: sizes are limited, a truncated, damaged or foreign file is an Error that names
/// it.
Result<Frame> ReadPng(const std::filesystem::path& path);

/// Writes a PNG file, whole or not at all: as NAME.part.png beside it, then renamed. RGB when the
/// frame is opaque. An Error when it is there, or cannot be written.
Result<void> WritePng(const std::filesystem::path& path, const Frame& frame,
                      const PngSettings& settings = {});

/// The bytes of a PNG file. Same frame and level (1 to 9), same bytes; any number of threads may
/// encode at once. `texts` stand before the pixels. An Error (Unusable) for a frame without pixels,
/// or whose pixels are not as many as its size says.
Result<std::vector<std::uint8_t>> EncodePng(const Frame& frame, int compressionLevel = 3,
                                            const std::vector<PngText>& texts = {});

/// The text of that keyword which stands before the pixels; empty when there is none. Errors as of
/// ReadPng, for what stands before the pixels.
Result<std::string> ReadPngText(const std::filesystem::path& path, const std::string& keyword);

} // namespace boxreel
