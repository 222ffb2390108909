// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{

Figure DrawPulleyJoint()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.25f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2Vec2 groundA(-1.2f, 1.5f);
    const b2Vec2 groundB(1.2f, 1.5f);
    b2Body* const light = AddBody(world, b2_dynamicBody, Box(0.35f, 0.3f), b2Vec2(-1.2f, -1.0f));
    b2Body* const heavy = AddBody(world, b2_dynamicBody, Box(0.45f, 0.4f), b2Vec2(1.2f, 0.2f));
    b2PulleyJointDef def;
    def.Initialize(light, heavy, groundA, groundB, b2Vec2(-1.2f, -0.7f), b2Vec2(1.2f, 0.6f), 1.0f);
    const auto* const joint = static_cast<b2PulleyJoint*>(world.CreateJoint(&def));
    Run(world, 42);
    sketch.Draw(world);
    sketch.DrawGlyphs(world);

    const b2Vec2 endA = joint->GetAnchorA();
    const b2Vec2 endB = joint->GetAnchorB();
    sketch.Measure(endA, groundA, "lengthA", 64.0);
    sketch.Measure(endB, groundB, "lengthB", -64.0);
    sketch.Label(groundA, Side::AboveLeft, "groundAnchorA", kInk, 12.0);
    sketch.Label(groundB, Side::AboveRight, "groundAnchorB", kInk, 12.0);
    sketch.Label(endA, Side::AboveRight, "anchorA", kInk, 10.0);
    sketch.Label(endB, Side::AboveLeft, "anchorB", kInk, 10.0);
    sketch.ArrowAlong(light->GetPosition() + b2Vec2(0.55f, -0.2f), b2Vec2(0.0f, 1.0f), 36.0);
    sketch.ArrowAlong(heavy->GetPosition() + b2Vec2(-0.65f, 0.2f), b2Vec2(0.0f, -1.0f), 36.0);
    sketch.Caption(320.0, 288.0, Side::Above, "lengthA + ratio · lengthB stays the same");
    return sketch.Finished();
}

Figure DrawGearJoint()
{
    Sketch sketch(640, 270, b2Vec2(-0.1f, 0.05f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f), false);
    b2Body* const ground = AddBody(world, b2_staticBody, b2Vec2(0.0f, 0.0f));
    b2Body* const wheel = AddBody(world, b2_dynamicBody, Disc(0.75f), b2Vec2(-0.3f, 0.55f));
    b2Body* const rack = AddBody(world, b2_dynamicBody, Box(1.1f, 0.16f), b2Vec2(-1.3f, -0.38f));
    for (b2Body* const body : {wheel, rack}) // which only the gear connects
    {
        b2Filter none;
        none.maskBits = 0;
        body->GetFixtureList()->SetFilterData(none);
    }
    b2RevoluteJointDef turn;
    turn.Initialize(ground, wheel, wheel->GetPosition());
    turn.enableMotor = true;
    turn.motorSpeed = 1.0f;
    turn.maxMotorTorque = 50.0f;
    b2PrismaticJointDef slide;
    slide.Initialize(ground, rack, rack->GetPosition(), b2Vec2(1.0f, 0.0f));
    b2GearJointDef gear;
    gear.bodyA = wheel;
    gear.bodyB = rack;
    gear.joint1 = world.CreateJoint(&turn);
    gear.joint2 = world.CreateJoint(&slide);
    gear.ratio = -1.0f / 0.75f; // the rim goes as far as the rack
    world.CreateJoint(&gear);
    sketch.DrawFaint(world, 0.4);
    Run(world, 120);
    sketch.Draw(world);

    const b2Vec2 hub = wheel->GetPosition();
    sketch.Ring(hub, 5.0);
    sketch.ArcArrow(hub, 72.0, Degrees(50.0f), Degrees(130.0f));
    sketch.Label(hub, Side::Left, "bodyA, a wheel\non joint1: revolute", kInk, 74.0);
    const b2Vec2 rim = hub + 0.75f * b2Rot(Degrees(-35.0f)).GetXAxis();
    sketch.Arrow(hub, rim);
    sketch.Note(hub + 0.62f * (rim - hub), 92.0, 10.0, "radius 0.75 m");
    sketch.ArrowAlong(rack->GetPosition() + b2Vec2(-0.3f, -0.32f), b2Vec2(1.0f, 0.0f), 60.0);
    sketch.Label(rack->GetPosition() + b2Vec2(1.1f, 0.0f), Side::Right,
                 "bodyB, a rack\non joint2: prismatic", kInk, 10.0);
    sketch.Caption(320.0, 258.0, Side::Above,
                   "coordinate1 + ratio · coordinate2 stays the same; here ratio = -1 / radius");
    return sketch.Finished();
}

} // namespace figures
