// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{

Figure DrawDistanceJoint()
{
    Sketch sketch(640, 320, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    const b2PolygonShape block = Box(0.45f, 0.2f);
    const b2PolygonShape load = Box(0.35f, 0.3f);
    b2Body* const roof = AddBody(world, b2_staticBody, block, b2Vec2(-2.0f, 1.55f));
    b2Body* const bob = AddBody(world, b2_dynamicBody, load, b2Vec2(-3.2f, -0.6f));
    b2DistanceJointDef rigid;
    rigid.Initialize(roof, bob, b2Vec2(-2.0f, 1.35f), b2Vec2(-3.2f, -0.3f));
    const auto* const rod = static_cast<b2DistanceJoint*>(world.CreateJoint(&rigid));
    b2Body* const other = AddBody(world, b2_staticBody, block, b2Vec2(2.0f, 1.55f));
    b2Body* const soft = AddBody(world, b2_dynamicBody, load, b2Vec2(2.0f, 0.15f));
    b2DistanceJointDef spring;
    spring.Initialize(other, soft, b2Vec2(2.0f, 1.35f), b2Vec2(2.0f, 0.45f));
    spring.frequencyHz = 0.7f;
    spring.dampingRatio = 0.1f;
    const b2Joint* const coil = world.CreateJoint(&spring);
    sketch.DrawFaint(world, 0.4);
    Run(world, 66);
    sketch.Draw(world);
    sketch.DrawGlyphs(world);

    sketch.Measure(rod->GetAnchorA(), rod->GetAnchorB(), "length", -40.0);
    sketch.Label(rod->GetAnchorA(), Side::BelowLeft, "anchorA", kInk, 12.0);
    sketch.Label(rod->GetAnchorB(), Side::Left, "anchorB", kInk, 12.0);
    sketch.Label(0.5f * (coil->GetAnchorA() + coil->GetAnchorB()) + b2Vec2(0.0f, 0.3f), Side::Right,
                 "frequencyHz,\ndampingRatio", kInk, 18.0);
    sketch.Caption(160.0, 312.0, Side::Above, "rigid");
    sketch.Caption(480.0, 312.0, Side::Above, "soft");
    return sketch.Finished();
}

Figure DrawRopeJoint()
{
    Sketch sketch(640, 320, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    b2Body* const beam = AddBody(world, b2_staticBody, Box(0.45f, 0.15f), b2Vec2(0.0f, 1.5f));
    b2Body* const ball = AddBody(world, b2_dynamicBody, Disc(0.28f), b2Vec2(-1.5f, 1.2f));
    b2RopeJointDef def;
    def.bodyA = beam;
    def.bodyB = ball;
    def.localAnchorA.Set(0.0f, -0.15f);
    def.localAnchorB.Set(0.0f, 0.0f);
    def.maxLength = 2.5f;
    const b2Joint* const rope = world.CreateJoint(&def);
    const b2Vec2 anchor = rope->GetAnchorA();
    std::vector<b2Vec2> way;
    for (int step = 0; step < 64; ++step)
    {
        if (step % 16 == 0 && step != 16)
        {
            sketch.DrawFaint(world, 0.4 + 0.004 * step);
        }
        way.push_back(ball->GetPosition());
        Run(world);
    }
    way.push_back(ball->GetPosition());
    sketch.Trail(way);
    sketch.Draw(world);
    // The points where the rope is taut.
    constexpr int kStretches = 48;
    const auto at = [&](int i) {
        const b2Rot turn(b2_pi * float32(i) / kStretches);
        return anchor - 2.5f * turn.GetXAxis();
    };
    for (int i = 0; i < kStretches; i += 2)
    {
        sketch.Line(at(i), at(i + 1), kQuiet);
    }
    sketch.Line(anchor, ball->GetPosition(), kHelp);
    sketch.Dot(anchor);
    sketch.Dot(ball->GetPosition());
    sketch.Label(anchor, Side::BelowLeft, "anchorA", kInk, 12.0);
    sketch.Label(ball->GetPosition(), Side::Right, "anchorB", kInk, 30.0);
    sketch.Label(0.5f * (anchor + ball->GetPosition()), Side::Right, "maxLength", kInk, 10.0);
    return sketch.Finished();
}

Figure DrawMouseJoint()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.0f), 80.0);
    b2World world(b2Vec2(0.0f, -10.0f), false);
    b2Body* const ground = AddGround(world, Edge(b2Vec2(-3.6f, -1.4f), b2Vec2(3.6f, -1.4f)));
    b2Body* const box = AddBody(world, b2_dynamicBody, Box(0.55f, 0.4f), b2Vec2(-2.4f, -0.98f));
    b2MouseJointDef def;
    def.bodyA = ground;
    def.bodyB = box;
    def.target = box->GetWorldPoint(b2Vec2(0.45f, 0.3f));
    def.maxForce = 60.0f * box->GetMass();
    def.frequencyHz = 1.2f;
    auto* const joint = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
    joint->SetTarget(b2Vec2(2.0f, 0.9f));
    std::vector<b2Vec2> way{joint->GetAnchorB()};
    for (int step = 0; step < 22; ++step)
    {
        if (step % 11 == 0)
        {
            sketch.DrawFaint(world, 0.4 + 0.01 * step);
        }
        Run(world);
        way.push_back(joint->GetAnchorB());
    }
    sketch.Trail(way);
    sketch.Draw(world);
    sketch.DrawGlyphs(world);
    sketch.Label(joint->GetTarget(), Side::Above, "target", kInk, 14.0);
    sketch.Note(joint->GetAnchorB(), -60.0, 50.0, "the point that is held");
    return sketch.Finished();
}

} // namespace figures
