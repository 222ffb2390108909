// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

/// Functions that compare worlds in the tests of snapshots.
namespace snapshots
{

typedef std::vector<uint8> Bytes;

/// Returns the poses and velocities of all bodies as bits, newest first.
inline std::vector<std::uint32_t> StateOf(const b2World& world)
{
    std::vector<std::uint32_t> state;
    for (const b2Body* body = world.GetBodyList(); body; body = body->GetNext())
    {
        for (const float32 number :
             {body->GetPosition().x, body->GetPosition().y, body->GetAngle(),
              body->GetLinearVelocity().x, body->GetLinearVelocity().y, body->GetAngularVelocity()})
        {
            state.push_back(std::bit_cast<std::uint32_t>(number));
        }
    }
    return state;
}

/// Records every call of a listener, in order.
class EventLog : public b2ContactListener
{
public:
    void BeginContact(b2Contact* contact) override { Note(1, *contact); }
    void EndContact(b2Contact* contact) override { Note(2, *contact); }
    void PreSolve(b2Contact* contact, const b2Manifold* old) override
    {
        Note(3, *contact);
        events.push_back(std::uint64_t(old->pointCount));
    }
    void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override
    {
        Note(4, *contact);
        for (int32 i = 0; i < impulse->count; ++i)
        {
            events.push_back(std::bit_cast<std::uint32_t>(impulse->normalImpulses[i]));
            events.push_back(std::bit_cast<std::uint32_t>(impulse->tangentImpulses[i]));
        }
    }

    std::vector<std::uint64_t> events;

private:
    void Note(std::uint64_t kind, b2Contact& contact)
    {
        const auto a = std::uint64_t(contact.GetFixtureA()->GetBody()->GetNumber());
        const auto b = std::uint64_t(contact.GetFixtureB()->GetBody()->GetNumber());
        events.push_back(kind << 60 | a << 40 | b << 20 | std::uint64_t(contact.GetChildIndexA()));
        events.push_back(std::uint64_t(contact.GetChildIndexB()));
    }
};

struct Steps
{
    int count = 200;
    float32 lengths[2] = {1.0f / 60.0f, 1.0f / 60.0f}; ///< [s], in turn
    int first = 0;                                     ///< of the next step: which length
    bool events = true;
};

inline void ExpectRestored(b2World& world, const Bytes& bytes)
{
    const char* why = b2RestoreSnapshot(world, bytes);
    EXPECT_EQ(why, nullptr) << why;
}

/// Steps both worlds and has them be the same: every body after every step, all events, and now and
/// then all that a snapshot holds. `meddle(world, step)` comes before each step.
template <class Meddle>
void ExpectSameWay(b2World& one, b2World& another, const Steps& steps, Meddle&& meddle)
{
    EventLog logs[2];
    if (steps.events)
    {
        one.SetContactListener(&logs[0]);
        another.SetContactListener(&logs[1]);
    }
    for (int i = 0; i < steps.count && !testing::Test::HasFailure(); ++i)
    {
        for (b2World* world : {&one, &another})
        {
            meddle(*world, i);
            world->Step(steps.lengths[(steps.first + i) % 2], 8, 3);
        }
        ASSERT_TRUE(StateOf(one) == StateOf(another)) << "after step " << i;
        ASSERT_EQ(logs[0].events, logs[1].events) << "in step " << i;
        if (i % 20 == 0 || i + 1 == steps.count)
        {
            ASSERT_TRUE(b2SaveSnapshot(one) == b2SaveSnapshot(another)) << "after step " << i;
        }
        logs[0].events.clear();
        logs[1].events.clear();
    }
    one.SetContactListener(nullptr);
    another.SetContactListener(nullptr);
}

inline void ExpectSameWay(b2World& one, b2World& another, const Steps& steps = {})
{
    ExpectSameWay(one, another, steps, [](b2World&, int) {});
}

inline b2Body* BodyAt(b2World& world, int place)
{
    b2Body* body = world.GetBodyList();
    for (int i = 0; i < place && body; ++i)
    {
        body = body->GetNext();
    }
    return body;
}

inline b2Joint* JointAt(b2World& world, int place)
{
    b2Joint* joint = world.GetJointList();
    for (int i = 0; i < place && joint; ++i)
    {
        joint = joint->GetNext();
    }
    return joint;
}

} // namespace snapshots
