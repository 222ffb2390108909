// SPDX-License-Identifier: MIT
// A ball bounces on a page that plays it: ball.html.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <page/PageWriter.h>

#include <cstdint>
#include <cstdio>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2PolygonShape floor;
    floor.SetAsBox(5.0f, 0.25f, b2Vec2(0.0f, -0.25f), 0.0f);
    b2BodyDef def;
    world.CreateBody(&def)->CreateFixture(&floor, 0.0f);
    b2CircleShape shape;
    shape.m_radius = 0.5f;
    b2FixtureDef bouncy;
    bouncy.shape = &shape;
    bouncy.density = 1.0f;
    bouncy.restitution = 0.7f;
    def.type = b2_dynamicBody;
    def.position.Set(0.0f, 4.0f);
    b2Body* const ball = world.CreateBody(&def);
    ball->CreateFixture(&bouncy);

    auto page =
        boxreel::PageWriter::Open("ball.html", {.width = 640, .height = 360, .title = "A ball"});
    if (!page)
    {
        std::puts(page.GetError().Text().c_str());
        return 1;
    }
    for (int step = 0; step < 240; ++step)
    {
        const b2Vec2 at = ball->GetPosition();
        const b2Vec2 velocity = ball->GetLinearVelocity();
        const boxreel::PageBody bodies[] = {{std::uint32_t(ball->GetNumber()),
                                             {at.x, at.y},
                                             ball->GetAngle(),
                                             "ball",
                                             {velocity.x, velocity.y},
                                             ball->GetAngularVelocity()}};
        if (!page->Append(boxreel::DrawListOf(world), {640, 360, 0.0, 2.0, 60.0}, bodies))
        {
            return 1;
        }
        world.Step(1.0f / 60.0f, 8, 3);
    }
    return page->Close() ? 0 : 1;
}
