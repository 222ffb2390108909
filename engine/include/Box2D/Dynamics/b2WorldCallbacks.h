// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Settings.h>

/// @file
/// The interfaces through which a world speaks to the program. Every function has an empty body or
/// a sensible default unless it is the point of the interface.

struct b2Vec2;
struct b2Manifold;
class b2Contact;
class b2Fixture;
class b2Joint;

/// Told about joints and fixtures that vanish because a body they were attached to was destroyed.
class b2DestructionListener
{
public:
    virtual ~b2DestructionListener() = default;
    /// The joint will be destroyed right after.
    virtual void SayGoodbye(b2Joint* joint) { (void)joint; }
    /// The fixture will be destroyed right after.
    virtual void SayGoodbye(b2Fixture* fixture) { (void)fixture; }
};

/// Decides which fixtures collide.
class b2ContactFilter
{
public:
    virtual ~b2ContactFilter() = default;
    /// The default: by group when both are in the same one, else by category and mask.
    virtual bool ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB);
};

/// The impulses of a contact's points in one step, for b2ContactListener::PostSolve [N s].
struct b2ContactImpulse
{
    float32 normalImpulses[b2_maxManifoldPoints] = {};  ///< that keep the shapes apart
    float32 tangentImpulses[b2_maxManifoldPoints] = {}; ///< of friction
    int32 count = 0;                                    ///< of points, 0 to b2_maxManifoldPoints
};

/// Told about contacts. The world is locked inside these functions: it cannot be changed from
/// there.
class b2ContactListener
{
public:
    virtual ~b2ContactListener() = default;
    /// Two fixtures begin to touch. Only inside a step.
    virtual void BeginContact(b2Contact* contact) { (void)contact; }
    /// Two fixtures cease to touch. May come outside a step, when a body is destroyed.
    virtual void EndContact(b2Contact* contact) { (void)contact; }
    /// After a contact was updated, before it is solved: the place to disable it for this step. Not
    /// called for sensors. `oldManifold` is that of the step before.
    virtual void PreSolve(b2Contact* contact, const b2Manifold* oldManifold)
    {
        (void)contact;
        (void)oldManifold;
    }
    /// After a contact was solved, with its impulses.
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
    /// True goes on, false ends the query.
    virtual bool ReportFixture(b2Fixture* fixture) = 0;
};

/// Called for each fixture that b2World::RayCast hits, in no particular order.
class b2RayCastCallback
{
public:
    virtual ~b2RayCastCallback() = default;
    /// The ray meets `fixture` at `point` [m], where the surface's unit `normal` is, after
    /// `fraction` of its way, 0 to 1. Returns how to go on: -1 ignore this fixture, 0 end,
    /// `fraction` clip the ray here, 1 go on as if nothing had been hit.
    virtual float32 ReportFixture(b2Fixture* fixture, const b2Vec2& point, const b2Vec2& normal,
                                  float32 fraction) = 0;
};
