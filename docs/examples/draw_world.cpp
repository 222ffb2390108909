// SPDX-License-Identifier: MIT
// A ball is thrown over a box: ball.png and ball.svg show where it is after a second, and its path.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/Trail.h>
#include <render/FigureSheet.h>
#include <render/Png.h>
#include <render/Renderer.h>

int main()
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2PolygonShape box;
    box.SetAsBox(1.0f, 1.0f, b2Vec2(4.0f, 1.0f), 0.0f);
    b2BodyDef body;
    world.CreateBody(&body)->CreateFixture(&box, 0.0f);
    body.type = b2_dynamicBody;
    body.linearVelocity.Set(8.0f, 9.0f);
    b2Body* ball = world.CreateBody(&body);
    b2CircleShape round;
    round.m_radius = 0.5f;
    ball->CreateFixture(&round, 1.0f);

    std::vector<boxreel::Vec2> path;
    for (int step = 0; step < 60; ++step)
    {
        world.Step(1.0f / 60.0f, 8, 3);
        path.push_back({ball->GetPosition().x, ball->GetPosition().y});
    }
    const boxreel::Camera camera{640, 360, 4.0, 2.5, 45.0}; // pixels, centre, pixels a metre
    boxreel::DrawList list;
    boxreel::AddTrail(list, camera, path);
    boxreel::DrawCollector collector(list);
    collector.SetFlags(b2Draw::e_shapeBit);
    world.SetDebugDraw(&collector);
    world.DrawDebugData();

    boxreel::Frame frame;
    auto renderer = boxreel::Renderer::Create({.width = camera.width, .height = camera.height});
    const bool drawn = renderer && renderer->Draw(list, camera, frame) &&
                       WritePng("ball.png", frame, {.overwrite = true});
    const auto sheet = boxreel::SheetOf({{list, camera}}, {.axes = true, .caption = "A throw."});
    return drawn && WriteSvg("ball.svg", sheet, {.overwrite = true}) ? 0 : 1;
}
