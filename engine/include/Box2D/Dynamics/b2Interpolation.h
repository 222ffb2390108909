// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <vector>

class b2World;

/// @file
/// Shows a world at a time between two steps. For films and screens whose frame rate is not a
/// divisor of the simulation rate (Glenn Fiedler, "Fix Your Timestep!", 2004). Additions to the
/// manual's interface.
///
///     b2PoseRecord before;
///     before.Save(world);
///     world.Step(…);
///     {
///         const b2PosesBetween between(world, before, 0.25);
///         world.DrawDebugData(); // a quarter of the step
///     }

/// The poses of the dynamic and kinematic bodies of a world.
class b2PoseRecord
{
public:
    /// Replaces the saved poses. Costs one pass over all bodies.
    void Save(const b2World& world);

private:
    friend class b2PosesBetween;
    struct Entry
    {
        int32 number = 0; ///< number of the body
        box2d::Pose pose;
    };
    std::vector<Entry> m_entries; // newest body first, as in the world's list
    std::uint32_t m_step = 0;     // World::stepNumber
};

/// During its lifetime, every body has a pose interpolated between the saved and the current one.
/// The centre of mass moves on a straight line, the angle in proportion. The destructor restores
/// the exact poses. Meanwhile the world is locked: it may be read and drawn, not changed.
/// Broad-phase boxes and contact data remain those of the step.
///
/// A body that was not saved, or is static, keeps its current pose. A body that the program moved
/// further than b2_maxTranslation since keeps its saved pose.
class b2PosesBetween
{
public:
    /// `fraction`: 0 is the saved pose, 1 the current one. A fraction outside [0, 1] or a locked
    /// world asserts, and no pose changes.
    b2PosesBetween(b2World& world, const b2PoseRecord& before, double fraction);
    ~b2PosesBetween();
    b2PosesBetween(const b2PosesBetween&) = delete;
    b2PosesBetween& operator=(const b2PosesBetween&) = delete;

    /// Returns an upper bound of the distance between a point's drawn and current position [m].
    /// Callers of b2Draw::SetView enlarge the view by it, because the broad phase uses the current
    /// positions.
    float32 GetFarthest() const { return m_farthest; }

private:
    struct Own
    {
        b2Body* body = nullptr;
        box2d::Pose pose;
        b2Rot rotation;
        b2Transform transform;
        b2Vec2 worldCenter;
        float32 room = 0.0f;
    };
    void Show(b2Body& body, const box2d::Pose& pose);

    box2d::World* m_locked = nullptr; // null if the world was already locked
    std::vector<Own> m_owns;
    float32 m_farthest = 0.0f;
};
