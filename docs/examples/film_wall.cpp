// SPDX-License-Identifier: MIT
// A ball on a chain swings through a wall. film_wall FILE [dark]: a light picture, or a dark one.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <recorder/Recording.h>

#include <cstdio>

namespace
{

b2Body* AddBody(b2World& world, b2BodyType type, b2Vec2 position, const b2Shape& shape,
                float density)
{
    b2BodyDef def;
    def.type = type;
    def.position = position;
    b2Body* const body = world.CreateBody(&def);
    body->CreateFixture(&shape, density);
    return body;
}

b2PolygonShape Box(float width, float height)
{
    b2PolygonShape box;
    box.SetAsBox(0.5f * width, 0.5f * height);
    return box;
}

void Hang(b2World& world, b2Body* from, b2Body* to, b2Vec2 hinge)
{
    b2RevoluteJointDef def;
    def.Initialize(from, to, hinge);
    world.CreateJoint(&def);
}

} // namespace

int main(int argc, char** argv)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* last = AddBody(world, b2_staticBody, b2Vec2(0.0f, -0.5f), Box(60.0f, 1.0f), 0.0f);
    constexpr int kRows = 10, kColumns = 4;
    for (int row = 0; row < kRows; ++row)
    {
        for (int column = 0; column < kColumns; ++column)
        {
            const float x = 1.5f + 1.2f * float(column) + (row % 2 ? 0.3f : 0.0f);
            AddBody(world, b2_dynamicBody, b2Vec2(x, 0.3f + 0.6f * float(row)), Box(1.2f, 0.6f),
                    1.0f);
        }
    }
    constexpr float kAngle = -2.74f; // of the chain at the start [rad]
    const b2Vec2 along = b2Rot(kAngle).GetXAxis();
    b2Vec2 hinge(-0.4f, 9.6f);
    for (int link = 0; link < 10; ++link, hinge += 0.7f * along)
    {
        b2Body* const next =
            AddBody(world, b2_dynamicBody, hinge + 0.35f * along, Box(0.8f, 0.22f), 8.0f);
        next->SetTransform(next->GetPosition(), kAngle);
        Hang(world, last, next, hinge);
        last = next;
    }
    b2CircleShape ball;
    ball.m_radius = 1.0f;
    Hang(world, last, AddBody(world, b2_dynamicBody, hinge + along, ball, 12.0f), hinge);

    const bool isDark = argc > 2;
    boxreel::Theme theme = isDark ? boxreel::Theme::Dark() : boxreel::Theme::Print();
    theme.outlineWidth = 2.75f;
    theme.fillShade = isDark ? 0.8f : 1.0f;
    theme.fillAlpha = isDark ? 1.0f : 0.8f;
    const boxreel::Color rows[] = {
        {230, 90, 60}, {240, 160, 30}, {60, 170, 110}, {50, 140, 220}, {160, 100, 220}};
    const boxreel::Color ground =
        isDark ? boxreel::Color{90, 100, 115} : boxreel::Color{150, 158, 170};
    const boxreel::Color iron = isDark ? boxreel::Color{225, 230, 238} : boxreel::Color{50, 56, 66};

    auto film = boxreel::Recording::Open(argc > 1 ? argv[1] : "wall.webp",
                                         {.width = 672, .height = 378, .framesPerSecond = {15, 1}},
                                         {.theme = theme});
    for (int step = 0; film && step < 236; ++step)
    {
        if (step >= 64 && step % 4 == 0) // 60 steps and 15 frames per second
        {
            boxreel::DrawList list = boxreel::DrawListOf(world, b2Draw::e_shapeBit);
            for (boxreel::DrawItem& item : list.items) // owner: the number of the body
            {
                const int brick = int(item.owner) - 1;
                item.role = boxreel::ColorRole::None;
                item.color = brick < 0                  ? ground
                             : brick < kRows * kColumns ? rows[brick / kColumns % 5]
                                                        : iron;
            }
            film->Add(list, {672, 378, 2.5, 4.2, 40.0}); // pixels, centre, pixels per metre
        }
        world.Step(1.0f / 60.0f, 8, 3);
    }
    const auto closed = film ? film->Close() : boxreel::Result<void>(film.GetError());
    if (!closed)
    {
        std::fprintf(stderr, "%s\n", closed.GetError().Text().c_str());
        return 1;
    }
}
