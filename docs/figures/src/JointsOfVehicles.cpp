// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{

Figure DrawWheelJoint()
{
    Sketch sketch(640, 380, b2Vec2(0.05f, 0.42f), 136.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2Vec2 ground[5] = {
        {-8.0f, -0.9f}, {0.3f, -0.9f}, {0.8f, -0.65f}, {1.5f, -0.65f}, {5.0f, -0.9f}};
    b2ChainShape road;
    road.CreateChain(ground, 5);
    AddGround(world, road)->GetFixtureList()->SetFriction(0.9f);
    const b2Vec2 start(-4.0f, 0.3f);
    const b2Vec2 corners[6] = {{-1.5f, -0.35f}, {1.5f, -0.35f}, {1.5f, 0.1f},
                               {0.7f, 0.2f},    {0.1f, 0.6f},   {-1.4f, 0.55f}};
    b2PolygonShape hull;
    hull.Set(corners, 6);
    b2Body* const car = AddBody(world, b2_dynamicBody, hull, start);
    b2Joint* axles[2];
    for (int i = 0; i < 2; ++i)
    {
        const b2Vec2 hub = start + b2Vec2(i == 0 ? -0.9f : 0.9f, -0.72f);
        b2Body* const wheel = AddBody(world, b2_dynamicBody, Disc(0.4f), hub);
        wheel->GetFixtureList()->SetFriction(0.9f);
        b2WheelJointDef def;
        def.Initialize(car, wheel, hub, b2Vec2(0.0f, 1.0f));
        def.enableMotor = i == 0;
        def.motorSpeed = -5.0f;
        def.maxMotorTorque = 4.0f;
        def.frequencyHz = 4.0f;
        axles[i] = world.CreateJoint(&def);
    }
    for (int step = 0; step < 600 && car->GetPosition().x < 0.0f; ++step)
    {
        Run(world);
    }
    sketch.Draw(world);
    sketch.DrawGlyphs(world);

    const b2Vec2 hub = axles[1]->GetAnchorB();
    const b2Vec2 axis = car->GetWorldVector(b2Vec2(0.0f, 1.0f));
    sketch.Dashes(hub - 0.55f * axis, hub + 1.75f * axis);
    sketch.Label(hub + 1.75f * axis, Side::Above, "axis: localAxisA", kInk, 3.0);
    sketch.Note(hub, 76.0, 52.0, "anchor");
    sketch.Note(hub + 0.32f * b2Rot(Degrees(-15.0f)).GetXAxis(), 60.0, 4.0, "bodyB");
    sketch.Label(car->GetPosition(), Side::On, "bodyA");
    const b2Vec2 drive = axles[0]->GetAnchorB();
    sketch.ArcArrow(drive, 66.0, Degrees(235.0f), Degrees(130.0f));
    sketch.Label(drive - b2Vec2(0.55f, 0.0f), Side::Left, "motorSpeed", kInk, 4.0);
    sketch.Note(axles[0]->GetAnchorB() + 0.22f * axis, -112.0, 60.0, "spring");
    return sketch.Finished();
}

Figure DrawWeldJoint()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    b2Body* const wall = AddBody(world, b2_staticBody, Box(0.3f, 1.3f), b2Vec2(-3.0f, 0.0f));
    b2Body* last = wall;
    b2WeldJointDef def;
    def.frequencyHz = 20.0f;
    def.dampingRatio = 0.7f;
    for (int i = 0; i < 5; ++i)
    {
        const b2Vec2 joint(-2.7f + 1.0f * float32(i), 0.5f);
        b2Body* const plank =
            AddBody(world, b2_dynamicBody, Box(0.48f, 0.12f), joint + b2Vec2(0.5f, 0.0f));
        def.Initialize(last, plank, joint);
        world.CreateJoint(&def);
        last = plank;
    }
    sketch.DrawFaint(world, 0.4);
    Run(world, 300);
    sketch.Draw(world);
    sketch.DrawGlyphs(world);
    sketch.Note(b2Vec2(-2.7f, 0.5f), 80.0, 44.0, "welded to the wall");
    sketch.Label(last->GetWorldPoint(b2Vec2(0.3f, 0.0f)), Side::Below,
                 "with frequencyHz = 20\nthe welds flex a little", kInk, 20.0);
    return sketch.Finished();
}

Figure DrawFrictionJoint()
{
    Sketch sketch(640, 260, b2Vec2(0.0f, 0.1f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f), false); // seen from above
    b2Body* const floor = AddBody(world, b2_staticBody, b2Vec2(0.0f, 0.0f));
    b2Body* const puck = AddBody(world, b2_dynamicBody, Box(0.4f, 0.28f), b2Vec2(-3.0f, -0.6f));
    puck->SetLinearVelocity(b2Vec2(6.0f, 1.4f));
    puck->SetAngularVelocity(2.2f);
    b2FrictionJointDef def;
    def.Initialize(floor, puck, puck->GetWorldCenter());
    def.maxForce = 3.1f * puck->GetMass();
    def.maxTorque = 1.1f * puck->GetInertia();
    world.CreateJoint(&def);
    std::vector<b2Vec2> way{puck->GetPosition()};
    b2Vec2 midway;
    for (int step = 0; step < 150; ++step)
    {
        if (step < 80 && step % 18 == 0)
        {
            sketch.DrawFaint(world, 0.4 + 0.003 * step);
            midway = step == 36 ? puck->GetPosition() : midway;
        }
        Run(world);
        way.push_back(puck->GetPosition());
    }
    sketch.Trail(way);
    sketch.Draw(world);
    const b2Vec2 velocity(6.0f, 1.4f);
    sketch.ArrowAlong(way.front(), velocity, 80.0);
    sketch.Label(way.front(), Side::Below, "velocity", kInk, 30.0);
    sketch.ArrowAlong(midway, -velocity, 60.0, kPush);
    sketch.Label(midway, Side::Below, "maxForce", kPush, 46.0);
    sketch.ArcArrow(midway, 46.0, Degrees(120.0f), Degrees(60.0f), kPush);
    sketch.Label(midway, Side::Above, "maxTorque", kPush, 52.0);
    sketch.Label(puck->GetPosition(), Side::Below, "at rest", kInk, 40.0);
    return sketch.Finished();
}

} // namespace figures
