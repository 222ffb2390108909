// SPDX-License-Identifier: MIT
#include "Stage.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

namespace
{

// [heavy]
/// By how much the top of ten boxes has sunk after 10 s, the top one so many times as heavy [mm].
float32 HeavyTop(int32 subSteps, float32 ratio)
{
    manual::Stage stage;
    stage.world.SetSubStepCount(subSteps);
    stage.Ground();
    b2Body* top = nullptr;
    for (int i = 0; i < 10; ++i)
    {
        top = stage.Box(0.0f, 0.515f + 1.015f * float32(i)); // 15 mm apart, as they rest
    }
    top->GetFixtureList()->SetDensity(ratio);
    top->ResetMassData();
    const float32 before = top->GetPosition().y;
    stage.Run(10.0f);
    return 1000.0f * (before - top->GetPosition().y);
}
// [/heavy]

// [chain]
/// How far the hinges of a chain of twenty links are open under a ball so many times as heavy as
/// one [mm].
float32 HeavyBall(int32 subSteps, float32 ratio)
{
    manual::Stage stage;
    stage.world.SetSubStepCount(subSteps);
    b2Body* last = stage.Body(b2_staticBody, 0.0f, 0.0f);
    float32 widest = 0.0f;
    for (int i = 0; i < 21; ++i)
    {
        b2Body* link = i < 20 ? stage.Box(0.0f, -0.5f - float32(i), 0.05f, 0.5f)
                              : stage.Ball(0.0f, -21.0f, 1.0f);
        b2RevoluteJointDef hinge;
        hinge.Initialize(last, link, b2Vec2(0.0f, -float32(i)));
        stage.world.CreateJoint(&hinge);
        last = link;
    }
    last->GetFixtureList()->SetDensity(ratio * 0.1f / b2_pi); // a link has 0.1 kg
    last->ResetMassData();
    stage.Run(10.0f);
    for (const b2Joint* j = stage.world.GetJointList(); j; j = j->GetNext())
    {
        widest = b2Max(widest, b2Distance(j->GetAnchorA(), j->GetAnchorB()));
    }
    return 1000.0f * widest;
}
// [/chain]

// [throw]
/// How far a ball is from its parabola after 2 s at (10, 20) m/s [mm].
float32 Thrown(int32 subSteps)
{
    manual::Stage stage;
    stage.world.SetSubStepCount(subSteps);
    b2Body* ball = stage.Ball(0.0f, 0.0f);
    ball->SetLinearVelocity(b2Vec2(10.0f, 20.0f));
    stage.Run(2.0f);
    return 1000.0f * b2Distance(ball->GetPosition(), b2Vec2(20.0f, 20.0f));
}
// [/throw]

std::string Shown(float32 value)
{
    char text[32];
    std::snprintf(text, sizeof text, std::abs(value) >= 99.5f ? "%8.0f" : "%8.2f", double(value));
    return text;
}

std::string Line(const char* name, float32 (*measure)(int32, float32), float32 ratio)
{
    std::string line = name;
    for (const int32 subSteps : {1, 2, 4})
    {
        line += Shown(measure(subSteps, ratio));
    }
    return line + "\n";
}

TEST(LimitationsListing, MeasuresWhatThePageShows)
{
    std::string table;
    table += "sub-steps                       1       2       4\n";
    table += Line("heavy top, 10:1          ", HeavyTop, 10.0f);
    table += Line("heavy top, 100:1         ", HeavyTop, 100.0f);
    table += Line("heavy top, 1000:1        ", HeavyTop, 1000.0f);
    table += Line("heavy ball, 10:1         ", HeavyBall, 10.0f);
    table += Line("heavy ball, 100:1        ", HeavyBall, 100.0f);
    table += Line("heavy ball, 1000:1       ", HeavyBall, 1000.0f);
    table += Line(
        "thrown                   ", [](int32 n, float32) { return Thrown(n); }, 0.0f);
    const std::string shown =
        manual::SectionText("12-limitations.md", "## Three of them, measured");
    EXPECT_THAT(shown, testing::HasSubstr("```text\n" + table + "```"));
}

} // namespace
