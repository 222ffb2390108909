// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/Camera.h>
#include <debugdraw/Dimension.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/Paper.h>
#include <render/Figure.h>

#include <string_view>
#include <vector>

/// One figure of the manual while it is being drawn: what a world shows, and letters, arrows and
/// lines that explain it. Painter's order: what is drawn later covers what was drawn earlier.
namespace figures
{

// The classic palette's colours, which each theme has its own for, by what they say in a figure.
inline constexpr boxreel::Paint kInk = boxreel::kInk;
inline constexpr boxreel::Paint kQuiet =
    boxreel::ColorRole::AsleepBody; ///< what was, or helps to see
inline constexpr boxreel::Paint kFixed = boxreel::ColorRole::StaticBody; ///< of static bodies
inline constexpr boxreel::Paint kDriven =
    boxreel::ColorRole::KinematicBody;                                   ///< of kinematic bodies
inline constexpr boxreel::Paint kMoving = boxreel::ColorRole::AwakeBody; ///< of dynamic bodies
inline constexpr boxreel::Paint kHelp = boxreel::ColorRole::OldContact;  ///< skins, rays, axes
inline constexpr boxreel::Paint kPair =
    boxreel::ColorRole::Pair; ///< of fixtures whose boxes overlap
inline constexpr boxreel::Paint kGood = boxreel::ColorRole::NewContact; ///< found, right
inline constexpr boxreel::Paint kBox = boxreel::ColorRole::Aabb;        ///< bounding boxes
/// Forces and normals: the one colour that is far from the bodies' in light and in dark.
inline constexpr boxreel::Paint kPush = boxreel::ColorRole::Joint;
inline constexpr boxreel::Paint kBad{213, 94, 0}; ///< wrong; seen on white and on black

/// The position of a label relative to its point.
enum class Side
{
    Right,
    AboveRight,
    Above,
    AboveLeft,
    Left,
    BelowLeft,
    Below,
    BelowRight,
    On,
};

class Sketch
{
public:
    /// Size in pixels, the world point in the middle, and the scale.
    Sketch(int width, int height, const b2Vec2& center, double pixelsPerMeter);

    boxreel::DrawList& List() { return m_list; }
    const boxreel::Camera& Camera() const { return m_camera; }

    // What a world shows.
    /// `flags` of b2Draw.
    void Draw(b2World& world, uint32 flags = b2Draw::e_shapeBit);
    /// The bodies that are not static, as they are now, faint.
    void DrawFaint(b2World& world, double opacity);
    void DrawGlyphs(const b2World& world);
    void DrawCenterMarks(const b2World& world);

    // What explains it, in metres; gaps and sizes in pixels.
    void Line(const b2Vec2& from, const b2Vec2& to, boxreel::Paint color = kInk);
    /// A line of three pixels, for what is right or wrong in a figure.
    void Bar(const b2Vec2& from, const b2Vec2& to, boxreel::Paint color);
    void Dashes(const b2Vec2& from, const b2Vec2& to, boxreel::Paint color = kQuiet);
    void Arrow(const b2Vec2& from, const b2Vec2& to, boxreel::Paint color = kInk);
    /// From a point so many pixels along a direction of any length.
    void ArrowAlong(const b2Vec2& from, const b2Vec2& direction, double pixels,
                    boxreel::Paint color = kInk);
    /// Around a point from one angle to another [rad], with a head at the other.
    void ArcArrow(const b2Vec2& center, double radius, float32 from, float32 to,
                  boxreel::Paint color = kInk);
    void Dot(const b2Vec2& at, boxreel::Paint color = kInk, double diameter = 7.0);
    void Ring(const b2Vec2& at, double radius, boxreel::Paint color = kInk);
    void Outline(const std::vector<b2Vec2>& corners, boxreel::Paint color);
    /// A convex area as light as the fill of a body's shape.
    void Fill(const std::vector<b2Vec2>& corners, boxreel::ColorRole role);
    void Trail(const std::vector<b2Vec2>& way, boxreel::Paint color = kHelp);
    /// With arrows between extension lines, `offset` pixels away: above or on the left, on the
    /// other side when it is negative.
    void Measure(const b2Vec2& from, const b2Vec2& to, std::string_view label, double offset = 30.0,
                 boxreel::Paint color = kInk);
    /// Lines are parted by line feeds.
    void Label(const b2Vec2& at, Side side, std::string_view text, boxreel::Paint color = kInk,
               double gap = 7.0);
    /// The same at a place of the picture, from the top left corner.
    void Caption(double x, double y, Side side, std::string_view text, boxreel::Paint color = kInk);
    /// A thin line from a point to a label that lies (right, up) pixels from it.
    void Note(const b2Vec2& at, double right, double up, std::string_view text,
              boxreel::Paint color = kInk);

    b2Vec2 Shifted(const b2Vec2& at, double right, double up) const;
    /// The world's point at a place of the picture, from the top left corner.
    b2Vec2 AtPixel(double x, double y) const;

    /// A smaller sketch in a frame, its top left corner at this place of the picture.
    void Inset(const Sketch& detail, double x, double y);
    boxreel::Figure Finished() const;

private:
    void LabelAt(boxreel::PixelPoint at, Side side, std::string_view text, boxreel::Paint color,
                 double gap);
    boxreel::Paper OnPaper() { return boxreel::Paper(m_list, m_camera); }
    void Annotate(); // what follows is an annotation

    boxreel::DrawList m_list;
    boxreel::Camera m_camera;
    std::vector<boxreel::FigurePanel> m_insets;
};

boxreel::Vec2 From(const b2Vec2& v);

} // namespace figures
