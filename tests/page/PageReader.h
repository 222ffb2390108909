// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <filesystem>
#include <string>
#include <vector>

/// Reads the frames of a page, as page/player/decode.js does. Written from
/// docs/notes/page-format.md and not from the encoder.
namespace boxreel::test
{

/// An item, with the ends of radii and axes instead of directions.
struct PageItem
{
    DrawKind kind = DrawKind::Segment;
    int layer = 0;
    std::uint32_t owner = kNoOwner;
    float size = 0.0f;
    std::string text{};
    std::string stroke{};          ///< colour of the first theme, as CSS
    std::vector<double> points{};  ///< x and y by turns [m]
    std::vector<double> anchors{}; ///< of the points of joints' signs, x and y by turns [m]
};

/// A body's origin, where the page has it.
struct PageOrigin
{
    std::uint32_t owner = kNoOwner;
    double x = 0.0;
    double y = 0.0;
    double angle = 0.0;
};

/// A body's state.
struct PageState
{
    PageOrigin place;
    double velocityX = 0.0; ///< [m/s]
    double velocityY = 0.0; ///< [m/s]
    double spin = 0.0;      ///< [rad/s]
};

struct PageFrame
{
    std::vector<PageItem> items;
    std::vector<PageOrigin> origins;
    std::vector<PageState> states;
    double viewX = 0.0;      ///< of the middle [m]
    double viewY = 0.0;      ///< of the middle [m]
    double viewHeight = 0.0; ///< [m]
};

struct ReadPage
{
    double fullScale = 0.0; ///< [px/m]
    double firstTime = 0.0; ///< [s]
    std::string html;       ///< all of it
    std::size_t forms = 0;  ///< their number
    std::vector<PageFrame> frames;
};

/// Adds a failure where the page is not whole.
ReadPage ReadPageFile(const std::filesystem::path& path);

/// The items of a list as a page should have them.
std::vector<PageItem> ItemsOf(const DrawList& list);

/// Expects that both have the same items, at places that differ by at most kPagePixelError at the
/// largest zoom.
void ExpectSameItems(const PageFrame& frame, const DrawList& list, double fullScale);

} // namespace boxreel::test
