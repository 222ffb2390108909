// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Collision/b2Collision.h>
#include <Box2D/Common/b2BlockAllocator.h>
#include <Box2D/Common/b2Math.h>

/// @file
/// The base class of all shapes.

/// Mass, centre and rotational inertia of a shape. All are finite; mass and inertia are >= 0.
struct b2MassData
{
    float32 mass = 0.0f; ///< mass of the shape's area [kg]
    b2Vec2 center;       ///< centre of mass, in the shape's frame [m]
    float32 I = 0.0f;    ///< rotational inertia about the frame's origin, not the centre [kg m^2]
};

/// The base class of all shapes. A shape does not know its body; a fixture keeps a copy, in the
/// frame of its body. Chains have one child per edge, all other shapes have child 0 only.
class b2Shape
{
public:
    /// The concrete type of a shape.
    enum Type
    {
        e_circle = 0,
        e_edge = 1,
        e_polygon = 2,
        e_chain = 3,
        e_typeCount = 4
    };

    virtual ~b2Shape() = default;

    /// Returns a copy in the allocator's memory. The caller destroys it: call the destructor, then
    /// b2BlockAllocator::Free with the size of the concrete class.
    virtual b2Shape* Clone(b2BlockAllocator* allocator) const = 0;

    Type GetType() const { return m_type; } ///< the concrete type

    virtual int32 GetChildCount() const = 0; ///< 0 or more; 1 for all but chains

    /// True if the world point p [m] is inside. Edges and chains have no inside: always false.
    virtual bool TestPoint(const b2Transform& xf, const b2Vec2& p) const = 0;

    /// Finds the first hit of a ray with the child, 0 <= childIndex < GetChildCount(). Returns
    /// false and leaves `output` unchanged if there is none. A ray that starts inside does not hit.
    virtual bool RayCast(b2RayCastOutput* output, const b2RayCastInput& input,
                         const b2Transform& transform, int32 childIndex) const = 0;

    /// Computes the bounding box of the child [m], radius included. 0 <= childIndex <
    /// GetChildCount().
    virtual void ComputeAABB(b2AABB* aabb, const b2Transform& xf, int32 childIndex) const = 0;

    /// Computes the mass data for a density [kg/m^2], >= 0. Edges and chains have no mass. The skin
    /// of a polygon is not included.
    virtual void ComputeMass(b2MassData* massData, float32 density) const = 0;

    Type m_type;      ///< the concrete type
    float32 m_radius; ///< of a circle, or the skin of any other shape [m], >= 0

protected:
    b2Shape(Type type, float32 radius) : m_type(type), m_radius(radius) {}
    b2Shape(const b2Shape&) = default;
    b2Shape& operator=(const b2Shape&) = default;
};
