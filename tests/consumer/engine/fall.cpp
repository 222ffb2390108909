// SPDX-License-Identifier: MIT
#ifdef FALL_24
#include <box2d/box2d.h>
#else
#include <Box2D/Box2D.h>
#endif

#include <cstdio>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    b2Body* const made = world.CreateBody(&body);
    made->CreateFixture(&ball, 1.0f);
    for (int step = 0; step < 60; ++step)
    {
        world.Step(1.0f / 60.0f, 8, 3);
    }
    std::printf("after a second it falls at %.1f m/s\n", double(made->GetLinearVelocity().y));
    return 0;
}
