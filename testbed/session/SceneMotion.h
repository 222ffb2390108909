// SPDX-License-Identifier: MIT
#pragma once

#include "SceneSession.h"

#include <options/MotionChoice.h>

#include <map>
#include <set>
#include <vector>

/// Observes a scene step by step and adds the items of a MotionLook to its stills: trails, earlier
/// poses, dimensions, the origin.
namespace boxreel
{

class SceneMotion
{
public:
    /// For pictures at these steps, before the first step. Unusable when a body that the look names
    /// is not there and cannot come, or when there are too many poses.
    static Result<SceneMotion> Create(const MotionLook& look, SceneSession& session,
                                      const std::vector<std::int64_t>& moments);

    /// Advances the session to `step` and observes every step.
    void AdvanceTo(SceneSession& session, std::int64_t step);

    /// Returns the drawings over the picture of the session's step, without labels: dimensions and
    /// the origin.
    DrawList Notes(SceneSession& session);

    /// Returns the picture of the session's step: `scene`, with trails and earlier poses beneath
    /// it. `scene` is drawn at scale 1 and already contains the notes. The step is one of the
    /// moments.
    DrawList Picture(SceneSession& session, const DrawList& scene) const;

    /// Call after the last picture. Unusable if a named body never existed, or a measured body is
    /// in no picture.
    Result<void> CheckBodiesCame() const;

private:
    /// The poses of bodies at a step.
    struct Pose
    {
        DrawList list;
        std::set<std::uint32_t> bodies; // those that are shown
    };
    /// The path of a body's centre of mass, step by step.
    struct Way
    {
        std::int64_t firstStep = 0;
        std::vector<Vec2> places; // [m]
    };

    explicit SceneMotion(const MotionLook& look) : m_look(look) {}
    std::vector<std::int64_t> PosesFor(std::int64_t moment, const Rational& stepsPerSecond) const;
    void Observe(SceneSession& session);
    void AddDimensions(const SceneSession& session, DrawList& list) const;
    DrawList Dimensions(SceneSession& session) const;
    void AddTrails(const SceneSession& session, DrawList& list) const;
    void AddPoses(SceneSession& session, DrawList& list) const;

    MotionLook m_look;
    std::map<std::int64_t, Pose> m_poses; // by the steps that pictures need
    std::map<int, Way> m_ways;            // by the bodies' numbers
    int m_made = 0;                       // bodies so far
    std::set<int> m_measured;             // bodies that were there when they were to be measured
};

} // namespace boxreel
