// SPDX-License-Identifier: MIT
#include "ContactPoints.h"
#include "../State/Solver.h"

#include "../State/Access.h"
#include "../State/World.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2WorldCallbacks.h>

namespace box2d
{

bool EnumerateImpulses(float32 k11, float32 k12, float32 k22, float32 b1, float32 b2, float32& x1,
                       float32& x2)
{
    const float32 inverse = 1.0f / (k11 * k22 - k12 * k12);
    x1 = inverse * (k12 * b2 - k22 * b1);
    x2 = inverse * (k12 * b1 - k11 * b2);
    if (x1 >= 0.0f && x2 >= 0.0f)
    {
        return true;
    }
    x1 = -b1 / k11;
    x2 = 0.0f;
    if (x1 >= 0.0f && k12 * x1 + b2 >= 0.0f)
    {
        return true;
    }
    x1 = 0.0f;
    x2 = -b2 / k22;
    if (x2 >= 0.0f && k12 * x2 + b1 >= 0.0f)
    {
        return true;
    }
    x2 = 0.0f;
    return b1 >= 0.0f && b2 >= 0.0f;
}

void ReportImpulse(b2ContactListener& listener, b2Contact& contact)
{
    const b2Manifold& manifold = Data(contact).manifold;
    b2ContactImpulse impulse;
    impulse.count = manifold.pointCount;
    for (int32 i = 0; i < manifold.pointCount; ++i)
    {
        impulse.normalImpulses[i] = manifold.points[i].normalImpulse;
        impulse.tangentImpulses[i] = manifold.points[i].tangentImpulse;
    }
    listener.PostSolve(&contact, &impulse);
}

} // namespace box2d
