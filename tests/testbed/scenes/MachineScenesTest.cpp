// SPDX-License-Identifier: MIT
#include "ScenePlay.h"

// Scenes of what drives and turns.
namespace boxreel
{
namespace
{

TEST(CarScene, DrivesOverSeesawAndBridgeIntoTheBoxes)
{
    const auto scene = Make("Car");
    const auto wheels = JointsOf<b2WheelJoint>(*scene);
    ASSERT_EQ(wheels.size(), 2u);
    const b2Body* chassis = wheels[0]->GetBodyA();
    scene->KeyDown('d');
    float32 farthest = -100.0f;
    Play(*scene, 10.0f, [&] { farthest = std::max(farthest, chassis->GetPosition().x); });
    EXPECT_GT(farthest, 33.0f);
    EXPECT_GT(chassis->GetPosition().y, 0.5f) << "it fell off the bridge";
}

TEST(CarScene, RollsDownTheSlopeUnlessItBrakes)
{
    const auto rolling = Make("Car");
    const auto braked = Make("Car");
    braked->KeyDown('s');
    Play(*rolling, 5.0f);
    Play(*braked, 5.0f);
    EXPECT_GT(JointsOf<b2WheelJoint>(*rolling)[0]->GetBodyA()->GetPosition().x, -15.0f);
    EXPECT_LT(JointsOf<b2WheelJoint>(*braked)[0]->GetBodyA()->GetPosition().x, -24.0f);
}

TEST(CarScene, ChangesSpringFrequencyByKeys)
{
    const auto scene = Make("Car");
    const b2WheelJoint* spring = JointsOf<b2WheelJoint>(*scene)[0];
    const float32 before = spring->GetSpringFrequencyHz();
    scene->KeyDown('e');
    EXPECT_EQ(spring->GetSpringFrequencyHz(), before + 1.0f);
    scene->KeyDown('q');
    scene->KeyDown('q');
    EXPECT_EQ(spring->GetSpringFrequencyHz(), before - 1.0f);
}

TEST(TheoJansensWalkerScene, WalksFiveMetresWithJointsIntact)
{
    const auto scene = Make("Theo Jansen's Walker");
    const b2RevoluteJoint* motor = JointsOf<b2RevoluteJoint>(*scene)[0];
    const b2Body* trunk = motor->GetBodyA();
    const float32 start = trunk->GetPosition().x;
    float32 steepest = 0.0f;
    float32 widest = 0.0f;
    Play(*scene, 10.0f, [&] {
        steepest = std::max(steepest, std::abs(trunk->GetAngle()));
        widest = std::max(widest, WidestHingeGap(*scene));
    });
    EXPECT_GT(std::abs(trunk->GetPosition().x - start), 5.0f);
    EXPECT_LT(steepest, 0.35f) << "it should walk upright";
    EXPECT_LT(widest, 0.1f);
    for (const b2DistanceJoint* rod : JointsOf<b2DistanceJoint>(*scene))
    {
        EXPECT_NEAR(b2Distance(rod->GetAnchorA(), rod->GetAnchorB()), rod->GetLength(), 0.1f);
    }
}

TEST(TheoJansensWalkerScene, WalksLeftOrRightByKeys)
{
    const auto right = Make("Theo Jansen's Walker");
    const auto left = Make("Theo Jansen's Walker");
    right->KeyDown('d');
    left->KeyDown('a');
    Play(*right, 6.0f);
    Play(*left, 6.0f);
    const auto place = [](Scene& scene) {
        return JointsOf<b2RevoluteJoint>(scene)[0]->GetBodyA()->GetPosition().x;
    };
    EXPECT_GT(place(*right), place(*left) + 6.0f);
}

TEST(RevoluteScene, TurnsWheelAtMotorSpeedAndStopsGateAtLimit)
{
    const auto scene = Make("Revolute");
    const auto hinges = JointsOf<b2RevoluteJoint>(*scene);
    ASSERT_EQ(hinges.size(), 3u);
    Play(*scene, 10.0f, [&] {
        EXPECT_GT(hinges[1]->GetJointAngle(), -0.25f * b2_pi - 0.05f);
        EXPECT_LT(hinges[1]->GetJointAngle(), 0.05f);
    });
    EXPECT_NEAR(hinges[0]->GetJointAngle(), -20.0f, 0.5f);
    EXPECT_LT(WidestHingeGap(*scene), 0.05f);
}

TEST(RevoluteScene, LetsItsGateHangWithoutTheLimit)
{
    const auto scene = Make("Revolute");
    const b2RevoluteJoint* gate = JointsOf<b2RevoluteJoint>(*scene)[1];
    scene->KeyDown('l');
    float32 lowest = 0.0f;
    Play(*scene, 3.0f, [&] { lowest = std::min(lowest, gate->GetJointAngle()); });
    EXPECT_LT(lowest, -0.6f * b2_pi);
}

TEST(PrismaticScene, CarriesItsBoxesUpAndDownBetweenTheLimits)
{
    const auto scene = Make("Prismatic");
    const b2PrismaticJoint* slide = JointsOf<b2PrismaticJoint>(*scene)[0];
    float32 minimum = 100.0f;
    float32 maximum = 0.0f;
    Play(*scene, 10.0f, [&] {
        maximum = std::max(maximum, slide->GetJointTranslation());
        minimum = std::min(minimum, slide->GetJointTranslation());
        EXPECT_NEAR(slide->GetBodyB()->GetAngle(), 0.0f, 0.02f);
    });
    EXPECT_NEAR(maximum, 17.0f, 0.7f);
    EXPECT_NEAR(minimum, 0.0f, 0.3f);
    for (const b2Body* body : Movers(*scene))
    {
        EXPECT_GT(body->GetPosition().y, 4.0f) << "a box fell off";
    }
}

TEST(PulleysScene, LowersBasketWhenBallsAreInIt)
{
    const auto scene = Make("Pulleys");
    const b2PulleyJoint* rope = JointsOf<b2PulleyJoint>(*scene)[0];
    const float32 whole = rope->GetCurrentLengthA() + rope->GetRatio() * rope->GetCurrentLengthB();
    const float32 basket = rope->GetCurrentLengthA();
    Play(*scene, 0.6f);
    EXPECT_LE(rope->GetCurrentLengthA(), basket + 0.1f) << "empty, it is held up";
    Play(*scene, 4.4f);
    EXPECT_TRUE(Movers(*scene).front()->IsAwake()) << "balls still fall into it";
    Play(*scene, 5.0f, [&] {
        EXPECT_NEAR(rope->GetCurrentLengthA() + rope->GetRatio() * rope->GetCurrentLengthB(), whole,
                    0.1f);
    });
    EXPECT_GT(rope->GetCurrentLengthA(), basket + 5.0f);
}

TEST(GearsScene, TurnsAsRatioOfTeethGives)
{
    const auto scene = Make("Gears");
    const auto gears = JointsOf<b2RevoluteJoint>(*scene);
    const b2PrismaticJoint* rack = JointsOf<b2PrismaticJoint>(*scene)[0];
    const float32 radius = 24.0f / (2.0f * b2_pi); // 24 teeth, one metre from each to the next
    float32 lowest = 0.0f;
    float32 highest = 0.0f;
    Play(*scene, 15.0f, [&] {
        EXPECT_NEAR(gears[0]->GetJointAngle(), -2.0f * gears[1]->GetJointAngle(), 0.02f);
        EXPECT_NEAR(rack->GetJointTranslation(), radius * gears[1]->GetJointAngle(), 0.02f);
        lowest = std::min(lowest, rack->GetJointTranslation());
        highest = std::max(highest, rack->GetJointTranslation());
    });
    EXPECT_NEAR(lowest, -5.0f, 0.2f);
    EXPECT_NEAR(highest, 5.0f, 0.2f);
}

TEST(SliderCrankScene, MovesItsPistonByTwiceTheCrank)
{
    const auto scene = Make("Slider Crank");
    const b2PrismaticJoint* piston = JointsOf<b2PrismaticJoint>(*scene)[0];
    float32 lowest = 0.0f;
    float32 highest = 0.0f;
    Play(*scene, 8.0f, [&] {
        lowest = std::min(lowest, piston->GetJointTranslation());
        highest = std::max(highest, piston->GetJointTranslation());
    });
    EXPECT_NEAR(lowest, -5.0f, 0.1f);
    EXPECT_NEAR(highest, 0.0f, 0.1f);
    EXPECT_NEAR(JointsOf<b2RevoluteJoint>(*scene)[0]->GetJointAngle(), 8.0f * b2_pi, 0.5f);
}

TEST(ApplyForceScene, PushesItsShipIntoTheBoxesAndAllComesToRest)
{
    const auto scene = Make("Apply Force");
    const std::vector<b2Body*> bodies = Movers(*scene);
    const b2Vec2 first = bodies[1]->GetPosition();
    Play(*scene, 6.0f);
    EXPECT_GT(b2Distance(bodies[1]->GetPosition(), first), 1.0f);
    scene->KeyDown('w'); // from here on the keys fly
    scene->KeyUp('w');
    Play(*scene, 5.0f);
    for (const b2Body* body : bodies)
    {
        EXPECT_LT(body->GetLinearVelocity().Length(), 0.1f);
    }
}

TEST(ApplyForceScene, TurnsShipByKeys)
{
    for (const char key : {'a', 'd'})
    {
        const auto scene = Make("Apply Force");
        scene->KeyDown(key);
        Play(*scene, 0.5f);
        const float32 turned = Movers(*scene)[0]->GetAngle();
        EXPECT_GT(key == 'a' ? turned : -turned, 0.1f);
    }
}

TEST(MotorJointScene, FollowsItsPathUnlessItIsStopped)
{
    const auto scene = Make("Motor Joint");
    const b2MotorJoint* motor = JointsOf<b2MotorJoint>(*scene)[0];
    const b2Body* plate = motor->GetBodyB();
    float32 left = 0.0f;
    float32 right = 0.0f;
    Play(*scene, 6.3f, [&] {
        EXPECT_LT(b2Distance(plate->GetPosition(), motor->GetLinearOffset()), 1.0f);
        left = std::min(left, plate->GetPosition().x);
        right = std::max(right, plate->GetPosition().x);
    });
    EXPECT_LT(left, -5.0f);
    EXPECT_GT(right, 5.0f);
    const std::vector<b2Body*> bodies = Movers(*scene);
    EXPECT_TRUE(std::ranges::any_of(bodies, [](b2Body* body) {
        return std::abs(body->GetPosition().x) > 9.0f;
    })) << "it should push boxes aside";
    scene->KeyDown('s');
    Play(*scene, 2.0f);
    const b2Vec2 stopped = plate->GetPosition();
    Play(*scene, 1.0f);
    EXPECT_LT(b2Distance(plate->GetPosition(), stopped), 0.05f);
}

TEST(RopeJointScene, KeepsTheChainWholeUntilTheRopeIsCut)
{
    const auto whole = Make("RopeJoint");
    const auto cut = Make("RopeJoint");
    cut->KeyDown('j');
    float32 gapWhole = 0.0f;
    float32 gapCut = 0.0f;
    Play(*whole, 8.0f, [&] { gapWhole = std::max(gapWhole, WidestHingeGap(*whole)); });
    Play(*cut, 8.0f, [&] { gapCut = std::max(gapCut, WidestHingeGap(*cut)); });
    EXPECT_LT(gapWhole, 0.15f);
    EXPECT_GT(gapCut, 4.0f * gapWhole);
    cut->KeyDown('j');
    EXPECT_EQ(JointsOf<b2RopeJoint>(*cut).size(), 1u);
}

TEST(ScissorLiftScene, RisesLevelWithItsLoadAndHoldsItUp)
{
    const auto scene = Make("Scissor Lift");
    const b2Body& platform = Named(*scene, "platform");
    const float32 start = platform.GetPosition().y;
    scene->KeyDown('w');
    Play(*scene, 2.0f, [&] { EXPECT_NEAR(platform.GetAngle(), 0.0f, 0.01f); });
    scene->KeyUp('w');
    Play(*scene, 1.0f);
    const float32 held = platform.GetPosition().y;
    EXPECT_GT(held, start + 2.0f);
    Play(*scene, 3.0f, [&] { EXPECT_NEAR(platform.GetPosition().y, held, 0.01f); });
    const std::vector<b2Body*> movers = Movers(*scene);
    for (std::size_t i = movers.size() - 4; i < movers.size(); ++i)
    {
        EXPECT_GT(movers[i]->GetPosition().y, held + 0.6f) << "a crate fell off";
    }
    EXPECT_LT(WidestHingeGap(*scene), 0.01f);

    scene->KeyDown('s');
    Play(*scene, 4.0f);
    EXPECT_NEAR(platform.GetPosition().y, start, 0.02f) << "down again, at the stop";
}

TEST(ScissorLiftScene, RisesAtConstantSpeed)
{
    const auto scene = Make("Scissor Lift");
    const b2PrismaticJoint* motor = JointsOf<b2PrismaticJoint>(*scene)[0];
    const b2Body& platform = Named(*scene, "platform");
    Play(*scene, 1.0f);
    const float32 first = motor->GetJointSpeed();
    Play(*scene, 4.0f, [&] { EXPECT_NEAR(platform.GetLinearVelocity().y, 1.5f, 0.05f); });
    EXPECT_LT(motor->GetJointSpeed(), 2.0f * first) << "both are negative";
}

TEST(RagdollScene, FallsDownStepsWithinJointLimits)
{
    const auto scene = Make("Ragdoll");
    const auto joints = JointsOf<b2RevoluteJoint>(*scene);
    ASSERT_EQ(joints.size(), 2u * 10u);
    float32 beyond = 0.0f;
    float32 widest = 0.0f;
    Play(*scene, 12.0f, [&] {
        for (const b2RevoluteJoint* joint : joints)
        {
            beyond = std::max({beyond, joint->GetJointAngle() - joint->GetUpperLimit(),
                               joint->GetLowerLimit() - joint->GetJointAngle()});
        }
        widest = std::max(widest, WidestHingeGap(*scene));
    });
    EXPECT_LT(beyond, 0.1f);
    EXPECT_LT(widest, 0.05f);
    for (const b2Body* part : Movers(*scene))
    {
        EXPECT_LT(part->GetLinearVelocity().Length(), 0.05f);
    }
    for (const char* name : {"first", "second"})
    {
        EXPECT_LT(Named(*scene, name).GetPosition().y, 6.0f) << name;
    }
}

TEST(SkierScene, GoesDownOverTheJumpOnItsSkiAndStopsUpright)
{
    const auto scene = Make("Skier");
    const b2Body& ski = Named(*scene, "ski");
    const b2Body& head = Named(*scene, "head");
    const float32 start = ski.GetPosition().y;
    float32 inTheAir = 0.0f;
    float32 longest = 0.0f;
    float32 lowestHead = 10.0f;
    float32 fastest = 0.0f;
    Play(*scene, 11.0f, [&] {
        bool touches = false;
        for (const b2ContactEdge* edge = ski.GetContactList(); edge; edge = edge->next)
        {
            touches = touches || edge->contact->IsTouching();
        }
        inTheAir = touches ? 0.0f : inTheAir + 1.0f / 60.0f;
        longest = std::max(longest, inTheAir);
        lowestHead = std::min(lowestHead, b2MulT(ski.GetTransform(), head.GetPosition()).y);
        fastest = std::max(fastest, ski.GetLinearVelocity().Length());
    });
    EXPECT_GT(longest, 0.8f) << "a jump";
    EXPECT_GT(lowestHead, 0.8f) << "it falls over";
    EXPECT_GT(fastest, 14.0f);
    EXPECT_GT(ski.GetPosition().x, 35.0f);
    EXPECT_LT(ski.GetPosition().y, start - 15.0f);
    EXPECT_LT(ski.GetLinearVelocity().Length(), 0.1f);
}

TEST(PinballScene, HitsBallUpWithFlippers)
{
    for (const float32 side : {-1.0f, 1.0f})
    {
        const auto scene = Make("Pinball");
        b2Body& ball = Named(*scene, "ball");
        const char key = side < 0.0f ? 'a' : 'd';
        scene->KeyDown(key);
        scene->KeyUp(key);
        Play(*scene, 0.5f);
        ball.SetTransform(b2Vec2(1.7f * side, 4.0f), 0.0f);
        ball.SetLinearVelocity(b2Vec2(0.0f, 0.0f));
        Play(*scene, 0.1f);
        EXPECT_LT(ball.GetLinearVelocity().y, 0.1f) << "lies on the flipper";
        scene->KeyDown(key);
        Play(*scene, 0.2f);
        EXPECT_GT(ball.GetLinearVelocity().y, 8.0f);
        scene->KeyUp(key);
        float32 highest = 0.0f;
        Play(*scene, 1.0f, [&] { highest = std::max(highest, ball.GetPosition().y); });
        EXPECT_GT(highest, 9.0f);
    }
}

TEST(PinballScene, PlaysByItselfAndKeepsTheBallOnTheTable)
{
    const auto scene = Make("Pinball");
    const b2Body& ball = Named(*scene, "ball");
    int32 hits = 0;
    int32 shots = 0;
    float32 before = 0.0f;
    Play(*scene, 60.0f, [&] {
        const b2Vec2 place = ball.GetPosition();
        const float32 up = ball.GetLinearVelocity().y;
        ASSERT_TRUE(place.x > -8.7f && place.x < 9.5f && place.y > 0.9f && place.y < 23.7f)
            << place.x << ", " << place.y;
        const bool isTurned = before < 4.0f && up > 8.0f;
        hits += isTurned && b2Abs(place.x) < 3.5f && place.y < 7.0f ? 1 : 0;
        shots += isTurned && place.x > 8.5f ? 1 : 0;
        before = up;
    });
    EXPECT_GE(hits, 3) << "the flippers play";
    EXPECT_GE(shots, 2) << "what they miss is shot again";
}

} // namespace
} // namespace boxreel
