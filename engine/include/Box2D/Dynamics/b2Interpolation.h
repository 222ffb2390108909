// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/b2Math.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

#include <vector>

class b2World;

/// @file
/// A world between two steps, for pictures of moments that no step ends at: the remedy for films
/// and screens whose rate is no divisor of the simulation's (Glenn Fiedler, "Fix Your Timestep!",
/// 2004). Additions to the manual's interface.
///
///     b2PoseRecord before;
///     before.Save(world);
///     world.Step(…);
///     {
///         const b2PosesBetween between(world, before, 0.25);
///         world.DrawDebugData(); // a quarter of the step's way
///     }

/// Where the bodies of a world were: those that can move, static ones are left out.
class b2PoseRecord
{
public:
    /// Replaces what was saved. Costs a pass over all bodies.
    void Save(const b2World& world);

private:
    friend class b2PosesBetween;
    struct Entry
    {
        int32 number = 0; ///< of the body
        box2d::Pose pose;
    };
    std::vector<Entry> m_entries; // newest body first, as in the world's list
    std::uint32_t m_step = 0;     // World::stepNumber
};

/// For as long as it lives every body has a pose between the saved one and its own: its centre of
/// mass on the straight line, its angle in proportion. Then each has its own again, to the last
/// bit. Meanwhile the world may be looked at and drawn, not changed: it is locked. Boxes of the
/// broad phase and what contacts have found stay those of the step.
///
/// A body that was not there, or is static, is shown where it is; one that the program has put
/// somewhere else since, farther than b2_maxTranslation, stays where it was.
class b2PosesBetween
{
public:
    /// `fraction`: 0 shows what was saved, 1 the world as it is. Another, and a world that is
    /// locked, asserts, and every body stays where it is.
    b2PosesBetween(b2World& world, const b2PoseRecord& before, double fraction);
    ~b2PosesBetween();
    b2PosesBetween(const b2PosesBetween&) = delete;
    b2PosesBetween& operator=(const b2PosesBetween&) = delete;

    /// No point of any body is shown farther from its place than this [m]. Who draws with
    /// b2Draw::SetView grows the view by it, for the broad phase finds bodies where they are.
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

    box2d::World* m_locked = nullptr; // null when the world was locked before
    std::vector<Own> m_owns;
    float32 m_farthest = 0.0f;
};
