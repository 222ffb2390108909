// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// Callback interfaces of a world. Functions have an empty body or a default, except those that are
/// the purpose of their interface.

struct b2Vec2;
struct b2Manifold;
class b2Contact;
class b2Fixture;
class b2Joint;

/// Called for joints and fixtures that are destroyed with their body.
class b2DestructionListener
{
public:
    virtual ~b2DestructionListener() = default;
    /// Called before the joint is destroyed.
    virtual void SayGoodbye(b2Joint* joint) { (void)joint; }
    /// Called before the fixture is destroyed.
    virtual void SayGoodbye(b2Fixture* fixture) { (void)fixture; }
};

/// Decides which fixtures collide.
class b2ContactFilter
{
public:
    virtual ~b2ContactFilter() = default;
    /// Returns true if the fixtures may collide. The default uses the group if both have the same
    /// one, otherwise category and mask.
    virtual bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB);
};

/// The impulses of a contact's points in one step [N s], for b2ContactListener::PostSolve.
struct b2ContactImpulse
{
    float32 normalImpulses[b2_maxManifoldPoints] = {};  ///< non-penetration impulses
    float32 tangentImpulses[b2_maxManifoldPoints] = {}; ///< friction impulses
    int32 count = 0;                                    ///< number of points, 0 to
                                                        ///< b2_maxManifoldPoints
};

/// Called for contacts. The world is locked inside these functions and cannot be changed.
class b2ContactListener
{
public:
    virtual ~b2ContactListener() = default;
    /// Two fixtures begin to touch. Called only inside a step.
    virtual void BeginContact(b2Contact* contact) { (void)contact; }
    /// Two fixtures cease to touch. Called outside a step too, when a body is destroyed.
    virtual void EndContact(b2Contact* contact) { (void)contact; }
    /// Called after a contact was updated and before it is solved; it can be disabled here for this
    /// step. Not called for sensors. `oldManifold` is that of the previous step.
    virtual void PreSolve(b2Contact* contact, const b2Manifold* oldManifold)
    {
        (void)contact;
        (void)oldManifold;
    }
    /// Called after a contact was solved, with its impulses.
    virtual void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse)
    {
        (void)contact;
        (void)impulse;
    }
};

/// Called for each fixture that b2World::QueryAABB finds.
class b2QueryCallback
{
public:
    virtual ~b2QueryCallback() = default;
    /// Returns true to continue the query, false to end it.
    virtual bool ReportFixture(b2Fixture* fixture) = 0;
};

/// Called for each fixture that b2World::RayCast hits, in no particular order.
class b2RayCastCallback
{
public:
    virtual ~b2RayCastCallback() = default;
    /// Called for a hit at `point` [m] with the unit `normal` of the surface, at `fraction` of the
    /// ray, 0 to 1. The return value controls the cast: -1 ignores this fixture, 0 ends the cast,
    /// `fraction` clips the ray here, 1 continues.
    virtual float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                                  float32 fraction) = 0;
};
