// SPDX-License-Identifier: MIT
// A film of a world of Box2D 2.4, as Debian's libbox2d-dev has it: bridge.mp4, or the film that is
// named. Boxes fall on a bridge of planks.
#include <debugdraw/Box2d24Draw.h>
#include <recorder/Recording.h>

#include <cstdio>

namespace
{

b2Body* AddBox(b2World& world, b2Vec2 center, b2Vec2 halfSize)
{
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position = center;
    b2PolygonShape box;
    box.SetAsBox(halfSize.x, halfSize.y);
    b2Body* const body = world.CreateBody(&def);
    body->CreateFixture(&box, 1.0f);
    return body;
}

void AddHinge(b2World& world, b2Body* left, b2Body* right, float x)
{
    b2RevoluteJointDef hinge;
    hinge.Initialize(left, right, b2Vec2(x, 0.0f));
    world.CreateJoint(&hinge);
}

} // namespace

int main(int argc, char** argv)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2BodyDef nothing;
    b2Body* const banks = world.CreateBody(&nothing);
    b2PolygonShape bank;
    for (const float x : {-8.0f, 8.0f})
    {
        bank.SetAsBox(2.0f, 1.0f, b2Vec2(x, -1.0f), 0.0f);
        banks->CreateFixture(&bank, 0.0f);
    }
    b2Body* last = banks;
    for (int plank = 0; plank < 12; ++plank)
    {
        const float x = float(plank) - 5.5f;
        b2Body* const next = AddBox(world, b2Vec2(x, 0.0f), b2Vec2(0.5f, 0.1f));
        AddHinge(world, last, next, x - 0.5f);
        last = next;
    }
    AddHinge(world, last, banks, 6.0f);
    for (int box = 0; box < 4; ++box)
    {
        AddBox(world, b2Vec2(1.5f * float(box) - 2.0f, 3.0f + float(box)), b2Vec2(0.4f, 0.4f));
    }

    const char* const path = argc > 1 ? argv[1] : "bridge.mp4";
    auto film =
        boxreel::Recording::Open(path, {.width = 480, .height = 270, .framesPerSecond = {30, 1}});
    if (!film)
    {
        std::fprintf(stderr, "%s\n", film.GetError().Text().c_str());
        return 1;
    }
    const boxreel::Camera camera{480, 270, 0.0, 0.5, 24.0}; // pixels, centre, pixels a metre
    for (int frame = 0; frame < 120; ++frame)
    {
        film->Add(boxreel::box2d24::DrawListOf(world), camera);
        world.Step(1.0f / 60.0f, 8, 3);
        world.Step(1.0f / 60.0f, 8, 3);
    }
    const auto closed = film->Close();
    if (!closed)
    {
        std::fprintf(stderr, "%s\n", closed.GetError().Text().c_str());
        return 1;
    }
}
