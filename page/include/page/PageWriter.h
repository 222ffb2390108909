// SPDX-License-Identifier: MIT
#pragma once

#include <base/Result.h>
#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Theme.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

/// @file
/// Writes draw lists to a web page that plays them as vectors: Open, Append each frame, Close. The
/// page is one HTML file that needs no network and no other file. It plays, stops, steps, zooms and
/// pans, follows bodies and switches layers. Knows no engine and no pixels.
///
/// - Positions are those of the lists, to kPagePixelError at the largest zoom of the page. That is
///   kPageZoom times the scale of the first frame.
/// - Items with coordinates that are not finite are left out, as renderers do.
/// - Same frames and settings, same bytes, on machines with the same zlib.
/// - Frames are packed in groups as they are appended, so memory does not grow with their number.
namespace boxreel
{

/// Largest zoom of a page, as a factor of the scale of its first frame.
inline constexpr double kPageZoom = 64.0;
/// Largest difference between a coordinate on the page and in the list at that zoom [px].
inline constexpr double kPagePixelError = 0.01;

/// Largest difference between a velocity on the page and that of its body [m/s, rad/s].
inline constexpr double kPageVelocityError = 0.01;

/// Rate, colours and title of a page.
struct PageSettings
{
    int width = 1280;               ///< of the cameras, 1 to 8192 [px]
    int height = 720;               ///< of the cameras, 1 to 8192 [px]
    double framesPerSecond = 60.0;  ///< at normal speed, above 0, at most 1000
    double speed = 1.0;             ///< simulated seconds per second, above 0
    double firstTime = 0.0;         ///< simulated time of the first frame [s]
    std::string title = "boxreel";  ///< UTF-8
    Theme theme = Theme::Classic(); ///< colours at first; the page has those of the themes Print
                                    ///< or Dark too, whichever is the opposite
    LayerSet shown{};               ///< layers that are on at first; the others can be switched on
    bool overwrite = false;         ///< false: an existing file is an Error
};

/// A body that the page describes when it is pointed at.
struct PageBody
{
    std::uint32_t number = 0; ///< the owner of its items in the list
    Vec2 position;            ///< of its origin [m]
    float angle = 0.0f;       ///< [rad]
    std::string name{};       ///< UTF-8; empty: none
    Vec2 velocity{};          ///< of its centre of mass, kept to kPageVelocityError [m/s]
    float spin = 0.0f;        ///< angular velocity, kept to kPageVelocityError [rad/s]
};

/// An Error (Unusable) for a name that does not end in .html, or for a setting out of range. Opens
/// nothing.
Result<void> CheckPagePath(const std::filesystem::path& path, const PageSettings& settings);

/// Writes draw lists to a web page.
class PageWriter
{
public:
    /// Starts the page as NAME.part.html. The Errors of CheckPagePath, and one (Unusable) when the
    /// file exists or its folder takes no file. Unless `overwrite`, also when NAME.part.html
    /// exists.
    static Result<PageWriter> Open(const std::filesystem::path& path,
                                   const PageSettings& settings = {});
    /// Leaves the source in a moved-from state.
    PageWriter(PageWriter&&) noexcept;
    /// Leaves the source in a moved-from state.
    PageWriter& operator=(PageWriter&&) noexcept;
    ~PageWriter(); ///< removes the page unless closed

    /// Appends a frame. The camera's size must be that of the settings; its view is shown until the
    /// reader chooses another. `bodies`: state and name of bodies, in any order; may be empty.
    /// `glyphAnchors`: of each point of the layer JointGlyphs in the list's order, the place in the
    /// world from which it keeps its distance in pixels when the reader zooms [m]. Otherwise these
    /// items grow, as they do if the number of anchors is another.
    /// An Error (Unusable) for a camera that cannot be drawn; (Failed) when the disk is full.
    Result<void> Append(const DrawList& list, const Camera& camera,
                        std::span<const PageBody> bodies = {},
                        std::span<const Vec2> glyphAnchors = {});

    /// Writes the rest and renames the file to its name. The object cannot be used afterwards. An
    /// Error (Unusable) if no frame was appended; (Failed) when the disk is full.
    Result<void> Close();

    /// Ends the page under its temporary name, NAME.part.html, where it can be played. The object
    /// cannot be used afterwards. The Errors of Close.
    Result<void> Suspend();

private:
    struct Impl;
    explicit PageWriter(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace boxreel
