// SPDX-License-Identifier: MIT
#include <Box2D/Dynamics/b2WorldCallbacks.h>

#include <Box2D/Dynamics/b2Fixture.h>

bool b2ContactFilter::ShouldCollide(b2Fixture* fixtureA, b2Fixture* fixtureB)
{
    const b2Filter& a = fixtureA->GetFilterData();
    const b2Filter& b = fixtureB->GetFilterData();
    if (a.groupIndex != 0 && a.groupIndex == b.groupIndex)
    {
        return a.groupIndex > 0;
    }
    return (a.maskBits & b.categoryBits) != 0 && (b.maskBits & a.categoryBits) != 0;
}
