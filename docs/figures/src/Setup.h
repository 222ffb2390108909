// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <string>
#include <vector>

/// Short helpers to build the worlds of the figures.
namespace figures
{

b2PolygonShape Box(float32 halfWidth, float32 halfHeight);
b2CircleShape Disc(float32 radius);
b2EdgeShape Edge(const b2Vec2& from, const b2Vec2& to);

/// A body without a shape.
b2Body* AddBody(b2World& world, b2BodyType type, const b2Vec2& position, float32 angle = 0.0f);
/// A body of one shape, of 1 kg/m^2.
b2Body* AddBody(b2World& world, b2BodyType type, const b2Shape& shape, const b2Vec2& position,
                float32 angle = 0.0f);
/// A static body at the origin.
b2Body* AddGround(b2World& world, const b2Shape& shape);

/// [rad]
constexpr float32 Degrees(float32 degrees)
{
    return degrees * (b2_pi / 180.0f);
}

/// The polygon's outline, moved out by its radius, with round corners.
std::vector<b2Vec2> SkinOf(const b2PolygonShape& shape, const b2Transform& place);

/// So many steps of 60 Hz.
void Run(b2World& world, int steps = 1);

/// With so many decimals, independent of the locale.
std::string Text(double number, int decimals);

} // namespace figures
