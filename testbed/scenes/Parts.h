// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <initializer_list>
#include <string>

/// The few pieces that nearly every scene is made of. Called by scenes while they build their
/// world; anything only one scene needs stays in that scene's file.
namespace boxreel
{

/// The material of a piece. The defaults are those of the engine's reference scenes.
struct Material
{
    float32 density = 1.0f; ///< [kg/m^2]
    float32 friction = 0.6f;
    float32 restitution = 0.0f;
};

/// A body without fixtures. `angle` is counter-clockwise [rad].
b2Body* AddBody(b2World& world, b2BodyType type, const b2Vec2& position, float32 angle = 0.0f);

/// Fixtures for a body, in its own frame [m].
b2Fixture* AttachBox(b2Body& body, float32 halfWidth, float32 halfHeight, const Material& material,
                     const b2Vec2& center = b2Vec2(0.0f, 0.0f), float32 angle = 0.0f);
b2Fixture* AttachCircle(b2Body& body, float32 radius, const Material& material,
                        const b2Vec2& center = b2Vec2(0.0f, 0.0f));
b2Fixture* AttachPolygon(b2Body& body, std::initializer_list<b2Vec2> vertices,
                         const Material& material);

/// Static pieces, in world coordinates [m]. The ground's friction is that of `Material`.
b2Body* AddGroundEdge(b2World& world, const b2Vec2& from, const b2Vec2& to);
b2Body* AddGroundBox(b2World& world, const b2Vec2& center, float32 halfWidth, float32 halfHeight,
                     float32 angle = 0.0f);

/// A box or a ball that moves freely.
b2Body* AddBox(b2World& world, const b2Vec2& center, float32 halfWidth, float32 halfHeight,
               const Material& material = {}, float32 angle = 0.0f);
b2Body* AddBall(b2World& world, const b2Vec2& center, float32 radius,
                const Material& material = {});

/// A pyramid of boxes that touch, on a ground whose level and middle are `foot` [m].
void AddPyramid(b2World& world, const b2Vec2& foot, int32 baseCount, float32 halfSize);

/// A hinge between two bodies at a world point [m]; the two do not collide with each other.
b2Joint* AddHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point);

/// A number with one decimal, for Scene::Describe.
std::string Rounded(float32 number);

} // namespace boxreel
