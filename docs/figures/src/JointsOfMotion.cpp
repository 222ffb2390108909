// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

// More than any of these motions takes [steps].
constexpr int kLongest = 600;

} // namespace

Figure DrawRevoluteJoint()
{
    Sketch sketch(640, 340, b2Vec2(0.3f, 0.25f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    b2Body* const post = AddBody(world, b2_staticBody, Box(0.6f, 0.5f), b2Vec2(-1.5f, -0.2f));
    b2PolygonShape arm;
    arm.SetAsBox(1.25f, 0.16f, b2Vec2(1.1f, 0.0f), 0.0f);
    const b2Vec2 anchor(-1.3f, 0.0f);
    b2Body* const beam = AddBody(world, b2_dynamicBody, arm, anchor);
    b2RevoluteJointDef def;
    def.Initialize(post, beam, anchor);
    def.enableLimit = true;
    def.lowerAngle = Degrees(-30.0f);
    def.upperAngle = Degrees(60.0f);
    def.enableMotor = true;
    def.maxMotorTorque = 200.0f;
    def.motorSpeed = -1.0f;
    auto* const joint = static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
    Run(world, 60);
    sketch.DrawFaint(world, 0.45); // at the lower limit
    joint->SetMotorSpeed(1.0f);
    Run(world, 180);
    sketch.DrawFaint(world, 0.45); // at the upper one
    joint->SetMotorSpeed(-1.0f);
    for (int step = 0; step < kLongest && joint->GetJointAngle() > Degrees(30.2f); ++step)
    {
        Run(world);
    }
    sketch.Draw(world);

    sketch.Dashes(anchor, anchor + b2Vec2(3.3f, 0.0f));
    sketch.Label(anchor + b2Vec2(3.3f, 0.0f), Side::Right, "0", kInk, 5.0);
    for (const float32 limit : {def.lowerAngle, def.upperAngle})
    {
        const b2Vec2 end = anchor + 2.55f * b2Rot(limit).GetXAxis();
        sketch.Dashes(anchor, end);
        sketch.Label(end, Side::Right, limit < 0.0f ? "lowerAngle" : "upperAngle", kInk, 6.0);
    }
    sketch.ArcArrow(anchor, 224.0, 0.0f, joint->GetJointAngle(), kHelp);
    sketch.Label(anchor + 2.85f * b2Rot(Degrees(14.0f)).GetXAxis(), Side::Right, "joint angle",
                 kInk, 4.0);
    sketch.Ring(anchor, 6.0);
    sketch.Dot(anchor, kInk, 4.0);
    sketch.Note(anchor, -40.0, 90.0, "anchor");
    sketch.Label(post->GetPosition(), Side::Below, "bodyA", kInk, 8.0);
    const b2Rot turn(joint->GetJointAngle());
    sketch.Label(anchor + 1.7f * turn.GetXAxis(), Side::Below, "bodyB", kInk, 26.0);
    return sketch.Finished();
}

Figure DrawPrismaticJoint()
{
    Sketch sketch(640, 320, b2Vec2(0.2f, 0.1f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const float32 slope = Degrees(20.0f);
    const b2Vec2 axis = b2Rot(slope).GetXAxis();
    const b2Vec2 across = b2Rot(slope).GetYAxis();
    const b2Vec2 anchor(-0.8f, -0.2f);
    b2Body* const base = AddBody(world, b2_staticBody, Box(2.9f, 0.14f),
                                 b2Vec2(0.0f, 0.0f) + anchor + 0.9f * axis - 0.62f * across, slope);
    b2Body* const cart = AddBody(world, b2_dynamicBody, Box(0.5f, 0.3f), anchor, slope);
    b2PrismaticJointDef def;
    def.Initialize(base, cart, anchor, axis);
    def.enableLimit = true;
    def.lowerTranslation = -1.2f;
    def.upperTranslation = 3.0f;
    def.enableMotor = true;
    def.maxMotorForce = 100.0f;
    def.motorSpeed = 1.0f;
    auto* const joint = static_cast<b2PrismaticJoint*>(world.CreateJoint(&def));
    sketch.DrawFaint(world, 0.45);
    for (int step = 0; step < kLongest && joint->GetJointTranslation() < 1.8f; ++step)
    {
        Run(world);
    }
    sketch.Draw(world);

    const b2Vec2 lower = anchor + def.lowerTranslation * axis;
    const b2Vec2 upper = anchor + def.upperTranslation * axis;
    sketch.Line(lower, upper, kHelp);
    for (const b2Vec2& end : {lower, upper})
    {
        sketch.Line(end - 0.14f * across, end + 0.14f * across, kHelp);
    }
    sketch.Label(lower, Side::AboveLeft, "lowerTranslation", kInk, 6.0);
    sketch.Label(upper, Side::Above, "upperTranslation", kInk, 14.0);
    sketch.Measure(anchor, joint->GetAnchorB(), "translation", 52.0);
    sketch.Dot(anchor);
    sketch.Dot(joint->GetAnchorB());
    const b2Vec2 tail = anchor + 0.4f * axis - 1.05f * across;
    sketch.Arrow(tail, tail + 1.2f * axis);
    sketch.Label(tail + 0.6f * axis, Side::BelowRight, "axis", kInk, 8.0);
    sketch.Label(base->GetWorldPoint(b2Vec2(2.0f, -0.14f)), Side::BelowRight, "bodyA", kInk, 8.0);
    sketch.Label(cart->GetWorldPoint(b2Vec2(0.5f, -0.15f)), Side::Right, "bodyB", kInk, 6.0);
    return sketch.Finished();
}

Figure DrawMotorJoint()
{
    Sketch sketch(640, 320, b2Vec2(0.2f, 0.4f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    b2Body* const base = AddBody(world, b2_staticBody, Box(0.8f, 0.3f), b2Vec2(-2.2f, -0.9f));
    b2Body* const held = AddBody(world, b2_dynamicBody, Box(0.6f, 0.3f), b2Vec2(-0.9f, 0.3f));
    b2MotorJointDef def;
    def.Initialize(base, held);
    def.linearOffset.Set(4.0f, 2.0f);
    def.angularOffset = Degrees(30.0f);
    def.maxForce = 100.0f;
    def.maxTorque = 40.0f;
    def.correctionFactor = 0.05f;
    world.CreateJoint(&def);
    for (const int steps : {0, 12, 16})
    {
        Run(world, steps);
        sketch.DrawFaint(world, 0.4 + 0.01 * steps);
    }
    Run(world, 240);
    sketch.Draw(world);

    const b2Vec2 a = base->GetPosition();
    const b2Vec2 goal = base->GetWorldPoint(def.linearOffset);
    sketch.Arrow(a, goal, kHelp);
    sketch.Dot(a);
    sketch.Dot(goal);
    sketch.Label(a + 0.42f * (goal - a), Side::BelowRight, "linearOffset", kInk, 8.0);
    sketch.Label(a, Side::Below, "bodyA", kInk, 30.0);
    sketch.Dashes(goal, goal + b2Vec2(1.4f, 0.0f));
    sketch.ArcArrow(goal, 80.0, 0.0f, def.angularOffset);
    sketch.Label(goal + 1.1f * b2Rot(Degrees(13.0f)).GetXAxis(), Side::Right, "angularOffset", kInk,
                 4.0);
    sketch.Label(goal, Side::Above, "bodyB", kInk, 40.0);
    return sketch.Finished();
}

} // namespace figures
