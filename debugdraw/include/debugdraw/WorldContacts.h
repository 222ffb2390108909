// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>
#include <debugdraw/DrawList.h>
#include <debugdraw/View.h>

#include <vector>

/// @file
/// Where the bodies of a world touch, and what they do to each other there. Read from the contacts
/// as the last step left them, without a listener; the world is never changed.
namespace boxreel
{

/// What is drawn of contacts, and how large.
struct ContactLook
{
    bool points = false;   ///< dots: those that were not there before the last step are larger
    bool normals = false;  ///< lines of 12 pixels, from the first fixture towards the second
    bool impulses = false; ///< arrows: what keeps the shapes apart, as the second body feels it
    bool friction = false; ///< arrows with open heads: the same along the surface
    /// An impulse is shown as the mean force of a step, so that arrows do not depend on its length.
    /// Above 0.
    double stepsPerSecond = 60.0;
    double metersPerNewton = 0.01; ///< length of an arrow, 0 or more
};

/// Remembers which contact points there were, to tell the new ones from the old ones.
class ContactCollector
{
public:
    /// Call before each step. What there is now is old from then on.
    void Remember(const b2World& world);

    /// Adds what `look` asks for, a layer after the other, the points last and on top.
    void Collect(const b2World& world, const View& view, const ContactLook& look,
                 DrawList& list) const;

private:
    /// What a contact was like. Memory is used again, so its address says little by itself.
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

    std::vector<Memory> m_before; // by address of the contact, to be found
};

} // namespace boxreel
