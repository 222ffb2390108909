// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

#include <map>

// Scenes of what hangs.
namespace boxreel
{
namespace
{

TEST(JointGridScene, SagsAndWavesLikeACloth)
{
    const auto scene = Make("Joint Grid");
    const std::vector<b2Body*> balls = Movers(*scene);
    ASSERT_EQ(balls.size(), 16u * 16u - 2u);
    // A stiff plate would do neither.
    const b2Body* free = balls[13];  // the end of the top row
    const b2Body* middle = balls[4]; // of the top row, between the nails
    const float32 freeStart = free->GetPosition().y;
    const float32 middleStart = middle->GetPosition().y;
    float32 lowest = freeStart;
    float32 longest = 0.0f;
    Play(*scene, 6.0f, [&] {
        lowest = std::min(lowest, free->GetPosition().y);
        for (b2Joint* joint = scene->World().GetJointList(); joint; joint = joint->GetNext())
        {
            longest = std::max(longest, b2Distance(joint->GetAnchorA(), joint->GetAnchorB()));
        }
    });
    EXPECT_LT(lowest, freeStart - 4.0f) << "the free end falls";
    EXPECT_LT(middle->GetPosition().y, middleStart - 1.0f) << "it sags between the nails";
    EXPECT_LT(longest, 2.0f) << "springs of a metre that are torn out";
    EXPECT_GT(longest, 1.05f);
}

TEST(CantileverScene, BendsSoftWeldsUnderBallsButNotRigidOnes)
{
    const auto scene = Make("Cantilever");
    std::map<std::string, b2Vec2> start;
    for (const char* name : {"rigid tip", "soft tip", "rigid middle", "soft middle"})
    {
        start[name] = Named(*scene, name).GetPosition();
    }
    Play(*scene, 8.0f);
    const auto sag = [&](const char* name) {
        return start[name].y - Named(*scene, name).GetPosition().y;
    };
    EXPECT_LT(b2Abs(sag("rigid tip")), 0.05f);
    EXPECT_GT(sag("soft tip"), 1.5f);
    EXPECT_LT(b2Abs(sag("rigid middle")), 0.05f);
    EXPECT_GT(sag("soft middle"), 0.2f);
    // The balls lie where they were put: two at each tip, two on the middle of each bridge.
    int32 carried = 0;
    for (const b2Body* body : Movers(*scene))
    {
        const bool isBall = body->GetFixtureList()->GetType() == b2Shape::e_circle;
        carried += isBall && body->GetPosition().y > 1.0f ? 1 : 0;
    }
    EXPECT_EQ(carried, 8);
}

TEST(CantileverScene, SwaysOnlySoftHangingBeam)
{
    const auto scene = Make("Cantilever");
    const float32 rigid = Named(*scene, "rigid end").GetPosition().x;
    const float32 soft = Named(*scene, "soft end").GetPosition().x;
    float32 rigidSway = 0.0f;
    float32 softSway = 0.0f;
    Play(*scene, 2.0f, [&] {
        rigidSway = std::max(rigidSway, b2Abs(Named(*scene, "rigid end").GetPosition().x - rigid));
        softSway = std::max(softSway, b2Abs(Named(*scene, "soft end").GetPosition().x - soft));
    });
    EXPECT_LT(rigidSway, 0.05f);
    EXPECT_GT(softSway, 0.4f);
    EXPECT_LT(WidestJointGap(*scene), 0.03f) << "soft against turning, not against coming apart";
}

/// The fastest of all [m/s].
float32 FastestOf(Scene& scene)
{
    float32 fastest = 0.0f;
    for (const b2Body* body : Movers(scene))
    {
        fastest = std::max(fastest, body->GetLinearVelocity().Length());
    }
    return fastest;
}

TEST(MobileScene, SwingsForTwelveSecondsAndStaysTogether)
{
    const auto scene = Make("Mobile");
    ASSERT_EQ(Movers(*scene).size(), 8u + 7u);
    float32 widest = 0.0f;
    Play(*scene, 10.0f, [&] { widest = std::max(widest, WidestHingeGap(*scene)); });
    EXPECT_LT(widest, 0.05f);
    float32 fastest = 0.0f;
    Play(*scene, 2.0f, [&] { fastest = std::max(fastest, FastestOf(*scene)); });
    EXPECT_GT(fastest, 2.0f);
}

TEST(MobileBalancedScene, HangsStill)
{
    const auto scene = Make("MobileBalanced");
    ASSERT_EQ(Movers(*scene).size(), 8u + 7u);
    float32 fastest = 0.0f;
    float32 steepest = 0.0f;
    Play(*scene, 10.0f, [&] {
        fastest = std::max(fastest, FastestOf(*scene));
        for (const b2Body* body : Movers(*scene))
        {
            steepest = std::max(steepest, b2Abs(body->GetAngle()));
        }
    });
    EXPECT_LT(fastest, 0.01f);
    EXPECT_LT(steepest, 0.001f);
}

TEST(BallAndChainScene, DoesNotStretchLightChainUnderHeavyBall)
{
    const auto scene = Make("Ball & Chain");
    const b2Body& ball = Named(*scene, "ball");
    const b2Body* link = Movers(*scene)[0];
    EXPECT_GT(ball.GetMass(), 400.0f * link->GetMass());
    const auto hinges = JointsOf<b2RevoluteJoint>(*scene);
    const b2Vec2 anchor = hinges.front()->GetAnchorA();
    const float32 length = b2Distance(anchor, hinges.back()->GetAnchorA());
    float32 longest = 0.0f;
    float32 lowest = anchor.y;
    float32 farthest = 0.0f;
    Play(*scene, 10.0f, [&] {
        float32 gaps = 0.0f;
        for (const b2RevoluteJoint* hinge : hinges)
        {
            gaps += b2Distance(hinge->GetAnchorA(), hinge->GetAnchorB());
        }
        longest = std::max(longest, gaps);
        lowest = std::min(lowest, ball.GetPosition().y);
        farthest = std::min(farthest, ball.GetPosition().x);
    });
    EXPECT_LT(longest, 0.01f * length);
    EXPECT_LT(lowest, anchor.y - length) << "it hangs on the whole length of the chain";
    EXPECT_LT(farthest, -0.9f * length) << "and swings out as far to the other side";
}

TEST(RopeBendingScene, BendsLessWithStifferJoints)
{
    const auto scene = Make("Rope Bending");
    // The distance that the ends have sunk since the start, as the mean of a few seconds, because
    // springs oscillate for a while.
    const auto sagOf = [&](const char* name, float32 start) {
        return start - Named(*scene, name).GetPosition().y;
    };
    const float32 springs = Named(*scene, "weak spring").GetPosition().y;
    const float32 limits = Named(*scene, "wide limit").GetPosition().y;
    std::map<std::string, float32> sag;
    Play(*scene, 4.0f);
    Play(*scene, 4.0f, [&] {
        for (const char* name : {"weak spring", "middling spring", "strong spring"})
        {
            sag[name] += sagOf(name, springs) / 240.0f;
        }
        for (const char* name : {"wide limit", "middling limit", "narrow limit"})
        {
            sag[name] += sagOf(name, limits) / 240.0f;
        }
    });
    EXPECT_GT(sag["weak spring"], 1.3f * sag["middling spring"]);
    EXPECT_GT(sag["middling spring"], 1.3f * sag["strong spring"]);
    EXPECT_GT(sag["strong spring"], 0.1f);
    EXPECT_GT(sag["wide limit"], 1.2f * sag["middling limit"]);
    EXPECT_GT(sag["middling limit"], 1.2f * sag["narrow limit"]);
    EXPECT_GT(sag["narrow limit"], 0.1f);
}

TEST(RopeBendingScene, KeepsJointsWithinLimits)
{
    const auto scene = Make("Rope Bending");
    float32 beyond = -1.0f;
    Play(*scene, 5.0f, [&] {
        for (const b2RevoluteJoint* hinge : JointsOf<b2RevoluteJoint>(*scene))
        {
            ASSERT_TRUE(hinge->IsLimitEnabled());
            beyond = std::max(beyond, b2Abs(hinge->GetJointAngle()) - hinge->GetUpperLimit());
        }
    });
    EXPECT_LT(beyond, 0.02f);
    EXPECT_GT(beyond, -0.02f) << "some are at it";
}

TEST(WreckingBallScene, KeepsWallStandingUntilBallHits)
{
    const auto scene = Make("Wrecking Ball");
    std::vector<b2Body*> bricks = Movers(*scene);
    bricks.resize(27); // made before the chain
    const auto high = [&] {
        return std::ranges::count_if(bricks, [](b2Body* b) { return b->GetPosition().y > 3.0f; });
    };
    const auto atStart = high();
    EXPECT_EQ(atStart, 15);
    Play(*scene, 1.2f);
    EXPECT_EQ(high(), atStart);
    float32 widest = 0.0f;
    Play(*scene, 6.0f, [&] { widest = std::max(widest, WidestHingeGap(*scene)); });
    EXPECT_EQ(high(), 0);
    EXPECT_LT(widest, 0.1f) << "the chain holds when the ball hits";
    EXPECT_GT(Named(*scene, "ball").GetPosition().y, 1.2f) << "it hangs";
}

} // namespace
} // namespace boxreel
