// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

/// Creates joints at world points. Called by scenes while they build their world, like the
/// functions of Parts.h.
namespace boxreel
{

/// Keeps two points as far from each other as they are: rigid, or a spring of `hertz`, undamped at
/// damping 0 and critical at 1.
b2Joint* AddRod(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& pointA,
                const b2Vec2& pointB, float32 hertz = 0.0f, float32 damping = 0.0f);

/// Turns B against A at `speed` [rad/s] with at most `torque` [N m]; speed 0 brakes.
b2Joint* AddMotorHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                       float32 speed, float32 torque);

/// A hinge that turns from `lower` to `upper` only [rad], seen from how the bodies are now. With
/// `friction` it resists with up to that torque [N m].
b2Joint* AddLimitedHinge(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                         float32 lower, float32 upper, float32 friction = 0.0f);

/// B slides against A along `axis`, a world vector of any length, without turning.
b2Joint* AddSlide(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                  const b2Vec2& axis);

/// The same with ends, from `lower` to `upper` [m], and a motor of `speed` [m/s] and at most
/// `force` [N].
b2Joint* AddMotorSlide(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                       const b2Vec2& axis, float32 lower, float32 upper, float32 speed,
                       float32 force);

/// Fixes B to A: rigid, or with a spring against turning.
b2Joint* AddWeld(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& point,
                 float32 hertz = 0.0f, float32 damping = 0.0f);

/// The bodies' own points [m] come no further apart than `length` [m].
b2Joint* AddRope(b2World& world, b2Body* bodyA, b2Body* bodyB, const b2Vec2& localA,
                 const b2Vec2& localB, float32 length);

/// Prevents contact of the body's fixtures with others of the same negative group.
void SetGroup(b2Body& body, int16 group);

} // namespace boxreel
