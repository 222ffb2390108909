// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{

Figure DrawBodyOrigin()
{
    Sketch sketch(640, 340, b2Vec2(2.8f, 1.6f), 84.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body* const body = AddBody(world, b2_dynamicBody, b2Vec2(2.3f, 0.7f), Degrees(8.0f));
    // An L; the body's origin lies at its outer corner.
    b2PolygonShape part;
    part.SetAsBox(1.55f, 0.45f, b2Vec2(1.55f, 0.45f), 0.0f);
    body->CreateFixture(&part, 1.0f);
    part.SetAsBox(0.45f, 0.65f, b2Vec2(0.45f, 1.55f), 0.0f);
    body->CreateFixture(&part, 1.0f);
    Run(world);
    sketch.Draw(world);

    const b2Vec2 origin = body->GetPosition();
    const b2Vec2 center = body->GetWorldCenter();
    const b2Vec2 zero(0.0f, 0.0f);
    for (const b2Vec2& axis : {b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, 1.0f)})
    {
        sketch.ArrowAlong(zero, axis, 56.0, kQuiet);
        sketch.ArrowAlong(origin, body->GetWorldVector(axis), 56.0, kQuiet);
    }
    sketch.Label(zero, Side::Below, "the world's origin", kQuiet, 6.0);
    sketch.Arrow(zero, origin, kHelp);
    sketch.Label(0.5f * origin, Side::AboveLeft, "GetPosition()", kHelp, 6.0);
    const b2Vec2 way = center - origin;
    const float32 sign = float32(8.0 / sketch.Camera().pixelsPerMeter); // stops short of it
    sketch.Arrow(origin, center - (sign / way.Length()) * way, kPush);
    sketch.Label(origin + 0.62f * way, Side::Right, "GetLocalCenter()", kPush, 10.0);
    sketch.DrawCenterMarks(world);
    sketch.Dot(origin);
    sketch.Label(origin, Side::BelowRight, "the body's origin", kInk, 10.0);
    sketch.Note(center, 84.0, 92.0, "centre of mass:\nGetWorldCenter()");
    return sketch.Finished();
}

} // namespace figures
