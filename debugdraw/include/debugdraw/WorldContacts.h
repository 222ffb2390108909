// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <vector>

/// @file
/// Contact points of a world, with their normals and impulses. Read from the contacts after the
/// last step, without a listener; the world is not changed.
namespace boxreel
{

/// The selection and scale of contact items.
struct ContactLook
{
    bool points = false;   ///< dots: points that are new since the last step are larger
    bool normals = false;  ///< lines of 12 pixels, from the first fixture towards the second
    bool impulses = false; ///< arrows: non-penetration impulses on the second body
    bool friction = false; ///< arrows with open heads: friction impulses on the second body
    /// Converts impulses to the mean force of a step, so that arrows do not depend on its length. >
    /// 0.
    double stepsPerSecond = 60.0;
    double metersPerNewton = 0.01; ///< length of an arrow, >= 0
};

/// Remembers the contact points of a step, to find the new ones of the next.
class ContactCollector
{
public:
    /// Call before each step: the current points count as old from then on.
    void Remember(const b2World& world);

    /// Adds the items selected by `look`, layer by layer, with the points on top.
    void Collect(const b2World& world, const View& view, const ContactLook& look,
                 DrawList& list) const;

private:
    /// Identifies a contact. Memory is reused, so its address alone does not.
    struct Memory
    {
        const b2Contact* contact;
        const b2Fixture* fixtureA;
        const b2Fixture* fixtureB;
        int32 bodyA, bodyB; // their numbers
        int32 childA, childB;
        b2Manifold manifold;
        bool IsOf(const Memory& other) const;
    };
    static Memory MemoryOf(const b2Contact& contact);
    const b2Manifold* ManifoldBefore(const b2Contact& contact) const;

    std::vector<Memory> m_before; // sorted by address of the contact
};

} // namespace boxreel
