// SPDX-License-Identifier: MIT
// A box falls on the ground: where it is and how it stands, sixty times a second.
#include <Box2D/Box2D.h>

#include <cstdio>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f)); // gravity [m/s^2]

    b2BodyDef groundDef; // static unless said
    groundDef.position.Set(0.0f, -10.0f);
    b2PolygonShape groundBox;
    groundBox.SetAsBox(50.0f, 10.0f); // half the width, half the height [m]
    world.CreateBody(&groundDef)->CreateFixture(&groundBox, 0.0f);

    b2BodyDef bodyDef;
    bodyDef.type = b2_dynamicBody;
    bodyDef.position.Set(0.0f, 4.0f);
    b2Body* const body = world.CreateBody(&bodyDef);
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f);
    b2FixtureDef fixture;
    fixture.shape = &box;
    fixture.density = 1.0f; // [kg/m^2]
    fixture.friction = 0.3f;
    body->CreateFixture(&fixture);

    for (int step = 0; step < 60; ++step)
    {
        world.Step(1.0f / 60.0f, 6, 2); // seconds, velocity and position iterations
        const b2Vec2 position = body->GetPosition();
        std::printf("%4.2f %4.2f %4.2f\n", position.x, position.y, body->GetAngle());
    }
}
