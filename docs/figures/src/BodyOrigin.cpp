// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{

Figure DrawBodyOrigin()
{
    Sketch sketch(640, 320, b2Vec2(2.4f, 1.65f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f));
    b2Body* const body = AddBody(world, b2_dynamicBody, b2Vec2(2.2f, 0.9f), Degrees(20.0f));
    // An L; the body's origin lies where its arms meet.
    b2PolygonShape part;
    part.SetAsBox(1.3f, 0.3f, b2Vec2(1.0f, 0.0f), 0.0f);
    body->CreateFixture(&part, 1.0f);
    part.SetAsBox(0.3f, 0.75f, b2Vec2(0.0f, 1.05f), 0.0f);
    body->CreateFixture(&part, 1.0f);
    Run(world);
    sketch.Draw(world);

    const b2Vec2 origin = body->GetPosition();
    const b2Vec2 center = body->GetWorldCenter();
    const b2Vec2 zero(0.0f, 0.0f);
    for (const b2Vec2& axis : {b2Vec2(1.0f, 0.0f), b2Vec2(0.0f, 1.0f)})
    {
        sketch.ArrowAlong(zero, axis, 50.0, kQuiet);
    }
    sketch.Label(sketch.Shifted(zero, 25.0, 0.0), Side::Below, "world", kQuiet, 6.0);
    sketch.Arrow(zero, origin, kHelp);
    sketch.Label(0.55f * origin, Side::BelowRight, "GetPosition()", kInk, 6.0);
    const b2Vec2 way = center - origin;
    const float32 sign = float32(8.0 / sketch.Camera().pixelsPerMeter); // stops short of it
    sketch.Arrow(origin, center - (sign / way.Length()) * way, kHelp);
    sketch.List().layer = DrawLayer::CentersOfMass;
    sketch.List().AddTransform(From(origin), From(body->GetWorldVector(b2Vec2(1.0f, 0.0f))), 0.6f);
    sketch.DrawCenterMarks(world);
    sketch.Dot(origin);
    sketch.Note(origin, 70.0, -40.0, "the body's origin");
    sketch.Note(origin + 0.55f * way, -110.0, 76.0, "GetLocalCenter(),\nin the body's axes");
    sketch.Note(center, 90.0, 80.0, "centre of mass:\nGetWorldCenter()");
    return sketch.Finished();
}

} // namespace figures
