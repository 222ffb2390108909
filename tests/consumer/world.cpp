// SPDX-License-Identifier: MIT
// A world as a candidate at all three depths: links every library of boxreel.
#include <Box2D/Box2D.h>
#include <golden/GoldenWorld.h>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    const auto candidate = boxreel::CandidateOf(world, "empty");
    return candidate && candidate->stateHash.size() == 16 ? 0 : 1;
}
