// SPDX-License-Identifier: MIT
#include "../State/World.h"

#include "../Continuous/ImpactMemory.h"
#include "../Energy/EnergyGuard.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../SubSteps/SubStepMemory.h"
#include "Fixtures.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

World::World(b2World& worldOwner, const b2Vec2& worldGravity, bool doSleep)
    : owner(worldOwner), solver(std::make_unique<SolverMemory>()),
      subSteps(std::make_unique<SubStepMemory>()), energyGuard(std::make_unique<EnergyGuard>()),
      impacts(std::make_unique<ImpactMemory>())
{
    settings.gravity = worldGravity.IsValid() ? worldGravity : b2Vec2(0.0f, 0.0f);
    settings.allowSleep = doSleep;
}

// No listener is called: who destroys a world knows that everything in it goes. Blocks above the
// block allocator's sizes (long chains) are given back one by one, all others with its chunks.
World::~World()
{
    for (b2Body* body = bodyList; body;)
    {
        b2Body* next = body->GetNext();
        for (b2Fixture* fixture = body->GetFixtureList(); fixture;)
        {
            b2Fixture* nextFixture = fixture->GetNext();
            FreeFixture(allocator, *fixture);
            fixture = nextFixture;
        }
        body->~b2Body();
        body = next;
    }
    for (b2Joint* joint = jointList; joint;)
    {
        b2Joint* next = joint->GetNext();
        JointAccess::Destruct(*joint);
        joint = next;
    }
}

} // namespace box2d
