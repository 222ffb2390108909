// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <string>

/// Drawings that scenes add to their bodies: dots, arrows, outlines, numbers.
namespace boxreel
{

/// Three colours that everyone can tell apart and from those of bodies (Okabe and Ito).
inline const b2Color kOrange(0.90f, 0.62f, 0.0f);
inline const b2Color kSkyBlue(0.34f, 0.71f, 0.91f);
inline const b2Color kYellow(0.94f, 0.89f, 0.26f);

void DrawDot(b2Draw& draw, const b2Vec2& point, const b2Color& color);
/// With a head at `to`; nothing where both are the same.
void DrawArrow(b2Draw& draw, const b2Vec2& from, const b2Vec2& to, const b2Color& color);
void DrawBox(b2Draw& draw, const b2AABB& box, const b2Color& color);
/// The line around a circle, a polygon or an edge.
void DrawOutline(b2Draw& draw, const b2Shape& shape, const b2Transform& transform,
                 const b2Color& color);

/// "12.34 m"
std::string WithUnit(float32 value, const char* unit);

} // namespace boxreel
