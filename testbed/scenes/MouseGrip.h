// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

namespace boxreel
{

class SceneState;

/// Drags bodies: pulls the dynamic body at a point behind the mouse by a mouse joint. The force is
/// at most a thousand times the one that would give it 1 m/s^2. Used by Scene only.
class MouseGrip
{
public:
    /// Grips the newest dynamic body at the point. Does nothing if there is none, or if a body is
    /// gripped already.
    void Take(b2World& world, const b2Vec2& point);
    void MoveTo(const b2Vec2& point);
    void LetGo(b2World& world);

    /// Joints go with their bodies.
    void Forget(const b2Joint* joint);
    /// The joint needs a second body, which is made when it is first needed.
    void VisitState(SceneState& state);

private:
    b2Joint* m_joint = nullptr; // a mouse joint
    b2Body* m_ground = nullptr;
};

} // namespace boxreel
