// SPDX-License-Identifier: MIT
#include "Trial.h"

/// The statements of docs/accuracy.md about the manual's limitations that no case of the benchmark
/// measures. One step: as stated there; with sub-steps: within bounds.
namespace
{

using namespace stability;

STABILITY_SUITE(ManualLimits);

/// Ten boards of 1 m x 0.1 m, welded end to end and to a post, let go level.
TEST_P(ManualLimits, LimitTheSagOfAShelfOfWeldedBoards)
{
    Trial trial(GetParam());
    b2Body* last = trial.Post();
    for (int i = 0; i < 10; ++i)
    {
        b2Body* board = trial.Part(float32(i) + 0.5f, 0.0f, 0.5f, 0.05f);
        trial.Weld(last, board, float32(i), 0.0f);
        last = board;
    }
    double sag = 0.0;
    trial.Run(20.0, [&](double) { sag = Worst(-double(last->GetPosition().y), sag); });
    Judge("shelf of ten welded boards sags", GetParam(), 1000.0 * sag, "mm",
          Bound(GetParam(), 0.01, 8000.0));
}

/// A ball at 10 m/s in a damping of 5 /s, for a second: v = 10 e^-5.
TEST_P(ManualLimits, LimitTheErrorOfDampingForEachStep)
{
    struct Rate
    {
        int hz;
        double oneStep, small; ///< bounds [%]
    };
    for (const Rate& rate : {Rate{30, 50.0, 0.5}, Rate{60, 25.0, 0.1}, Rate{240, 6.0, 0.02}})
    {
        Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
        b2Body* ball = trial.Ball(0.0f, 0.0f);
        ball->SetLinearDamping(5.0f);
        ball->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        for (int i = 0; i < rate.hz; ++i)
        {
            trial.world.Step(1.0f / float32(rate.hz), 8, 3);
        }
        const double truth = 10.0 * std::exp(-5.0);
        Judge("damping of 5 /s at " + std::to_string(rate.hz) + " Hz, speed off", GetParam(),
              100.0 * std::abs(double(ball->GetLinearVelocity().x) / truth - 1.0), "%",
              Bound(GetParam(), rate.small, rate.oneStep));
    }
}

/// Ten boxes of 1 m whose skins touch, at a multiple of the earth's gravity. Measures how far the
/// top one sinks in 20 s. With sub-steps it rises, by the rest of the slop.
TEST_P(ManualLimits, LetAStackBearTenTimesTheGravity)
{
    for (const float32 gravity : {10.0f, 100.0f})
    {
        Trial trial(GetParam(), b2Vec2(0.0f, -gravity));
        trial.world.SetAllowSleeping(false);
        trial.WideGround();
        const std::vector<b2Body*> boxes = Stack(trial, 0.0f, 10);
        const double start = double(boxes.back()->GetPosition().y);
        trial.Run(20.0);
        char name[64];
        std::snprintf(name, sizeof name, "ten boxes at %g m/s^2, the top one sinks by",
                      double(gravity));
        Judge(name, GetParam(), 1000.0 * (start - double(boxes.back()->GetPosition().y)), "mm",
              Bound(GetParam(), 1.0, 5.0));
    }
}

/// The skins of the box and of the edge, less the slop that they overlap by.
TEST_P(ManualLimits, KeepABoxWithinTheSkinsAboveAnEdge)
{
    Trial trial(GetParam());
    b2EdgeShape edge;
    edge.Set(b2Vec2(-5.0f, 0.0f), b2Vec2(5.0f, 0.0f));
    Scene::Add(trial.Body(b2_staticBody, 0.0f, 0.0f), edge, 0.2f, 0.0f);
    const b2Body* box = trial.Box(0.0f, 0.6f);
    trial.Run(5.0);
    const double above = 1000.0 * (double(box->GetPosition().y) - 0.5);
    const double expected = 1000.0 * double(2.0f * b2_polygonRadius - b2_linearSlop);
    Judge("a box rests above an edge by", GetParam(), above, "mm", expected + 0.5);
    Judge("a box rests above an edge, off by", GetParam(), std::abs(above - expected), "mm", 0.5);
}

/// Two rods of 1 m x 0.1 m, hinged end to end, fly into a wall at twenty angles and from ten
/// fractions of a step. Measures the maximum opening of the hinge, and the number of steps with
/// more than a slop.
TEST_P(ManualLimits, KeepAHingeClosedWhenAWallStopsABody)
{
    struct Hits
    {
        float32 speed;
        double two, more; ///< bounds [m]
    };
    for (const Hits& hits : {Hits{20.0f, 0.0005, 0.0005}, Hits{100.0f, 0.15, 0.002}})
    {
        double widest = 0.0;
        int longest = 0;
        for (int i = 0; i < 200; ++i)
        {
            Trial trial(GetParam(), b2Vec2(0.0f, 0.0f));
            trial.Wall(5.0f, 0.5f);
            const b2Rot turn(0.15f * float32(i / 10));
            const b2Vec2 way = turn.GetXAxis();
            const b2Vec2 start(-0.1f * float32(i % 10) * hits.speed * kStep, 0.0f);
            const auto rod = [&](const b2Vec2& place) {
                b2Body* body = trial.Load(place.x, place.y, 0.5f, 0.05f);
                body->SetTransform(place, turn.GetAngle());
                body->SetLinearVelocity(b2Vec2(hits.speed, 0.0f));
                return body;
            };
            b2Body* front = rod(start);
            b2Body* back = rod(start - way);
            const b2Vec2 middle = start - 0.5f * way;
            const b2Joint* hinge = trial.Hinge(front, back, middle.x, middle.y);
            int steps = 0;
            trial.Run(1.0, [&](double) {
                widest = Worst(double(Gap(hinge)), widest);
                steps += Gap(hinge) > b2_linearSlop;
            });
            longest = b2Max(longest, steps);
        }
        const std::string name =
            "two rods into a wall at " + std::to_string(int(hits.speed)) + " m/s, hinge opens";
        const bool areMore = GetParam() >= kRecommended;
        // With one step, at most by the displacement of one step.
        Judge(name, GetParam(), widest, "m",
              Bound(GetParam(), areMore ? hits.more : hits.two, double(hits.speed * kStep)));
        Judge(name + " for", GetParam(), longest, "steps",
              Bound(GetParam(), hits.speed < 50.0f || areMore ? 0.0 : 15.0, 30.0));
    }
}

} // namespace
