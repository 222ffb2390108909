// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Common/Array.h>
#include <Box2D/Dynamics/Internal/BodyData.h>

/// Keeps what moves on its side of what does not. A light body that something heavy presses against
/// a wall is driven deeper from step to step, for sweeps spread what they cannot finish; once its
/// centre is beyond the wall it would be pushed out on the other side. No centre of a convex shape
/// has any business within a wall that the shape touches, so the step ends where it would get
/// there. Called by continuous collision, after it.
namespace box2d
{

struct ContactData;
struct ImpactStart;
class ImpactJoints;
class World;

class Containment
{
public:
    explicit Containment(World& world);

    /// Before the first impact, which moves the starts of ways.
    void NoteStarts();
    /// Takes bodies back to the walls that their shapes' centres have crossed in the step, and the
    /// speed at which they went there. Whether there were any.
    bool Hold(ImpactJoints& joints);

private:
    bool Hold(const ContactData& c, ImpactJoints& joints);
    const Pose& StartOf(const BodyData& body) const;

    World& m_world;
    Array<ImpactStart>& m_starts; // by awake body, when there was an impact
};

} // namespace box2d
