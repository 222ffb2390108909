// SPDX-License-Identifier: MIT
#include "../State/World.h"

#include "../Continuous/ImpactMemory.h"
#include "../Energy/EnergyGuard.h"
#include "../Solver/SolverMemory.h"
#include "../State/Access.h"
#include "../SubSteps/SubStepMemory.h"

#include <Box2D/Dynamics/Contacts/b2Contact.h>
#include <Box2D/Dynamics/b2Body.h>

namespace box2d
{

World::World(b2World& worldOwner, const b2Vec2& worldGravity, bool doSleep)
    : owner(worldOwner), solver(std::make_unique<SolverMemory>()),
      subSteps(std::make_unique<SubStepMemory>()), energyGuard(std::make_unique<EnergyGuard>()),
      impacts(std::make_unique<ImpactMemory>()),
      gravity(worldGravity.IsValid() ? worldGravity : b2Vec2(0.0f, 0.0f)), allowSleep(doSleep)
{}

// Listeners are not called. Large blocks (long chains) are freed one by one, all others with the
// allocator's chunks.
World::~World()
{
    for (b2Body* body = bodyList; body;)
    {
        b2Body* next = body->GetNext();
        for (b2Fixture* fixture = body->GetFixtureList(); fixture;)
        {
            b2Fixture* nextFixture = fixture->GetNext();
            FreeFixture(*fixture);
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
