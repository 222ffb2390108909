// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// A decorative rope without bodies.

class b2Draw;

/// Definition of a rope: a chain of points for decoration, much cheaper than bodies and joints. It
/// does not collide and belongs to no world.
struct b2RopeDef
{
    const b2Vec2* vertices = nullptr;    ///< the points at rest, in order [m]
    int32 count = 0;                     ///< at least 3
    const float32* masses = nullptr;     ///< one per point [kg]; 0 fixes the point
    b2Vec2 gravity = b2Vec2(0.0f, 0.0f); ///< acceleration of all points [m/s^2]
    float32 damping = 0.1f;              ///< decay rate of the velocity [1/s], >= 0
    float32 k2 = 0.9f;                   ///< fraction of a stretch removed by an iteration, 0 to 1
    float32 k3 = 0.1f;                   ///< fraction of a bend removed by an iteration, 0 to 1
};

/// Solved by position-based dynamics: Mueller, Heidelberger, Hennix, Ratcliff, "Position Based
/// Dynamics", Journal of Visual Communication and Image Representation 18 (2007).
class b2Rope
{
public:
    /// Copies the definition and starts at rest. The given shape defines the rest lengths and
    /// angles. A null definition, or a number out of range or not finite, asserts and changes
    /// nothing.
    void Initialize(const b2RopeDef* def);

    /// Advances the rope by `timeStep` seconds, >= 0, with `iterations` >= 0. Does nothing for a
    /// step of zero. A negative or non-finite step asserts and does nothing.
    void Step(float32 timeStep, int32 iterations);

    int32 GetVertexCount() const
    {
        return static_cast<int32>(m_points.size());
    } ///< number of
      ///< vertices
    /// Returns GetVertexCount() world points [m].
    const b2Vec2* GetVertices() const { return m_positions.data(); }

    /// Draws a segment between consecutive points. `draw` is not null.
    void Draw(b2Draw* draw) const;

    /// Sets the rest angle of every bend [rad]; 0 is straight. A value that is not finite asserts
    /// and changes nothing.
    void SetAngle(float32 angle);

private:
    struct Point
    {
        b2Vec2 before; ///< position at the start of the step [m]
        b2Vec2 velocity;
        float32 inverseMass;
    };

    void SolveStretch();
    void SolveBends();

    box2d::Array<Point> m_points;
    box2d::Array<b2Vec2> m_positions;
    box2d::Array<float32> m_lengths; ///< rest lengths of the segments [m]
    box2d::Array<float32> m_angles;  ///< rest angles of the bends [rad]
    b2Vec2 m_gravity;
    float32 m_damping = 0.0f;
    float32 m_stretchStiffness = 0.0f;
    float32 m_bendStiffness = 0.0f;
};
