// SPDX-License-Identifier: MIT
#include "Drawings.h"
#include "Setup.h"
#include "Sketch.h"

using namespace boxreel;

namespace figures
{
namespace
{

/// A ball so fast that it goes a metre a step flies at a thin wall: its places, step by step.
Figure DrawFastBall(bool continuous)
{
    constexpr int kSteps = 6;
    Sketch sketch(640, 240, b2Vec2(0.1f, 0.0f), 100.0);
    b2World world(b2Vec2(0.0f, 0.0f), false);
    world.SetContinuousPhysics(continuous);
    AddBody(world, b2_staticBody, Box(0.05f, 0.85f), b2Vec2(0.0f, 0.0f));
    b2Body* const ball = AddBody(world, b2_dynamicBody, Disc(0.15f), b2Vec2(-2.6f, 0.0f));
    ball->SetLinearVelocity(b2Vec2(60.0f, 0.0f));
    std::vector<b2Vec2> places{ball->GetPosition()};
    for (int step = 1; step < kSteps; ++step)
    {
        sketch.DrawFaint(world, step <= 3 || !continuous ? 0.45 : 0.0);
        Run(world);
        places.push_back(ball->GetPosition());
    }
    sketch.Draw(world);

    const b2Vec2 below(0.0f, -0.35f);
    const auto name = [](int step) { return (step == 0 ? "step " : "") + std::to_string(step); };
    if (!continuous)
    {
        sketch.Measure(places[0], places[1], "1 m a step", 42.0);
        for (int step = 0; step < kSteps; ++step)
        {
            sketch.Label(places[step] + below, Side::Below, name(step), kInk, 0.0);
        }
        sketch.Line(places[2] + b2Vec2(0.2f, 0.0f), places[3] - b2Vec2(0.2f, 0.0f), kBad);
        sketch.Caption(310.0, 222.0, Side::Above, "never seen to touch", kBad);
        return sketch.Finished();
    }
    for (int step = 0; step < 4; ++step)
    {
        sketch.Label(places[step] + below, Side::Below, name(step), kInk, 0.0);
    }
    const b2Vec2 without = places[2] + b2Vec2(1.0f, 0.0f);
    sketch.Ring(without, 15.0, kQuiet);
    sketch.Label(without, Side::Right, "where step 3 would have ended", kQuiet, 22.0);
    sketch.Note(places[3] + b2Vec2(0.0f, 0.15f), -60.0, 50.0, "stopped at the time of impact",
                kGood);
    return sketch.Finished();
}

/// The input of b2TimeOfImpact, drawn as a world with A at rest and B at three moments.
class SweepSketch
{
public:
    SweepSketch(Sketch& sketch, const b2Shape& a, const b2Shape& b, const b2Sweep& sweepB)
        : m_sketch(sketch), m_world(b2Vec2(0.0f, 0.0f)), m_sweep(sweepB)
    {
        AddGround(m_world, a);
        m_body = AddBody(m_world, b2_dynamicBody, b, sweepB.c0);
        b2TOIInput input;
        input.proxyA.Set(&a, 0);
        input.proxyB.Set(&b, 0);
        input.sweepB = sweepB;
        b2TimeOfImpact(&m_output, &input);
    }

    float32 Time() const { return m_output.t; }
    b2Vec2 PlaceAt(float32 time, const b2Vec2& local = b2Vec2(0.0f, 0.0f)) const
    {
        b2Transform place;
        m_sweep.GetTransform(&place, time);
        return b2Mul(place, local);
    }
    void DrawFaintAt(float32 time, double opacity)
    {
        MoveTo(time);
        m_sketch.DrawFaint(m_world, opacity);
    }
    void DrawAtImpact()
    {
        MoveTo(m_output.t);
        m_sketch.Draw(m_world);
    }

private:
    void MoveTo(float32 time)
    {
        m_body->SetTransform(PlaceAt(time), (1.0f - time) * m_sweep.a0 + time * m_sweep.a);
    }

    Sketch& m_sketch;
    b2World m_world;
    b2Sweep m_sweep;
    b2Body* m_body = nullptr;
    b2TOIOutput m_output;
};

} // namespace

Figure DrawTunnelling()
{
    return DrawFastBall(false);
}

Figure DrawContinuousCollision()
{
    return DrawFastBall(true);
}

Figure DrawImpactWithinStep()
{
    Sketch sketch(640, 330, b2Vec2(0.05f, 0.22f), 190.0);
    const b2CircleShape disc = Disc(0.12f);
    const b2PolygonShape floor = Box(1.6f, 0.06f);
    const b2Vec2 start(-1.0f, 0.78f);
    const b2Vec2 velocity(100.0f, -64.0f); // below b2_maxTranslation a step

    // The query of the step: the sweep, and the time at which the two first touch.
    b2TOIInput input;
    input.proxyA.Set(&floor, 0);
    input.proxyB.Set(&disc, 0);
    input.sweepB.c0 = start;
    input.sweepB.c = start + (1.0f / 60.0f) * velocity;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    const b2Vec2 end = input.sweepB.c;
    const b2Vec2 impact = (1.0f - output.t) * start + output.t * end;

    b2World world(b2Vec2(0.0f, 0.0f), false);
    AddGround(world, floor)->GetFixtureList()->SetFriction(0.0f);
    b2Body* const ball = AddBody(world, b2_dynamicBody, disc, start);
    ball->GetFixtureList()->SetRestitution(0.8f);
    ball->SetLinearVelocity(velocity);
    sketch.DrawFaint(world, 0.45);
    Run(world);
    sketch.Draw(world);

    const double radius = 0.12 * sketch.Camera().pixelsPerMeter;
    sketch.Dashes(start, end);
    sketch.Ring(end, radius, kQuiet);
    sketch.Ring(impact, radius, kGood);
    sketch.Arrow(start, impact, kHelp);
    sketch.Arrow(impact, ball->GetPosition(), kGood);
    sketch.Dot(start);
    sketch.Dot(impact, kGood);
    sketch.Dot(end, kQuiet);
    sketch.Label(start, Side::Right, "start of the step: c0, t = 0", kInk, 30.0);
    sketch.Label(0.5f * (start + impact), Side::BelowLeft, "sweep", kHelp, 10.0);
    sketch.Label(b2Vec2(impact.x, -0.06f), Side::Below, "time of impact:\nt = " + Text(output.t, 2),
                 kGood, 6.0);
    sketch.Label(end, Side::Right, "end of the sweep:\nc, t = 1", kQuiet, 30.0);
    sketch.Label(ball->GetPosition(), Side::Above, "end of the step", kInk, 28.0);
    sketch.Label(0.5f * (impact + ball->GetPosition()), Side::BelowRight,
                 "sub-step: the last\n" + Text(100.0 * (1.0 - output.t), 0) + " % of the step",
                 kGood, 8.0);
    return sketch.Finished();
}

Figure DrawTimeOfImpact()
{
    Sketch sketch(640, 300, b2Vec2(0.0f, 0.05f), 80.0);
    b2Sweep sweep;
    sweep.c0.Set(-2.9f, 0.9f);
    sweep.c.Set(2.8f, -0.8f);
    sweep.a0 = Degrees(20.0f);
    sweep.a = Degrees(-45.0f);
    const b2PolygonShape wall = Box(0.25f, 1.2f);
    const b2PolygonShape box = Box(0.6f, 0.35f);
    SweepSketch swept(sketch, wall, box, sweep);
    sketch.Dashes(sweep.c0, sweep.c);
    swept.DrawFaintAt(0.0f, 0.5);
    swept.DrawFaintAt(1.0f, 0.5);
    swept.DrawAtImpact();
    sketch.Label(swept.PlaceAt(0.0f), Side::Below, "t = 0", kInk, 44.0);
    sketch.Label(swept.PlaceAt(swept.Time()), Side::Below, "t = " + Text(swept.Time(), 2), kGood,
                 50.0);
    sketch.Label(swept.PlaceAt(1.0f), Side::Above, "t = 1", kInk, 60.0);
    return sketch.Finished();
}

Figure DrawTimeOfImpactTurning()
{
    Sketch sketch(640, 320, b2Vec2(0.9f, 0.0f), 80.0);
    b2Sweep sweep;
    sweep.c0.Set(1.3f, 0.0f);
    sweep.c = sweep.c0;
    sweep.a0 = Degrees(40.0f);
    sweep.a = Degrees(140.0f);
    const b2PolygonShape post = Box(0.22f, 0.22f);
    const b2PolygonShape rod = Box(0.09f, 1.6f);
    SweepSketch swept(sketch, post, rod, sweep);
    swept.DrawFaintAt(0.0f, 0.5);
    swept.DrawFaintAt(1.0f, 0.5);
    swept.DrawAtImpact();
    sketch.Dot(sweep.c0);
    const b2Vec2 tip(0.0f, 1.6f);
    sketch.Label(swept.PlaceAt(0.0f, tip), Side::Above, "t = 0", kInk, 10.0);
    sketch.Label(swept.PlaceAt(swept.Time(), tip), Side::Left, "t = " + Text(swept.Time(), 2),
                 kGood, 8.0);
    sketch.Label(swept.PlaceAt(1.0f, tip), Side::Below, "t = 1", kInk, 10.0);
    sketch.ArcArrow(sweep.c0, 90.0, Degrees(-42.0f), Degrees(35.0f));
    return sketch.Finished();
}

Figure DrawMissedImpact()
{
    Sketch sketch(640, 340, b2Vec2(0.9f, -0.1f), 80.0);
    b2World world(b2Vec2(0.0f, 0.0f), false);
    world.SetContinuousPhysics(false);
    const b2Vec2 middle(1.3f, 0.0f);
    AddGround(world, Box(0.22f, 0.22f));
    b2Body* const rod = AddBody(world, b2_dynamicBody, Box(0.09f, 1.6f), middle, Degrees(50.0f));
    rod->SetAngularVelocity(Degrees(80.0f) * 60.0f);
    sketch.DrawFaint(world, 0.5);
    const b2Vec2 tip(0.0f, 1.6f);
    sketch.Label(rod->GetWorldPoint(tip), Side::Above, "step 0", kInk, 10.0);
    Run(world);
    sketch.Draw(world);
    sketch.Label(rod->GetWorldPoint(tip), Side::Below, "step 1", kInk, 10.0);
    sketch.Dot(middle);
    sketch.ArcArrow(middle, 90.0, Degrees(-38.0f), Degrees(35.0f), kBad);
    sketch.Caption(24.0, 170.0, Side::Right, "never seen to touch", kBad);
    return sketch.Finished();
}

} // namespace figures
