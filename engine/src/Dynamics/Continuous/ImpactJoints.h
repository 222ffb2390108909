// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

/// Joints of what an impact within a step has stopped, in small steps. An impact knows its two
/// bodies only: they stay where they met, while what hangs on them has gone on to the end of the
/// step. It is drawn back to them, by poses alone, and what it is lifted by that, or winds up in
/// springs, costs it speed. What leans on something that does not move hardly gives way either.
/// Used by continuous collision.
namespace box2d
{

struct BodyData;
class World;

class ImpactJoints
{
public:
    explicit ImpactJoints(World& world) : m_world(world) {}

    /// Before the first body is stopped: how far joints are open.
    void NoteStarts();
    /// That the body has come elsewhere than the step had brought it.
    void NoteStopped(const BodyData& body);
    /// Draws what hangs on bodies that were stopped back to them. Whether there was anything.
    bool Close();

private:
    SolverContext ClearWays() const;
    double WoundUp(int32 part, const SolverContext& context) const;
    float32 ShareLeft(int32 part, const SolverContext& context) const;
    void Take(b2Body& body, const SolverBody& drawn, float32 share);

    World& m_world;
    bool m_noted = false;
    bool m_any = false;
};

} // namespace box2d
