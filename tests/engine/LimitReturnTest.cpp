// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <algorithm>

/// Joints beyond their limits, because they were made so, the program moved the limit, or a contact
/// holds the bodies there.
namespace
{

using namespace dynamics;

class LimitReturn : public testing::TestWithParam<int32>
{
protected:
    /// Weightless, of 1 kg.
    struct Pair : JointScene
    {
        Pair(int32 subSteps, bool touch) : JointScene(b2Vec2_zero)
        {
            world.SetSubStepCount(subSteps);
            a = touch ? Ball(0.0f) : Post();
            b = Ball(0.8f);
        }
        b2Body* Ball(float32 x)
        {
            b2Body* body = Body(b2_dynamicBody, x, 0.0f);
            body->SetSleepingAllowed(false);
            AddBall(body, 0.5f)->SetDensity(1.0f / (0.25f * b2_pi));
            body->ResetMassData();
            return body;
        }
        void Rope(float32 length)
        {
            b2RopeJointDef def;
            def.bodyA = a;
            def.bodyB = b;
            def.localAnchorA = def.localAnchorB = b2Vec2_zero;
            def.maxLength = length;
            def.collideConnected = true;
            (void)Create<b2RopeJoint>(def);
        }
        /// Starts beyond its limit by `beyond` [m].
        void Slider(float32 beyond, float32 half)
        {
            b2PrismaticJointDef def;
            def.Initialize(a, b, a->GetPosition(), b2Vec2(1.0f, 0.0f));
            def.enableLimit = true;
            def.lowerTranslation = -2.0f * half - beyond;
            def.upperTranslation = -beyond;
            def.collideConnected = true;
            (void)Create<b2PrismaticJoint>(def);
        }
        /// Starts beyond its limit by `beyond` [rad].
        void Hinge(const b2Vec2& place, float32 beyond, float32 half)
        {
            b2RevoluteJointDef def;
            def.Initialize(a, b, place);
            def.enableLimit = true;
            def.lowerAngle = -2.0f * half - beyond;
            def.upperAngle = -beyond;
            def.collideConnected = true;
            (void)Create<b2RevoluteJoint>(def);
        }
        double Kinetic() const
        {
            double sum = 0.0;
            for (const b2Body* body : {a, b})
            {
                const double w = double(body->GetAngularVelocity());
                sum += 0.5 * double(body->GetMass()) *
                           double(body->GetLinearVelocity().LengthSquared()) +
                       0.5 * double(body->GetInertia()) * w * w;
            }
            return sum;
        }

        b2Body* a;
        b2Body* b;
    };

    /// The body comes back to its limit, and stays there.
    static void ExpectReturn(Pair& pair, const std::string& what,
                             const std::function<float32()>& beyond)
    {
        double most = 0.0;
        for (int i = 0; i < 300; ++i)
        {
            pair.Step();
            most = std::max(most, pair.Kinetic());
        }
        EXPECT_LT(most, 1e-4) << what;
        EXPECT_LT(b2Abs(beyond()), 0.05f) << what;
    }
};
INSTANTIATE_TEST_SUITE_P(SubSteps, LimitReturn, testing::Values(1, 2, 4, 8));

/// With sub-steps it came back with 2 m/s or rad/s, and went on to its other limit.
TEST_P(LimitReturn, StopsAtTheLimit)
{
    for (const float32 start : {0.02f, 0.1f, 0.5f})
    {
        Pair slider(GetParam(), false);
        slider.Slider(start, 5.0f);
        ExpectReturn(slider, "slider", [&] { return slider.b->GetPosition().x - (0.8f - start); });
        Pair hinge(GetParam(), false);
        hinge.Hinge(b2Vec2(0.8f, 0.0f), start, 3.0f);
        ExpectReturn(hinge, "hinge", [&] { return hinge.b->GetAngle() + start; });
        Pair rope(GetParam(), false);
        rope.Rope(0.8f - start);
        ExpectReturn(rope, "rope", [&] { return rope.b->GetPosition().Length() - (0.8f - start); });
    }
}

/// A lift on a slider overshot by 0.12 to 0.18 m, the more the more sub-steps.
TEST_P(LimitReturn, LiftsAsFarAsTheProgramSays)
{
    JointScene scene;
    scene.world.SetSubStepCount(GetParam());
    b2Body* lift = scene.Load(0.0f, 0.0f);
    b2PrismaticJointDef def;
    def.Initialize(scene.Post(), lift, b2Vec2_zero, b2Vec2(0.0f, 1.0f));
    def.enableLimit = true;
    def.upperTranslation = 5.0f;
    auto* joint = scene.Create<b2PrismaticJoint>(def);
    scene.Step(60);
    joint->SetLimits(0.1f, 5.0f);
    float32 highest = 0.0f;
    for (int i = 0; i < 120; ++i)
    {
        scene.Step();
        highest = std::max(highest, lift->GetPosition().y);
    }
    EXPECT_LT(highest, 0.101f);
    EXPECT_NEAR(lift->GetPosition().y, 0.1f, 0.011f);
}

/// Two balls of 1 kg that overlap by 0.2 m as far as a limit allows. One turns at 0.1 rad/s, and
/// has 0.0006 J. With 2 to 8 sub-steps they had up to 870 J.
TEST_P(LimitReturn, GainsNothingAgainstAContact)
{
    for (const float32 friction : {0.0f, 0.4f})
    {
        for (int kind = 0; kind < 3; ++kind)
        {
            Pair pair(GetParam(), true);
            for (b2Body* body : {pair.a, pair.b})
            {
                body->GetFixtureList()->SetFriction(friction);
            }
            pair.b->SetAngularVelocity(0.1f);
            kind == 0   ? pair.Rope(0.8f)
            : kind == 1 ? pair.Slider(-0.05f, 0.05f)
                        : pair.Hinge(b2Vec2(0.4f, -0.6f), -0.02f, 0.02f);
            double most = 0.0;
            for (int i = 0; i < 600; ++i)
            {
                pair.Step();
                most = std::max(most, pair.Kinetic());
            }
            EXPECT_LT(most, 0.001) << "kind " << kind << ", friction " << friction;
        }
    }
}

/// The program shortens a rope between a trolley and its load by 2 to 20 cm more than the shapes
/// allow. With 8 sub-steps circles had up to 1,200 J, boxes with 4 up to 570.
TEST_P(LimitReturn, PullsALoadAgainstItsTrolley)
{
    for (const bool isBall : {true, false})
    {
        for (const float32 under : {0.02f, 0.05f, 0.1f, 0.2f})
        {
            JointScene scene;
            scene.world.SetSubStepCount(GetParam());
            b2Body* bodies[2];
            for (int i = 0; i < 2; ++i)
            {
                bodies[i] = scene.Body(b2_dynamicBody, 0.1f * float32(i), -3.0f * float32(i));
                isBall ? scene.AddBall(bodies[i], 0.5f, 0.4f, 0.0f)
                       : scene.AddBox(bodies[i], 0.5f, 0.5f, 0.4f, 0.0f);
            }
            b2PrismaticJointDef slider;
            slider.Initialize(scene.Post(), bodies[0], b2Vec2_zero, b2Vec2(1.0f, 0.0f));
            (void)scene.Create<b2PrismaticJoint>(slider);
            b2RopeJointDef def;
            def.bodyA = bodies[0];
            def.bodyB = bodies[1];
            def.localAnchorA = def.localAnchorB = b2Vec2_zero;
            def.maxLength = 3.1f;
            def.collideConnected = true;
            auto* rope = scene.Create<b2RopeJoint>(def);
            float32 fastest = 0.0f;
            for (int i = 0; i < 900; ++i)
            {
                const float32 length = 3.1f - 0.5f * float32(i) / 60.0f;
                rope->SetMaxLength(std::max(length, 1.0f - under));
                scene.Step();
                fastest =
                    i < 360 ? 0.0f : std::max(fastest, bodies[1]->GetLinearVelocity().Length());
            }
            EXPECT_LT(fastest, 0.3f) << (isBall ? "ball, " : "box, ") << under << " m";
        }
    }
}

} // namespace
