// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Common/b2BlockAllocator.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// What all shapes have in common.

/// Mass, centre and rotational inertia of a shape. All finite, mass and inertia not negative.
struct b2MassData
{
    float32 mass = 0.0f; ///< of the shape's area [kg]
    b2Vec2 center;       ///< centre of mass, in the shape's frame [m]
    float32 I = 0.0f;    ///< rotational inertia about the frame's origin, not the centre [kg m^2]
};

/// A geometric figure that can collide. Shapes know nothing of bodies; a fixture keeps a copy, in
/// the frame of its body. Chains have one child an edge, all others a single child, number 0.
class b2Shape
{
public:
    /// Which class a shape is.
    enum Type
    {
        e_circle = 0,
        e_edge = 1,
        e_polygon = 2,
        e_chain = 3,
        e_typeCount = 4
    };

    virtual ~b2Shape() = default;

    /// A copy in the allocator's memory. Whoever asked destroys it with its destructor and
    /// b2BlockAllocator::Free with the size of the concrete class.
    virtual b2Shape* Clone(b2BlockAllocator* allocator) const = 0;

    Type GetType() const { return m_type; } ///< which class it is

    virtual int32 GetChildCount() const = 0; ///< 0 or more; 1 for all but chains

    /// Is the world point p [m] inside? Edges and chains have no inside: always false.
    virtual bool TestPoint(const b2Transform& xf, const b2Vec2& p) const = 0;

    /// Where a ray first meets the child, 0 <= childIndex < GetChildCount(). False, and `output` is
    /// as it was: nowhere. A ray that starts inside does not hit.
    virtual bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                         const b2Transform& transform, int32 childIndex) const = 0;

    /// The box around the child [m], its radius included; 0 <= childIndex < GetChildCount().
    virtual void ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const = 0;

    /// Mass data for a density [kg/m^2], >= 0. Edges and chains have no mass. The skin of a polygon
    /// does not count.
    virtual void ComputeMass(b2MassData* massData, float32 density) const = 0;

    Type m_type;      ///< which class it is
    float32 m_radius; ///< of a circle, or the skin around anything else [m], >= 0

protected:
    b2Shape(Type type, float32 radius) : m_type(type), m_radius(radius) {}
    b2Shape(const b2Shape&) = default;
    b2Shape& operator=(const b2Shape&) = default;
};
