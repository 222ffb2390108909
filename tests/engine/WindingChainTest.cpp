// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// A plate spins in free space and winds a chain around itself. Its contacts hold the links out,
/// and hinges hold them in: rows that contradict each other by rounding. Where impulses of any size
/// balanced that, the plate stopped within a step, and nothing took its angular momentum.
namespace
{

using namespace dynamics;

struct WindingChain : Scene
{
    explicit WindingChain(float32 spin) : Scene(b2Vec2_zero)
    {
        plate = Body(b2_dynamicBody, 0.0f, 0.0f);
        b2PolygonShape box;
        box.SetAsBox(0.3f, 0.9f);
        Add(*plate, box, 100.0f);
        plate->SetAngularVelocity(spin);
        b2Body* last = plate;
        constexpr int kLinks = 12;
        for (int i = 0; i < kLinks; ++i)
        {
            b2Body* link = Body(b2_dynamicBody, 0.45f + 0.3f * float32(i), 0.0f);
            box.SetAsBox(0.15f, 0.036f);
            Add(*link, box, 0.05f);
            Hinge(*last, *link, 0.3f + 0.3f * float32(i));
            last = link;
        }
        b2Body* ball = Body(b2_dynamicBody, 4.0f, 0.0f);
        b2CircleShape circle;
        circle.m_radius = 0.15f;
        Add(*ball, circle, 0.5f);
        Hinge(*last, *ball, 3.9f);
    }

    double AngularMomentum() const
    {
        double sum = 0.0; // [N m s]
        for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
        {
            sum += double(body->GetMass()) *
                       double(b2Cross(body->GetWorldCenter(), body->GetLinearVelocity())) +
                   double(body->GetInertia()) * double(body->GetAngularVelocity());
        }
        return sum;
    }

    b2Body* plate;

private:
    /// Links do not touch each other.
    void Add(b2Body& body, const b2Shape& shape, float32 mass) const
    {
        b2MassData of;
        shape.ComputeMass(&of, 1.0f);
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = mass / of.mass;
        fixture.friction = 0.0f;
        fixture.filter.groupIndex = &body == plate ? 0 : -3;
        body.CreateFixture(&fixture);
    }

    void Hinge(b2Body& a, b2Body& b, float32 x)
    {
        b2RevoluteJointDef def;
        def.Initialize(&a, &b, b2Vec2(x, 0.0f));
        world.CreateJoint(&def);
    }
};

class Winding : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, Winding, testing::Values(2, 4, 8));

TEST_P(Winding, OfAChainKeepsTheAngularMomentumOfAStep)
{
    for (int spin = 8; spin <= 14; ++spin)
    {
        WindingChain scene{float32(spin)};
        scene.world.SetSubStepCount(GetParam());
        const double first = scene.AngularMomentum();
        double before = first;
        double change = 0.0;
        for (int step = 0; step < 300; ++step)
        {
            scene.Step();
            change = std::max(change, std::abs(scene.AngularMomentum() - before));
            before = scene.AngularMomentum();
        }
        EXPECT_LT(change, 0.1 * first) << spin;
        EXPECT_GT(before, 0.4 * first) << spin;
    }
}

} // namespace
