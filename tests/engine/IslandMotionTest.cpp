// SPDX-License-Identifier: MIT
#include "JointScene.h"

#include <Dynamics/Energy/IslandMotion.h>
#include <Dynamics/Solver/SolverMemory.h>
#include <Dynamics/State/World.h>

/// The order in which an island loses energy: first its inner motion, then the motion of the whole.
namespace
{

using namespace dynamics;

/// Two boxes of 4 and 1 kg on a hinge that move in all directions.
struct Pair : JointScene
{
    explicit Pair(bool isHeld) : JointScene(b2Vec2_zero)
    {
        a = Load(0.0f, 0.0f, 1.0f, 1.0f);
        b = Load(2.0f, 0.5f, 0.5f, 0.5f);
        Join(a, b);
        if (isHeld)
        {
            Join(Post(), a);
        }
        bodies.assign(World().awakeBodies.size() + 1, box2d::SolverBody());
        At(a).v = b2Vec2(1.0f, -2.0f);
        At(a).w = 3.0f;
        At(b).v = b2Vec2(-4.0f, 5.0f);
        At(b).w = -6.0f;
    }
    void Join(b2Body* from, b2Body* to)
    {
        b2RevoluteJointDef def;
        def.Initialize(from, to, from->GetPosition());
        world.CreateJoint(&def);
    }
    box2d::World& World() { return *box2d::Data(*a).world; }
    box2d::SolverBody& At(const b2Body* body)
    {
        return bodies[std::size_t(box2d::Data(*body).SolverIndex())];
    }
    box2d::IslandMotion Motion()
    {
        const box2d::World& w = World();
        return {*w.islands.At(box2d::Data(*a).island).first, bodies.data()};
    }
    double Kinetic()
    {
        double sum = 0.0;
        for (const b2Body* body : {a, b})
        {
            sum +=
                box2d::KineticEnergy(At(body), double(body->GetMass()), double(body->GetInertia()));
        }
        return sum;
    }
    b2Vec2 Momentum() { return a->GetMass() * At(a).v + b->GetMass() * At(b).v; }
    float32 Spin()
    {
        float32 sum = 0.0f;
        for (const b2Body* body : {a, b})
        {
            sum += body->GetMass() * b2Cross(body->GetWorldCenter(), At(body).v) +
                   body->GetInertia() * At(body).w;
        }
        return sum;
    }

    b2Body* a;
    b2Body* b;
    std::vector<box2d::SolverBody> bodies;
};

TEST(IslandMotion, HasTheEnergyAndMassOfItsBodies)
{
    Pair pair(false);
    EXPECT_NEAR(pair.Motion().Energy(), pair.Kinetic(), 1e-4);
    EXPECT_NEAR(pair.Motion().Mass(), 5.0, 1e-6);
}

TEST(IslandMotion, LosesRelativeMotionFirstInAFreeIsland)
{
    Pair pair(false);
    const double before = pair.Kinetic();
    const b2Vec2 momentum = pair.Momentum();
    const float32 spin = pair.Spin();
    pair.Motion().Lose(10.0); // 11.8 J move within
    EXPECT_NEAR(pair.Kinetic(), before - 10.0, 1e-4);
    EXPECT_NEAR(b2Distance(pair.Momentum(), momentum), 0.0f, 1e-5f);
    EXPECT_NEAR(pair.Spin(), spin, 1e-4f);
}

TEST(IslandMotion, ScalesAllVelocitiesOfAHeldIslandAlike)
{
    Pair pair(true);
    const double before = pair.Kinetic();
    pair.Motion().Lose(0.75 * before);
    EXPECT_NEAR(b2Distance(pair.At(pair.a).v, b2Vec2(0.5f, -1.0f)), 0.0f, 1e-5f);
    EXPECT_NEAR(pair.At(pair.b).w, -3.0f, 1e-5f);
}

TEST(IslandMotion, StopsWhenItLosesMoreThanItHas)
{
    for (const bool isHeld : {false, true})
    {
        Pair pair(isHeld);
        pair.Motion().Lose(2.0 * pair.Kinetic());
        EXPECT_EQ(pair.Kinetic(), 0.0) << isHeld;
    }
}

} // namespace
