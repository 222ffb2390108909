// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

class b2Shape;

/// Keeps dynamic bodies on their side of static ones. A light body that something heavy presses
/// against a wall is driven deeper from step to step, because iterations do not converge. Once its
/// centre is beyond the wall, position correction would push it out on the other side. The centre
/// of a convex shape may never be inside a wall that the shape touches, so the step ends where it
/// would get there. If impacts have changed the path, each piece of it is checked. A body thrown
/// round a corner has a wall between its start and its end, but has not crossed it. Called after
/// continuous collision.
namespace box2d
{

struct ContactData;
struct ImpactStart;
struct ImpactTurn;
class ImpactJoints;
class World;

class Containment
{
public:
    explicit Containment(World& world);

    /// Records the starts of all paths; call before the first impact, which moves them.
    void NoteStarts();
    /// Records that the body's path continues from where an impact stopped it.
    void NoteTurn(const BodyData& body);
    /// Moves bodies back to the walls that the centres of their shapes crossed in the step, and
    /// removes the velocity into the wall. Returns true if there were any.
    bool Hold(ImpactJoints& joints);

private:
    /// A child of a shape, and its body.
    struct Part
    {
        b2Body* body;
        const b2Shape* shape;
        int32 child;
    };
    /// The poses of two bodies at a time.
    struct Moment
    {
        Pose moved, still;
    };
    struct Crossing
    {
        b2Vec2 place, normal; // in the static body's axes, from its centre of mass
        int32 turn;           // the last one before it
    };

    bool Hold(const ContactData& c, ImpactJoints& joints);
    bool HoldOne(const ContactData& c, ImpactJoints& joints);
    bool FindCrossing(const Part& moved, const Part& still, Crossing& crossing) const;
    static bool Crosses(const Part& moved, const Part& still, const Moment& from, const Moment& to,
                        Crossing& crossing);
    ImpactStart* NotedStart(const BodyData& body) const;
    const Pose& StartOf(const BodyData& body) const;

    World& m_world;
    Array<ImpactStart>& m_starts; // by awake body, if there was an impact
    Array<ImpactTurn>& m_turns;
};

} // namespace box2d
