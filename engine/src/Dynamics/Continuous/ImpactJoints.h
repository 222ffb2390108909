// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Solver.h"

/// Joints of bodies stopped by an impact, with sub-steps. An impact knows only its two bodies. They
/// stay where they met, while bodies joined to them have moved to the end of the step. These are
/// pulled back by changing poses only. The energy that this lifts or stores in springs is taken
/// from their velocity. Bodies supported by something static hardly move. Used by continuous
/// collision.
namespace box2d
{

struct BodyData;
class World;

class ImpactJoints
{
public:
    explicit ImpactJoints(World& world) : m_world(world) {}

    /// Records the joint errors; call before the first body is stopped.
    void NoteStarts();
    /// Records that the body is no longer at its pose of the step.
    void NoteStopped(const BodyData& body);
    /// Pulls connected bodies back to stopped ones. Returns true if there were any.
    bool Close();

private:
    SolverContext ClearPaths() const;
    double WoundUp(int32 part, const SolverContext& context) const;
    float32 ShareLeft(int32 part, const SolverContext& context) const;
    void Take(b2Body& body, const SolverBody& drawn, float32 share);

    World& m_world;
    bool m_noted = false;
    bool m_any = false;
};

} // namespace box2d
