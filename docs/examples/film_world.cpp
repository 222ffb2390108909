// SPDX-License-Identifier: MIT
// A ball bounces: ball.mp4.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <recorder/Recording.h>

#include <cstdio>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2PolygonShape floor;
    floor.SetAsBox(5.0f, 0.25f, b2Vec2(0.0f, -0.25f), 0.0f);
    b2BodyDef body;
    world.CreateBody(&body)->CreateFixture(&floor, 0.0f);
    b2CircleShape ball;
    ball.m_radius = 0.5f;
    b2FixtureDef bouncy;
    bouncy.shape = &ball;
    bouncy.density = 1.0f;
    bouncy.restitution = 0.7f;
    body.type = b2_dynamicBody;
    body.position.Set(0.0f, 4.0f);
    world.CreateBody(&body)->CreateFixture(&bouncy);

    auto film = boxreel::Recording::Open("ball.mp4", {.width = 640, .height = 360});
    if (!film)
    {
        std::puts(film.GetError().Text().c_str());
        return 1;
    }
    for (int step = 0; step < 240; ++step)
    {
        world.Step(1.0f / 60.0f, 8, 3);
        film->Add(boxreel::DrawListOf(world), {640, 360, 0.0, 2.0, 60.0});
    }
    return film->Close() ? 0 : 1;
}
