// SPDX-License-Identifier: MIT
// A ball bounces in a yard and a crate hangs on a spring; every second their heights are printed.
#include <Box2D/Box2D.h>

#include <cstdio>

struct Thing
{
    const char* name;
};

int main()
{
    Thing ballThing{"ball"}, crateThing{"crate"};
    b2World world(b2Vec2(0.0f, -10.0f));
    world.SetRestitutionThreshold(0.5f); // of the world instead of each fixture

    b2BodyDef groundDef;
    b2Body* ground = world.CreateBody(&groundDef);
    const b2Vec2 yard[] = {{-8.0f, 0.0f}, {-8.0f, 9.0f}, {8.0f, 9.0f}, {8.0f, 0.0f}};
    b2ChainShape walls;
    walls.CreateLoop(yard, 4);
    walls.m_oneSided = true; // stops what is inside only, as in 2.4
    ground->CreateFixture(&walls, 0.0f);

    b2BodyDef ballDef;
    ballDef.type = b2_dynamicBody;
    ballDef.position.Set(-3.0f, 5.0f);
    ballDef.userData = &ballThing;
    b2Body* ball = world.CreateBody(&ballDef);
    b2CircleShape round;
    round.m_radius = 0.5f;
    b2FixtureDef rubber;
    rubber.shape = &round;
    rubber.density = 1.0f;
    rubber.restitution = 0.5f;
    ball->CreateFixture(&rubber);

    b2BodyDef crateDef;
    crateDef.type = b2_dynamicBody;
    crateDef.position.Set(3.0f, 5.0f);
    crateDef.userData = &crateThing;
    crateDef.active = true;
    b2Body* crate = world.CreateBody(&crateDef);
    b2PolygonShape box;
    box.SetAsBox(0.5f, 0.5f);
    crate->CreateFixture(&box, 2.0f);

    b2DistanceJointDef spring;
    spring.Initialize(ground, crate, b2Vec2(3.0f, 8.0f), crate->GetPosition());
    spring.minLength = 1.0f;
    spring.maxLength = 6.0f;
    spring.frequencyHz = 1.0f; // instead of a stiffness for this frequency
    spring.dampingRatio = 0.5f;
    world.CreateJoint(&spring);

    b2Body* const things[] = {ball, crate};
    for (int second = 1; second <= 4; ++second)
    {
        for (int step = 0; step < 60; ++step)
        {
            world.Step(1.0f / 60.0f, 8, 3);
        }
        for (b2Body* body : things)
        {
            const Thing* thing = static_cast<const Thing*>(body->GetUserData());
            std::printf("%d s: %s %.1f m\n", second, thing->name, body->GetPosition().y);
        }
    }
}
