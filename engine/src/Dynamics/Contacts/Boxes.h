// SPDX-License-Identifier: MIT
#pragma once

#include "../State/Access.h"

#include <Box2D/Dynamics/Internal/BodyData.h>

/// The boxes of fixtures in the broad phase.
namespace box2d
{

class Proxies;

/// Calls the function with each proxy of a body.
template <class Function>
void ForProxies(const BodyData& body, Function&& function)
{
    for (b2Fixture* f = body.fixtureList; f; f = f->GetNext())
    {
        for (int32 child = 0; child < FixtureAccess::ProxyCount(*f); ++child)
        {
            function(FixtureAccess::Proxies(*f)[child]);
        }
    }
}

void CreateProxies(Proxies& proxies, b2Fixture& fixture);
void DestroyProxies(Proxies& proxies, b2Fixture& fixture);
/// After its body has moved: new boxes where the shapes have left theirs. `swept` boxes also cover
/// the path from the pose at the start of the step.
void UpdateProxies(Proxies& proxies, BodyData& body, bool swept);
/// The first part of that, on the body alone. True if a shape has left its box.
bool RefreshBoxes(BodyData& body, bool swept);
/// The second part: reports new boxes to the broad phase.
void MoveProxies(Proxies& proxies, BodyData& body);
/// New boxes, whether the shapes have left theirs or not.
void ResetProxies(Proxies& proxies, BodyData& body);

} // namespace box2d
