// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <render/Frame.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

/// @file
/// A film as one picture: what it shows at every so many simulation steps, small, row by row.
/// Sampled by time, so films of one simulation with other frame rates have the same sheet. Made for
/// golden tests; never judges.
namespace boxreel
{

/// Which moments of a film are on its sheet, and how large.
struct ContactSheetSettings
{
    double stepsPerSecond = 60.0; ///< simulation steps in a second of the film, above 0
    std::int64_t every = 30;      ///< steps from one picture to the next, 1 or more
    int columns = 4;              ///< of pictures, 1 or more
    int width = 320;              ///< of a picture, 1 or more [px]; smaller films are not enlarged
};

/// More pictures make no sheet that a person looks at.
inline constexpr std::size_t kMostSheetPictures = 256;

/// Where the pictures lie on a sheet.
struct SheetLayout
{
    int columns = 0;             ///< pictures in a row
    int width = 0;               ///< of a picture [px]
    int height = 0;              ///< of a picture [px]
    std::size_t pictures = 0;    ///< on the sheet
    std::int64_t every = 0;      ///< steps from one to the next
    double stepsPerSecond = 0.0; ///< of the film

    /// Where a picture lies [px]; picture < pictures.
    PixelBounds Place(std::size_t picture) const;
    /// The step that a picture shows.
    std::int64_t Step(std::size_t picture) const { return std::int64_t(picture) * every; }
};

/// A film in one picture.
struct ContactSheet
{
    SheetLayout layout; ///< where each of its pictures lies
    Frame frame;        ///< opaque; gray between the pictures and where the last row ends
};

/// What lies in a place that is all on the sheet.
Frame CutOut(const Frame& sheet, const PixelBounds& place);

/// Unusable when the film cannot be read, has no frame or more than kMostSheetPictures pictures, or
/// a setting is out of its range.
Result<ContactSheet> ContactSheetOf(const std::filesystem::path& film,
                                    const ContactSheetSettings& settings = {});

} // namespace boxreel
