// SPDX-License-Identifier: MIT
// A weight falls on a plank and throws what lies on its other end: catapult.mp4, or the film that
// is named. The camera keeps in view what moves; the film ends when everything rests.
#include <Box2D/Box2D.h>
#include <debugdraw/DrawCollector.h>
#include <debugdraw/WorldBounds.h>
#include <recorder/Recording.h>

#include <cstdio>

namespace
{

b2Body* AddBox(b2World& world, b2BodyType type, b2Vec2 center, b2Vec2 halfSize, float density)
{
    b2BodyDef def;
    def.type = type;
    def.position = center;
    b2PolygonShape box;
    box.SetAsBox(halfSize.x, halfSize.y);
    b2Body* const body = world.CreateBody(&def);
    body->CreateFixture(&box, density);
    return body;
}

bool IsAsleep(b2World& world)
{
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        if (body->GetType() != b2_staticBody && body->IsAwake())
        {
            return false;
        }
    }
    return true;
}

} // namespace

int main(int argc, char** argv)
{
    b2World world(b2Vec2(0.0f, -10.0f));
    b2Body* const ground =
        AddBox(world, b2_staticBody, b2Vec2(0.0f, -0.5f), b2Vec2(20.0f, 0.5f), 0.0f);
    b2Body* const plank =
        AddBox(world, b2_dynamicBody, b2Vec2(0.0f, 1.0f), b2Vec2(4.0f, 0.1f), 1.0f);
    AddBox(world, b2_dynamicBody, b2Vec2(-3.7f, 1.3f), b2Vec2(0.2f, 0.2f), 1.0f);
    AddBox(world, b2_dynamicBody, b2Vec2(3.4f, 6.0f), b2Vec2(0.5f, 0.5f), 5.0f);
    b2RevoluteJointDef pivot;
    pivot.Initialize(ground, plank, plank->GetPosition());
    pivot.enableLimit = true; // its ends stay above the ground
    pivot.lowerAngle = -0.22f;
    pivot.upperAngle = 0.22f;
    world.CreateJoint(&pivot);

    const char* const path = argc > 1 ? argv[1] : "catapult.mp4";
    const boxreel::VideoSettings settings{.width = 480, .height = 270, .framesPerSecond = {30, 1}};
    auto film = boxreel::Recording::Open(path, settings);
    if (!film)
    {
        std::fprintf(stderr, "%s\n", film.GetError().Text().c_str());
        return 1;
    }
    boxreel::FitCamera camera(settings.width, settings.height, boxreel::BoundsAtStart(world));
    constexpr int kLongest = 1200; // steps, should it never rest
    for (int step = 0; step < kLongest && !IsAsleep(world); ++step)
    {
        if (step % 2 == 0) // 60 steps and 30 frames a second
        {
            film->Add(boxreel::DrawListOf(world), camera.View());
        }
        world.Step(1.0f / 60.0f, 8, 3);
        camera.Update(boxreel::BoundsOfMovers(world), 1.0 / 60.0);
    }
    const auto closed = film->Close();
    if (!closed)
    {
        std::fprintf(stderr, "%s\n", closed.GetError().Text().c_str());
        return 1;
    }
}
