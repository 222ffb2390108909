// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

#include <vector>

using namespace boxreel;

namespace figures
{

Figure DrawFallingBox()
{
    Sketch sketch(640, 320, b2Vec2(0.0f, 2.0f), 48.0);
    b2World world(b2Vec2(0.0f, -10.0f));
    AddBody(world, b2_staticBody, Box(6.0f, 10.0f), b2Vec2(0.0f, -10.0f));
    b2Body* const box = AddBody(world, b2_dynamicBody, Box(1.0f, 1.0f), b2Vec2(0.0f, 4.0f));
    const b2Vec2 start = box->GetPosition();
    sketch.DrawFaint(world, 0.5);
    Run(world, 60);
    sketch.Draw(world);
    const b2Vec2 edge(1.0f, 0.0f);
    sketch.Label(start + edge, Side::Right, "start", kInk, 12.0);
    sketch.Label(box->GetPosition() + edge, Side::Right, "after 60 steps", kInk, 12.0);
    sketch.Arrow(start, box->GetPosition());
    const float32 height = box->GetPosition().y;
    sketch.Measure(b2Vec2(-1.0f, 0.0f), b2Vec2(-1.0f, height), Text(height, 3) + " m", 46.0);
    return sketch.Finished();
}

Figure DrawSlope()
{
    Sketch sketch(640, 320, b2Vec2(0.1f, 0.0f), 62.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const float32 angle = Degrees(25.0f);
    const b2Rot turn(angle);
    b2Body* const slope =
        AddBody(world, b2_staticBody, Box(5.0f, 0.12f), b2Vec2(0.0f, -0.35f), angle);
    slope->GetFixtureList()->SetFriction(1.0f);
    struct Slider
    {
        float32 friction, start;
    };
    const b2Vec2 above = 0.47f * turn.GetYAxis();
    for (const Slider& slider : {Slider{0.0f, -1.0f}, Slider{0.1f, 1.2f}, Slider{0.3f, 3.2f}})
    {
        const b2Vec2 place = slope->GetPosition() + slider.start * turn.GetXAxis() + above;
        b2Body* const box = AddBody(world, b2_dynamicBody, Box(0.4f, 0.335f), place, angle);
        box->GetFixtureList()->SetFriction(slider.friction);
        sketch.Label(place, Side::AboveLeft, "friction " + Text(slider.friction, 1), kInk, 44.0);
    }
    sketch.DrawFaint(world, 0.4);
    Run(world, 45);
    sketch.Draw(world);
    const b2Vec2 foot = slope->GetWorldPoint(b2Vec2(-4.6f, 0.12f));
    sketch.Dashes(foot, foot + b2Vec2(2.6f, 0.0f));
    sketch.ArcArrow(foot, 120.0, 0.0f, angle);
    sketch.Label(foot + b2Vec2(2.0f, 0.42f), Side::Right, "25 degrees", kInk, 4.0);
    return sketch.Finished();
}

Figure DrawBounces()
{
    Sketch sketch(640, 330, b2Vec2(0.0f, 1.8f), 76.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    world.SetSubStepCount(4); // so that a restitution of 1 comes back to where it fell from
    AddBody(world, b2_staticBody, Box(4.0f, 0.3f), b2Vec2(0.0f, -0.3f));
    for (const float32 restitution : {0.0f, 0.5f, 1.0f})
    {
        b2Body* const ball =
            AddBody(world, b2_dynamicBody, Disc(0.22f), b2Vec2(-3.4f + 4.6f * restitution, 3.3f));
        ball->GetFixtureList()->SetRestitution(restitution);
        ball->SetLinearVelocity(b2Vec2(1.05f, 0.0f));
        ball->GetFixtureList()->SetFriction(0.0f);
        sketch.Label(ball->GetPosition() - b2Vec2(0.22f, 0.0f), Side::AboveRight,
                     "restitution " + Text(restitution, 1), kInk, 34.0);
    }
    sketch.DrawFaint(world, 0.4);
    std::vector<std::vector<b2Vec2>> ways(3);
    for (int step = 0; step < 93; ++step)
    {
        Run(world);
        std::size_t i = 0;
        for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
        {
            if (body->GetType() == b2_dynamicBody)
            {
                ways[i++].push_back(body->GetPosition());
            }
        }
    }
    for (const std::vector<b2Vec2>& way : ways)
    {
        sketch.Trail(way);
    }
    sketch.Draw(world);
    return sketch.Finished();
}

namespace
{

/// Lets through what comes from below.
struct OneWay : public b2ContactListener
{
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        const bool isA = contact->GetFixtureA()->GetBody()->GetType() == b2_staticBody;
        const b2Fixture* const other = isA ? contact->GetFixtureB() : contact->GetFixtureA();
        b2WorldManifold manifold;
        contact->GetWorldManifold(&manifold);
        contact->SetEnabled((isA ? manifold.normal.y : -manifold.normal.y) >= 0.5f &&
                            other->GetBody()->GetLinearVelocity().y <= 0.5f);
    }
};

} // namespace

Figure DrawOneWayPlatform()
{
    Sketch sketch(640, 320, b2Vec2(0.0f, 0.15f), 80.0);
    OneWay listener;
    b2World world(b2Vec2(0.0f, -10.0f), false);
    world.SetContactListener(&listener);
    AddBody(world, b2_staticBody, Box(3.0f, 0.08f), b2Vec2(0.0f, -0.4f));
    b2Body* const ball = AddBody(world, b2_dynamicBody, Disc(0.25f), b2Vec2(-2.4f, -1.5f));
    ball->SetLinearVelocity(b2Vec2(2.6f, 7.4f));
    ball->SetAngularDamping(5.0f);
    ball->SetFixedRotation(true);
    ball->GetFixtureList()->SetFriction(1.0f);
    std::vector<b2Vec2> way;
    for (int step = 0; step < 120; ++step)
    {
        if (step == 0 || step == 10 || step == 26 || step == 54)
        {
            sketch.DrawFaint(world, 0.4 + 0.004 * step);
        }
        way.push_back(ball->GetPosition());
        Run(world);
    }
    sketch.Trail(way);
    sketch.Draw(world);
    sketch.Label(way.front(), Side::Right, "from below: through", kGood, 24.0);
    sketch.Label(ball->GetPosition() + b2Vec2(0.3f, 0.25f), Side::Right, "from above: solid",
                 kGood);
    return sketch.Finished();
}

Figure DrawSubSteps()
{
    Sketch sketch(640, 380, b2Vec2(0.0f, 4.8f), 30.0);
    struct Stack
    {
        float32 x;
        int32 subSteps;
        const char* name;
    };
    for (const Stack& stack : {Stack{-5.0f, 1, "1 step"}, Stack{5.0f, 4, "4 sub-steps"}})
    {
        b2World world(b2Vec2(0.0f, -10.0f));
        world.SetSubStepCount(stack.subSteps);
        AddBody(world, b2_staticBody, Box(50.0f, 1.0f), b2Vec2(0.0f, -1.0f));
        b2Body* top = nullptr;
        for (int i = 0; i < 10; ++i)
        {
            const b2Vec2 place(0.0f, 0.515f + 1.015f * float32(i)); // the skins' gap is 15 mm
            top = AddBody(world, b2_dynamicBody, Box(0.5f, 0.5f), place);
        }
        top->GetFixtureList()->SetDensity(1000.0f);
        top->ResetMassData();
        const b2Vec2 before = top->GetPosition() + b2Vec2(stack.x, 0.5f);
        sketch.Dashes(before - b2Vec2(1.6f, 0.0f), before + b2Vec2(1.6f, 0.0f));
        sketch.Label(before + b2Vec2(1.6f, 0.0f), Side::Right, "built to here", kQuiet, 6.0);
        Run(world, 600);
        // The manual's table has the same world: the stack is moved where it is drawn only.
        world.ShiftOrigin(b2Vec2(-stack.x, 0.0f));
        top->SetAwake(true); // and all that it rests on, for their colour
        if (stack.subSteps == 1)
        {
            sketch.Draw(world);
        }
        else
        {
            sketch.DrawFaint(world, 1.0); // without the ground, which is there already
        }
        const b2Vec2 after = top->GetPosition() + b2Vec2(0.0f, 0.5f);
        const float32 sunk = before.y - after.y;
        if (sunk > 0.1f) // more than the width of a line
        {
            const b2Vec2 left(0.9f, 0.0f);
            sketch.Measure(after - left, before - left, "sunk by " + Text(sunk, 2) + " m", 14.0);
        }
        sketch.Label(top->GetPosition(), Side::Right, "1000 kg", kInk, 26.0);
        sketch.Label(b2Vec2(stack.x, 0.0f), Side::Below, stack.name, kInk, 12.0);
    }
    return sketch.Finished();
}

} // namespace figures
