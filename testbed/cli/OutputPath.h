// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Asked before long work is done for a file that could not be written in the end.
namespace boxreel
{

/// The extensions of pictures of scenes, and of films.
std::vector<std::string> FigureExtensions();
std::vector<std::string> FilmExtensions();
/// Those and the one of pages.
std::vector<std::string> RecordExtensions();

/// Refuses another extension than these, and none. Standard output may have none.
Result<void> CheckRecordExtension(const std::filesystem::path& path);

/// Refuses the names of unfinished films.
Result<void> CheckFilmName(const std::filesystem::path& film);

/// Checks that a picture can be written there. The name must end in .png, and its folder must exist
/// and be writable. No file may exist unless `force`. Changes nothing.
Result<void> CheckPicturePath(const std::filesystem::path& path, bool force);

/// True if two names refer to the same file, in any spelling, or if one is a frame of the other, a
/// numbered film.
bool IsSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// True if a picture has the name of one that a numbered film, frames-####.png, may write.
bool IsFrameOf(const std::filesystem::path& picture, const std::filesystem::path& film);

enum class PictureFormat
{
    Png,
    Svg,
    Pdf,
};

/// By the name's end; none when it is another.
std::optional<PictureFormat> PictureFormatOf(const std::filesystem::path& path);

/// The same for a picture of a scene, whose name ends in .png, .svg or .pdf.
Result<void> CheckFigurePath(const std::filesystem::path& path, bool force);

} // namespace boxreel
