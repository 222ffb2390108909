// SPDX-License-Identifier: MIT
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

/// Heaps of boxes with joints between them, of masses up to 10,000 to 1, are thrown about between
/// walls. The impulses of an impact are a bad start of the next sub-step there: without the guard,
/// the kinetic energy of some grows to 400 times what it was.
namespace
{

using namespace dynamics;

struct Heap : Scene
{
    Heap(unsigned seed, int32 subSteps) : Scene(b2Vec2_zero), m_random(seed)
    {
        world.SetSubStepCount(subSteps);
        b2Body* walls = Body(b2_staticBody, 0.0f, 0.0f);
        for (const b2Vec2& side : {b2Vec2(0.0f, 1.0f), b2Vec2(-1.0f, 0.0f)})
        {
            for (const float32 at : {-4.4f, 4.4f})
            {
                b2PolygonShape wall;
                wall.SetAsBox(side.x == 0.0f ? 5.0f : 0.5f, side.x == 0.0f ? 0.5f : 5.0f, at * side,
                              0.0f);
                walls->CreateFixture(&wall, 0.0f);
            }
        }
        for (int i = 0; i < 10; ++i)
        {
            boxes.push_back(RandomBox());
        }
        for (int i = 0; i < 10; ++i)
        {
            b2Body* other = boxes[(std::size_t(i) + 1 + m_random() % 4) % 10];
            b2RevoluteJointDef def;
            def.Initialize(boxes[std::size_t(i)], other,
                           0.5f * (boxes[std::size_t(i)]->GetPosition() + other->GetPosition()));
            def.collideConnected = true;
            world.CreateJoint(&def);
        }
    }

    double Energy() const
    {
        double energy = 0.0; // [J]
        for (const b2Body* box : boxes)
        {
            const double speed = box->GetAngularVelocity();
            energy += 0.5 * box->GetMass() * double(box->GetLinearVelocity().LengthSquared()) +
                      0.5 * box->GetInertia() * speed * speed;
        }
        return energy;
    }

    std::vector<b2Body*> boxes;

private:
    // Not a distribution of the library: these differ from one to the other.
    float32 Random(double low, double high)
    {
        return float32(low + (high - low) * double(m_random()) / 4294967296.0);
    }

    b2Body* RandomBox()
    {
        b2BodyDef def;
        def.type = b2_dynamicBody;
        def.allowSleep = false;
        def.position.x = Random(-2.5, 2.5);
        def.position.y = Random(-2.5, 2.5);
        def.angle = Random(0.0, 6.0);
        def.linearVelocity.x = Random(-30.0, 30.0);
        def.linearVelocity.y = Random(-30.0, 30.0);
        def.angularVelocity = Random(-10.0, 10.0);
        b2Body* body = world.CreateBody(&def);
        b2PolygonShape shape;
        const float32 halfWidth = Random(0.1, 0.6);
        shape.SetAsBox(halfWidth, Random(0.1, 0.6));
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = std::pow(10.0f, Random(-2.0, 2.0));
        fixture.friction = Random(0.0, 1.0);
        body->CreateFixture(&fixture);
        return body;
    }

    std::mt19937 m_random;
};

class WarmStartGuard : public testing::TestWithParam<int32>
{};
INSTANTIATE_TEST_SUITE_P(SubSteps, WarmStartGuard, testing::Values(2, 4, 8));

/// The largest gain of a heap over its least energy so far.
struct Gain
{
    double factor = 1.0; ///< of the least energy so far
    double share = 0.0;  ///< of the energy at the start
};

Gain LargestGain(Heap& heap)
{
    heap.Step(5); // boxes that overlap at the start are pushed apart
    const double first = heap.Energy();
    double least = first;
    Gain gain;
    for (int i = 0; i < 180 && least > 0.001 * first; ++i)
    {
        heap.Step();
        const double energy = heap.Energy();
        gain.factor = std::max(gain.factor, energy / least);
        gain.share = std::max(gain.share, (energy - least) / first);
        least = std::min(least, energy);
    }
    return gain;
}

/// One heap in a few hundred gains a twentieth. Which one changes with the bits, so this counts
/// them. Without the guard two thirds of them do, and some gain 400 times what they had.
///
/// Of heaps 0 to 600 one gains with 2 sub-steps, none with 4 and three with 8. They gain at most
/// 15 % of their energy at the start. A gain that returns in each step is soon above a quarter.
TEST_P(WarmStartGuard, LetsImpactsOfJointedBodiesAddNoEnergy)
{
    std::vector<unsigned> gaining;
    for (unsigned seed = 0; seed < 200; ++seed)
    {
        Heap heap(seed, GetParam());
        const Gain gain = LargestGain(heap);
        if (gain.factor >= 1.05)
        {
            gaining.push_back(seed);
        }
        EXPECT_LT(gain.factor, 1.25) << "heap " << seed;
        EXPECT_LT(gain.share, 0.25) << "heap " << seed;
    }
    EXPECT_LE(gaining.size(), 2u) << testing::PrintToString(gaining);
}

enum class Drive
{
    Platform,
    Belt
};

/// Boxes of 5 and 20 kg between walls, which fall on a floor that moves at 1 cm/s.
struct DrivenHeap : Scene
{
    DrivenHeap(unsigned seed, int32 subSteps, Drive drive)
        : Scene(b2Vec2(0.0f, -10.0f)), m_random(seed), m_belt(drive == Drive::Belt)
    {
        world.SetSubStepCount(subSteps);
        world.SetContactListener(&m_belt);
        b2Body* floor =
            Body(drive == Drive::Platform ? b2_kinematicBody : b2_staticBody, 0.0f, 0.0f);
        Box(*floor, 14.0f, 0.5f, 0.0f, b2Vec2(0.0f, -0.5f));
        Box(*Body(b2_staticBody, 0.0f, 0.0f), 0.5f, 3.0f, 0.0f, b2Vec2(-10.5f, 3.1f));
        Box(*Body(b2_staticBody, 0.0f, 0.0f), 0.5f, 3.0f, 0.0f, b2Vec2(10.5f, 3.1f));
        for (int i = 0; i < 20; ++i)
        {
            b2Body* box = Body(b2_dynamicBody, -2.0f + Random(4.0f), 0.5f + 0.65f * float32(i));
            Box(*box, 0.3f, 0.3f, (Random(1.0f) < 0.3f ? 20.0f : 5.0f) / 0.36f, b2Vec2_zero);
            boxes.push_back(box);
        }
        if (drive == Drive::Platform)
        {
            floor->SetLinearVelocity(b2Vec2(0.01f, 0.0f));
        }
    }

    double Energy() const
    {
        double energy = 0.0; // [J]
        for (const b2Body* box : boxes)
        {
            const double speed = box->GetAngularVelocity();
            energy += box->GetMass() * (0.5 * double(box->GetLinearVelocity().LengthSquared()) +
                                        10.0 * double(box->GetPosition().y)) +
                      0.5 * box->GetInertia() * speed * speed;
        }
        return energy;
    }

    std::vector<b2Body*> boxes;

private:
    struct Belt : b2ContactListener
    {
        explicit Belt(bool moves) : runs(moves) {}
        void PreSolve(b2Contact* contact, const b2Manifold*) override
        {
            const bool onFloor = contact->GetFixtureA()->GetBody()->GetType() == b2_staticBody ||
                                 contact->GetFixtureB()->GetBody()->GetType() == b2_staticBody;
            contact->SetTangentSpeed(runs && onFloor ? 0.01f : 0.0f);
        }
        bool runs;
    };

    float32 Random(float32 below) { return below * float32(m_random()) / 4294967296.0f; }

    static void Box(b2Body& body, float32 halfWidth, float32 halfHeight, float32 density,
                    const b2Vec2& at)
    {
        b2PolygonShape shape;
        shape.SetAsBox(halfWidth, halfHeight, at, 0.0f);
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.density = density;
        fixture.friction = 0.5f;
        body.CreateFixture(&fixture);
    }

    std::mt19937 m_random;
    Belt m_belt;
};

/// What moves at 1 cm/s can supply next to nothing. When it exempted the heap, energies grew to
/// four times those at the start.
TEST_P(WarmStartGuard, LetsSlowPlatformsAndBeltsAddNoEnergy)
{
    for (const Drive drive : {Drive::Platform, Drive::Belt})
    {
        for (unsigned seed = 0; seed < 40; ++seed)
        {
            DrivenHeap heap(seed, GetParam(), drive);
            heap.Step();
            const double first = heap.Energy();
            double maximum = first;
            for (int i = 0; i < 240; ++i)
            {
                heap.Step();
                maximum = std::max(maximum, heap.Energy());
            }
            EXPECT_LT(maximum, 1.001 * first) << "drive " << int(drive) << ", heap " << seed;
        }
    }
}

} // namespace
