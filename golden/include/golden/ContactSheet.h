// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

/// @file
/// A film as one picture: thumbnails at a fixed interval of simulation steps, row by row. Sampled
/// by time, so films of one simulation with different frame rates have the same sheet. For golden
/// tests; does not compare.
namespace boxreel
{

/// The sampling and layout of a sheet.
struct ContactSheetSettings
{
    double stepsPerSecond = 60.0; ///< simulation steps per second of the film, > 0
    std::int64_t every = 30;      ///< steps between pictures, >= 1
    int columns = 4;              ///< pictures per row, >= 1
    int width = 320;              ///< width of a picture, >= 1 [px]; smaller films are not enlarged
};

/// Maximum number of pictures on a sheet, to keep it readable.
inline constexpr std::size_t kMaxSheetPictures = 256;

/// The positions of the pictures on a sheet.
struct SheetLayout
{
    int columns = 0;             ///< pictures per row
    int width = 0;               ///< of a picture [px]
    int height = 0;              ///< of a picture [px]
    std::size_t pictures = 0;    ///< number of pictures
    std::int64_t every = 0;      ///< steps between pictures
    double stepsPerSecond = 0.0; ///< of the film

    /// Returns the rectangle of a picture [px]; picture < pictures.
    PixelBounds Place(std::size_t picture) const;
    /// Returns the step of a picture.
    std::int64_t Step(std::size_t picture) const { return std::int64_t(picture) * every; }
};

/// A film in one picture.
struct ContactSheet
{
    SheetLayout layout; ///< positions of the pictures
    Frame frame;        ///< opaque; gray between the pictures and where the last row ends
};

/// Returns a copy of a rectangle inside the sheet.
Frame CutOut(const Frame& sheet, const PixelBounds& place);

/// Creates the contact sheet of a film. Unusable when the film cannot be read, has no frame or more
/// than kMaxSheetPictures pictures, or a setting is out of range.
Result<ContactSheet> ContactSheetOf(const std::filesystem::path& film,
                                    const ContactSheetSettings& settings = {});

} // namespace boxreel
