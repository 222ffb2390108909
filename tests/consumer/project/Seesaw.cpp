// SPDX-License-Identifier: MIT
#include "Seesaw.h"

namespace
{

b2Body* AddBox(b2World& world, float x, float y, float halfWidth, float halfHeight)
{
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position.Set(x, y);
    b2PolygonShape box;
    box.SetAsBox(halfWidth, halfHeight);
    b2Body* const made = world.CreateBody(&body);
    made->CreateFixture(&box, 2.0f);
    return made;
}

} // namespace

Seesaw::Seesaw()
{
    b2BodyDef body;
    b2Body* const ground = world.CreateBody(&body);
    b2EdgeShape floor;
    floor.Set(b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
    ground->CreateFixture(&floor, 0.0f);

    b2Body* const plank = AddBox(world, 0.0f, 1.5f, 5.0f, 0.1f);
    b2RevoluteJointDef pivot;
    pivot.Initialize(ground, plank, plank->GetPosition());
    world.CreateJoint(&pivot);

    AddBox(world, -4.5f, 2.0f, 0.4f, 0.4f);
    AddBox(world, 4.0f, 5.0f, 0.8f, 0.8f);
}

void Seesaw::Run(int steps)
{
    for (int step = 0; step < steps; ++step)
    {
        world.Step(1.0f / 60.0f, 8, 3);
    }
}
