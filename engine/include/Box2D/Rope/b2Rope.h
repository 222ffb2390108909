// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// A rope without bodies.

class b2Draw;

/// A rope by itself: a chain of points for ornaments, much cheaper than bodies and joints. It
/// collides with nothing and belongs to no world.
struct b2RopeDef
{
    const b2Vec2* vertices = nullptr;    ///< the points at rest, in order [m]
    int32 count = 0;                     ///< at least 3
    const float32* masses = nullptr;     ///< one a point [kg]; 0 holds the point where it is
    b2Vec2 gravity = b2Vec2(0.0f, 0.0f); ///< acceleration of all of it [m/s^2]
    float32 damping = 0.1f;              ///< of the velocity [1/s], >= 0
    float32 k2 = 0.9f;                   ///< share of a stretch undone by an iteration, 0 to 1
    float32 k3 = 0.1f;                   ///< share of a bend undone by an iteration, 0 to 1
};

/// Solved by position-based dynamics: Mueller, Heidelberger, Hennix, Ratcliff, "Position Based
/// Dynamics", Journal of Visual Communication and Image Representation 18 (2007).
class b2Rope
{
public:
    /// Copies the definition and starts at rest. Lengths and angles of the given shape are those
    /// that the rope returns to. Without a definition, or with a number of it out of range or not
    /// finite, it asserts and the rope is as it was.
    void Initialize(const b2RopeDef* def);

    /// Moves time on [s], >= 0, with so many iterations, >= 0; nothing happens for a step of zero,
    /// and, after an assert, for one that is negative or not finite.
    void Step(float32 timeStep, int32 iterations);

    int32 GetVertexCount() const { return static_cast<int32>(m_points.size()); } ///< of vertices
    /// GetVertexCount() world points [m].
    const b2Vec2* GetVertices() const { return m_positions.data(); }

    /// A segment between every two points. `draw` is not null.
    void Draw(b2Draw* draw) const;

    /// The angle that every bend returns to [rad]; 0 is straight. One that is not finite asserts
    /// and changes nothing.
    void SetAngle(float32 angle);

private:
    struct Point
    {
        b2Vec2 before; ///< where it was at the beginning of the step [m]
        b2Vec2 velocity;
        float32 inverseMass;
    };

    void SolveStretch();
    void SolveBends();

    box2d::Array<Point> m_points;
    box2d::Array<b2Vec2> m_positions;
    box2d::Array<float32> m_lengths; ///< of the segments at rest [m]
    box2d::Array<float32> m_angles;  ///< of the bends at rest [rad]
    b2Vec2 m_gravity;
    float32 m_damping = 0.0f;
    float32 m_stretchStiffness = 0.0f;
    float32 m_bendStiffness = 0.0f;
};
