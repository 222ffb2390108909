// SPDX-License-Identifier: MIT
#pragma once

#include <debugdraw/Camera.h>
#include <debugdraw/DrawList.h>

#include <string_view>

/// @file
/// Draws in pixels into a list in metres: items at a position of the picture instead of the world,
/// and centred text. Used for annotations.
namespace boxreel
{

/// A point of the picture, y down from the top left corner [px].
struct PixelPoint
{
    double x = 0.0; ///< from the left
    double y = 0.0; ///< from above
};

/// The point of a text's box that is at the given position: 0 the left or upper end, 1 the other.
struct TextAnchor
{
    double x = 0.0; ///< 0 at the left end of the text, 1 at its right
    double y = 0.0; ///< 0 at its top, 1 at its bottom
};

inline constexpr Paint kInk = ColorRole::Ink;               ///< stands out most
inline constexpr Paint kNoteInk = ColorRole::ContactNormal; ///< a little less

/// Draws in pixels of a camera's picture.
class Paper
{
public:
    /// Adds to `list`, in the layer Annotations and without an owner, at pixels of `camera`.
    Paper(DrawList& list, const Camera& camera);

    /// Converts from the world [m] to the picture.
    PixelPoint ToPixel(Vec2 world) const;
    /// Converts from the picture to the world [m].
    Vec2 ToWorld(PixelPoint pixel) const;

    /// A line from one to the other.
    void Line(PixelPoint from, PixelPoint to, const Paint& paint) const;
    /// An outline, radius [px].
    void Circle(PixelPoint center, double radius, const Paint& paint) const;
    /// The point of the arrow's head is at `to`.
    void Arrow(PixelPoint from, PixelPoint to, const Paint& paint) const;
    /// One line, as wide as TextWidth says; nothing when it is empty.
    void Text(PixelPoint at, std::string_view line, TextAnchor anchor, const Paint& paint) const;

private:
    template <class Add>
    void Stamped(Add add) const;

    DrawList& m_list;
    Camera m_camera;
};

/// Returns a camera with one metre per pixel: (x, y) in pixels is (x, -y) in its world.
Camera PaperCamera(int width, int height);

} // namespace boxreel
