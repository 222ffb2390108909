// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <Dynamics/Joints/PrismaticLanes.h>
#include <Dynamics/Joints/RevoluteLanes.h>

#include <algorithm>
#include <array>
#include <cmath>

/// Limits and motors of hinges and sliders, which are solved as one block with the two rigid rows.
/// Also on arms that are long compared with the bodies, where solving one row after the other
/// converges slowly.
namespace
{

using namespace dynamics;

constexpr float32 kLimit = 0.5f;    ///< [rad]
constexpr float32 kOverrun = 0.08f; ///< less than a step at kSpeed [rad]
constexpr float32 kSpeed = 5.0f;    ///< towards the limit [rad/s]

/// A ball that swings at the end of an arm towards a limit of its hinge, without gravity.
struct BallOnArm : JointScene
{
    explicit BallOnArm(float32 arm, bool ballFirst = false) : JointScene(b2Vec2(0.0f, 0.0f))
    {
        b2Body* post = Post();
        ball = Ball(arm, 0.0f);
        ball->SetSleepingAllowed(false);
        b2RevoluteJointDef def;
        def.Initialize(ballFirst ? ball : post, ballFirst ? post : ball, b2Vec2(0.0f, 0.0f));
        def.enableLimit = true;
        def.lowerAngle = -kLimit;
        def.upperAngle = kLimit;
        hinge = Create<b2RevoluteJoint>(def);
        ball->SetAngularVelocity(kSpeed);
        ball->SetLinearVelocity(b2Vec2(0.0f, arm * kSpeed));
    }

    /// The largest overrun in a number of steps [rad].
    float32 Overrun(int steps)
    {
        float32 overrun = 0.0f;
        for (int i = 0; i < steps; ++i)
        {
            Step();
            overrun = b2Max(overrun, b2Abs(hinge->GetJointAngle()) - kLimit);
        }
        return overrun;
    }

    b2Body* ball;
    b2RevoluteJoint* hinge;
};

TEST(RevoluteLimit, StopsABallOnALongArmWithinASecond)
{
    for (const bool ballFirst : {false, true})
    {
        for (const float32 arm : {2.0f, 4.0f, 8.0f, 30.0f})
        {
            BallOnArm scene(arm, ballFirst);
            EXPECT_LE(scene.Overrun(60), kOverrun) << arm << " m";
            EXPECT_NEAR(scene.hinge->GetJointSpeed(), 0.0f, 1e-3f) << arm << " m";
            EXPECT_NEAR(b2Abs(scene.hinge->GetJointAngle()), kLimit, b2_angularSlop) << arm << " m";
        }
    }
}

TEST(RevoluteLimit, StopsABallOnALongArmWithSubSteps)
{
    for (const int32 count : {2, 4})
    {
        BallOnArm scene(8.0f);
        scene.world.SetSubStepCount(count);
        EXPECT_LE(scene.Overrun(60), 1e-4f) << count;
        EXPECT_NEAR(scene.hinge->GetJointSpeed(), 0.0f, 1e-4f) << count;
    }
}

TEST(RevoluteLimit, TurnsBackALongArmThatIsBeyondIt)
{
    BallOnArm scene(8.0f);
    scene.ball->SetAngularVelocity(0.0f);
    scene.ball->SetLinearVelocity(b2Vec2(0.0f, 0.0f));
    scene.hinge->SetLimits(0.3f, kLimit);
    scene.Step(2); // a step turns by b2_maxAngularCorrection at most, an iteration
    EXPECT_NEAR(scene.hinge->GetJointAngle(), 0.3f, 1.5f * b2_angularSlop);
    EXPECT_LT(b2Distance(scene.hinge->GetAnchorA(), scene.hinge->GetAnchorB()), b2_linearSlop);
}

TEST(RevoluteLimit, KeepsTheMomentaOfTwoFreeBodies)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2Body* a = scene.Load(0.0f, 0.0f, 0.5f, 0.25f);
    b2Body* b = scene.Load(5.0f, 0.0f, 0.25f, 0.25f);
    b2RevoluteJointDef def;
    def.Initialize(a, b, b2Vec2(1.0f, 1.0f));
    def.enableLimit = true;
    def.lowerAngle = -0.1f;
    def.upperAngle = 0.1f;
    auto* hinge = scene.Create<b2RevoluteJoint>(def);
    b->ApplyLinearImpulse(b2Vec2(0.0f, 1.0f), b->GetWorldCenter());
    const auto turning = [](const b2Body* body) {
        return body->GetInertia() * body->GetAngularVelocity() +
               body->GetMass() * b2Cross(body->GetWorldCenter(), body->GetLinearVelocity());
    };
    scene.Step(30);
    EXPECT_NEAR(hinge->GetJointAngle(), 0.1f, b2_angularSlop);
    EXPECT_NEAR(hinge->GetJointSpeed(), 0.0f, 1e-3f);
    const b2Vec2 momentum =
        a->GetMass() * a->GetLinearVelocity() + b->GetMass() * b->GetLinearVelocity();
    EXPECT_NEAR(momentum.x, 0.0f, 1e-4f);
    EXPECT_NEAR(momentum.y, 1.0f, 1e-4f);
    EXPECT_NEAR(turning(a) + turning(b), 5.0f, 0.05f);
}

TEST(PrismaticLimit, StopsABallFarFromItsAxis)
{
    for (const float32 offset : {0.0f, 2.0f, 8.0f})
    {
        JointScene scene(b2Vec2(0.0f, 0.0f));
        b2Body* ball = scene.Ball(0.0f, 0.0f);
        b2PrismaticJointDef def;
        def.Initialize(scene.Post(), ball, b2Vec2(0.0f, offset), b2Vec2(1.0f, 0.0f));
        def.enableLimit = true;
        def.lowerTranslation = -2.0f;
        def.upperTranslation = 2.0f;
        auto* slider = scene.Create<b2PrismaticJoint>(def);
        ball->SetLinearVelocity(b2Vec2(10.0f, 0.0f));
        float32 farthest = 0.0f;
        for (int i = 0; i < 60; ++i)
        {
            scene.Step();
            farthest = b2Max(farthest, b2Abs(slider->GetJointTranslation()));
        }
        EXPECT_LE(farthest, 2.0f + b2_linearSlop) << offset;
        EXPECT_NEAR(slider->GetJointTranslation(), 2.0f, b2_linearSlop) << offset;
        EXPECT_NEAR(slider->GetJointSpeed(), 0.0f, 1e-3f) << offset;
    }
}

TEST(RevoluteMotor, ReachesItsSpeedInAStepOnALongArm)
{
    BallOnArm scene(8.0f);
    scene.hinge->EnableLimit(false);
    scene.hinge->EnableMotor(true);
    scene.hinge->SetMotorSpeed(1.0f);
    scene.hinge->SetMaxMotorTorque(1e6f);
    scene.Step();
    EXPECT_NEAR(scene.hinge->GetJointSpeed(), 1.0f, 1e-3f);
}

TEST(PrismaticMotor, ReachesItsSpeedInAStepFarFromItsAxis)
{
    JointScene scene(b2Vec2(0.0f, 0.0f));
    b2PrismaticJointDef def;
    def.Initialize(scene.Post(), scene.Ball(0.0f, 0.0f), b2Vec2(0.0f, 8.0f), b2Vec2(1.0f, 0.0f));
    def.enableMotor = true;
    def.motorSpeed = 1.0f;
    def.maxMotorForce = 1e6f;
    auto* slider = scene.Create<b2PrismaticJoint>(def);
    scene.Step();
    EXPECT_NEAR(slider->GetJointSpeed(), 1.0f, 1e-3f);
}

/// A body that a strong motor drives along an axis 14 m away, from limit to limit.
TEST(PrismaticMotor, StopsAtTheLimitsOfADistantAxis)
{
    JointScene scene;
    b2Body* body = scene.Load(-10.0f, 10.0f, 2.0f, 0.5f);
    b2PrismaticJointDef def;
    def.Initialize(scene.Post(), body, b2Vec2(0.0f, 0.0f), b2Vec2(2.0f, 1.0f));
    def.enableLimit = true;
    def.upperTranslation = 20.0f;
    def.enableMotor = true;
    def.maxMotorForce = 10000.0f;
    def.motorSpeed = 10.0f;
    auto* slider = scene.Create<b2PrismaticJoint>(def);
    float32 farthest = 0.0f;
    float32 nearest = 0.0f;
    for (int i = 0; i < 600; ++i)
    {
        scene.Step();
        farthest = b2Max(farthest, slider->GetJointTranslation());
        nearest = b2Min(nearest, slider->GetJointTranslation());
        slider->SetMotorSpeed(i < 300 ? 10.0f : -10.0f);
    }
    EXPECT_NEAR(farthest, 20.0f, b2_linearSlop);
    EXPECT_NEAR(nearest, 0.0f, b2_linearSlop);
    EXPECT_NEAR(slider->GetJointSpeed(), 0.0f, 1e-3f);
}

/// The angle of a crank after 10 s that a motor turns against a rod and a piston [rad].
float32 TurnCrank(int32 subSteps)
{
    JointScene scene;
    scene.world.SetSubStepCount(subSteps);
    const auto part = [&](float32 y, float32 hx, float32 hy) {
        b2Body* body = scene.Body(b2_dynamicBody, 0.0f, y);
        b2Fixture* fixture = Scene::AddBox(body, hx, hy);
        fixture->SetDensity(2.0f);
        fixture->SetSensor(true);
        body->ResetMassData();
        return body;
    };
    b2Body* post = scene.Post();
    b2Body* crank = part(7.0f, 0.5f, 2.0f);
    b2Body* rod = part(13.0f, 0.5f, 4.0f);
    b2Body* piston = part(17.0f, 1.5f, 1.5f);
    b2RevoluteJointDef hinge;
    hinge.Initialize(post, crank, b2Vec2(0.0f, 5.0f));
    hinge.enableMotor = true;
    hinge.motorSpeed = b2_pi;
    hinge.maxMotorTorque = 10000.0f;
    auto* motor = scene.Create<b2RevoluteJoint>(hinge);
    hinge.enableMotor = false;
    hinge.Initialize(crank, rod, b2Vec2(0.0f, 9.0f));
    scene.world.CreateJoint(&hinge);
    hinge.Initialize(rod, piston, b2Vec2(0.0f, 17.0f));
    scene.world.CreateJoint(&hinge);
    b2PrismaticJointDef slide;
    slide.Initialize(post, piston, piston->GetPosition(), b2Vec2(0.0f, 1.0f));
    slide.enableMotor = true; // as friction
    slide.maxMotorForce = 1000.0f;
    scene.world.CreateJoint(&slide);
    scene.Step(600);
    return motor->GetJointAngle();
}

TEST(RevoluteMotor, TurnsACrankAsFarAsSubStepsDo)
{
    constexpr float32 kFirstOrder = 0.05f; // of a single step [rad]; 2.4 is off by 0.11
    EXPECT_NEAR(TurnCrank(1), TurnCrank(8), kFirstOrder);
}

/// The last column of the inverse of a symmetric matrix, by cofactors.
std::array<double, 3> LastColumnOfInverse(const double (&m)[3][3])
{
    const double x = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    const double y = m[0][2] * m[1][0] - m[0][0] * m[1][2];
    const double z = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    const double determinant = m[2][0] * x + m[2][1] * y + m[2][2] * z;
    return {x / determinant, y / determinant, z / determinant};
}

using One = box2d::simd::Float1;

/// K of three rows, of which each has these derivatives by the bodies' velocities (x, y, turn).
std::array<double, 3> BlockSolution(const box2d::PairMasses<One>& pair, const double (&a)[3][3],
                                    const double (&b)[3][3])
{
    double matrix[3][3];
    for (int i = 0; i < 3; ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            matrix[i][k] = double(pair.mA.v) * (a[i][0] * a[k][0] + a[i][1] * a[k][1]) +
                           double(pair.iA.v) * a[i][2] * a[k][2] +
                           double(pair.mB.v) * (b[i][0] * b[k][0] + b[i][1] * b[k][1]) +
                           double(pair.iB.v) * b[i][2] * b[k][2];
        }
    }
    return LastColumnOfInverse(matrix);
}

/// An impulse of 1 along the third row with its answer, scaled to change that row's speed by 1, is
/// the last column of the inverse.
void ExpectBlockSolution(const box2d::HeldRow<One>& row, const std::array<double, 3>& solution)
{
    constexpr double kRounding = 1e-4; // of single precision on arms of 10 m
    const double mass = double(row.mass.v);
    EXPECT_NEAR(mass, solution[2], kRounding * solution[2]);
    const double maximum = std::max(std::abs(solution[0]), std::abs(solution[1])) + solution[2];
    EXPECT_NEAR(mass * double(row.reaction.x.v), solution[0], kRounding * maximum);
    EXPECT_NEAR(mass * double(row.reaction.y.v), solution[1], kRounding * maximum);
}

TEST(HeldRow, EqualsTheBlockSolutionOfThreeRows)
{
    JointScene random;
    for (int i = 0; i < 200; ++i)
    {
        const auto mass = [&] { return One{std::exp(3.0f * random.Random())}; };
        const auto arm = [&] { return 10.0f * random.Random(); };
        box2d::PairMasses<One> pair = {mass(), mass(), mass(), mass()};
        if (i % 3 == 0)
        {
            pair.mA = pair.iA = One{0.0f}; // a post
        }
        const double rA[2] = {double(arm()), double(arm())};
        const double rB[2] = {double(arm()), double(arm())};
        const auto hinge = box2d::HeldRow<One>::AngleOfPoint(
            pair, {{float32(rA[0])}, {float32(rA[1])}}, {{float32(rB[0])}, {float32(rB[1])}});
        ExpectBlockSolution(
            hinge, BlockSolution(pair, {{-1.0, 0.0, rA[1]}, {0.0, -1.0, -rA[0]}, {0.0, 0.0, -1.0}},
                                 {{1.0, 0.0, -rB[1]}, {0.0, 1.0, rB[0]}, {0.0, 0.0, 1.0}}));
        // An axis along x: the levers are r.x across it and -r.y along it.
        const box2d::PrismaticLanes<One>::Levers levers = {
            {float32(-rA[1])}, {float32(-rB[1])}, {float32(rA[0])}, {float32(rB[0])}};
        ExpectBlockSolution(
            levers.RowOf(pair),
            BlockSolution(pair, {{0.0, -1.0, -rA[0]}, {0.0, 0.0, -1.0}, {-1.0, 0.0, rA[1]}},
                          {{0.0, 1.0, rB[0]}, {0.0, 0.0, 1.0}, {1.0, 0.0, -rB[1]}}));
    }
}

TEST(HeldRow, HasNoMassWhereBodiesCannotMove)
{
    const One none = {0.0f};
    const box2d::PairMasses<One> stiff = {{1.0f}, none, {2.0f}, none};
    const auto hinge = box2d::HeldRow<One>::AngleOfPoint(stiff, {{1.0f}, {2.0f}}, {{3.0f}, {4.0f}});
    EXPECT_EQ(hinge.mass.v, 0.0f);
    const box2d::PrismaticLanes<One>::Levers levers = {{1.0f}, {2.0f}, {3.0f}, {4.0f}};
    EXPECT_NEAR(levers.RowOf(stiff).mass.v, 1.0f / 3.0f, 1e-6f) << "sliding needs no turning";
    const box2d::PairMasses<One> unused = {none, none, none, none};
    EXPECT_EQ(levers.RowOf(unused).mass.v, 0.0f);
}

} // namespace
