// SPDX-License-Identifier: MIT
#include "DynamicsInvariants.h"
#include "DynamicsScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

/// Thousands of calls of the public interface in random order, after each of which the world's
/// books must balance. Seeded: a failure names the seed and the call.
namespace
{

using namespace dynamics;

class RandomCaller
{
public:
    explicit RandomCaller(unsigned seed) : m_random(seed)
    {
        m_scene.Ground();
        m_bodies.push_back(m_scene.world.GetBodyList());
    }

    /// Makes one call and returns its name.
    const char* Call()
    {
        m_stepped = false;
        switch (Number(0, 21))
        {
        case 0:
        case 1:
            return CreateBody();
        case 2:
            return DestroyBody();
        case 3:
            return CreateFixture();
        case 4:
            return DestroyFixture();
        case 5:
            return CreateJoint();
        case 6:
            return DestroyJoint();
        case 7:
            Body()->SetType(static_cast<b2BodyType>(Number(0, 2)));
            return "SetType";
        case 8:
            Body()->SetActive(Number(0, 2) > 0);
            return "SetActive";
        case 9:
            Body()->SetAwake(Number(0, 1) == 1);
            return "SetAwake";
        case 10:
            Body()->SetTransform(Place(), Real(-3.0f, 3.0f));
            return "SetTransform";
        case 11:
            return ChangeFixture();
        case 12:
            return Push();
        case 13:
            return Change();
        default:
            return Step();
        }
    }

    std::string WhyBroken() { return dynamics::WhyBroken(m_scene.world, m_stepped); }

private:
    int Number(int low, int high) { return low + int(m_random() % unsigned(high - low + 1)); }
    float32 Real(float32 low, float32 high)
    {
        return low + (high - low) * float32(m_random() % 10001u) / 10000.0f;
    }
    b2Vec2 Place() { return b2Vec2(Real(-4.0f, 4.0f), Real(-1.0f, 5.0f)); }
    b2Body* Body() { return m_bodies[std::size_t(Number(0, int(m_bodies.size()) - 1))]; }

    // A step that takes no time, or ends what sub-stepping began, does not wake along joints.
    const char* Step()
    {
        const bool takesTime = Number(0, 9) > 0;
        m_scene.world.Step(takesTime ? kStep : 0.0f, 4, 2);
        m_stepped = takesTime && !m_subStepped;
        m_subStepped = m_scene.world.GetSubStepping() || (m_subStepped && !takesTime);
        return "Step";
    }

    const char* CreateBody()
    {
        if (m_bodies.size() > 30)
        {
            return DestroyBody();
        }
        b2BodyDef def;
        def.type = static_cast<b2BodyType>(Number(0, 4) > 1 ? 2 : Number(0, 2));
        def.position = Place();
        def.angle = Real(-3.0f, 3.0f);
        def.linearVelocity.Set(Real(-20.0f, 20.0f), Real(-20.0f, 20.0f));
        def.awake = Number(0, 3) > 0;
        def.active = Number(0, 5) > 0;
        def.allowSleep = Number(0, 5) > 0;
        def.bullet = Number(0, 5) == 0;
        def.fixedRotation = Number(0, 9) == 0;
        m_bodies.push_back(m_scene.world.CreateBody(&def));
        AddFixture(m_bodies.back());
        return "CreateBody";
    }

    const char* DestroyBody()
    {
        if (m_bodies.size() > 1)
        {
            const std::size_t which = std::size_t(Number(0, int(m_bodies.size()) - 1));
            m_scene.world.DestroyBody(m_bodies[which]);
            m_bodies.erase(m_bodies.begin() + std::ptrdiff_t(which));
        }
        return "DestroyBody";
    }

    void AddFixture(b2Body* body)
    {
        b2CircleShape circle;
        circle.m_radius = Real(0.1f, 0.6f);
        circle.m_p.Set(Real(-0.3f, 0.3f), 0.0f);
        b2PolygonShape box;
        box.SetAsBox(Real(0.05f, 0.6f), Real(0.05f, 0.6f));
        b2EdgeShape edge;
        edge.Set(b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.2f));
        const b2Vec2 corners[4] = {b2Vec2(-2.0f, 0.5f), b2Vec2(-1.0f, 0.0f), b2Vec2(1.0f, 0.0f),
                                   b2Vec2(2.0f, 0.5f)};
        b2ChainShape chain;
        chain.CreateChain(corners, 4);
        const b2Shape* shapes[] = {&circle, &box, &edge, &chain};
        b2FixtureDef def;
        def.shape = shapes[Number(0, 5) > 1 ? Number(0, 1) : Number(2, 3)];
        def.density = Real(0.0f, 2.0f);
        def.restitution = Real(0.0f, 1.0f);
        def.isSensor = Number(0, 5) == 0;
        def.filter.groupIndex = int16(Number(-1, 1));
        body->CreateFixture(&def);
    }

    const char* CreateFixture()
    {
        b2Body* body = Body();
        if (Count(body) < 3)
        {
            AddFixture(body);
        }
        return "CreateFixture";
    }

    static int Count(b2Body* body)
    {
        int count = 0;
        for (b2Fixture* f = body->GetFixtureList(); f; f = f->GetNext())
        {
            ++count;
        }
        return count;
    }

    b2Fixture* Fixture()
    {
        b2Body* body = Body();
        b2Fixture* fixture = body->GetFixtureList();
        for (int skip = Number(0, 2); fixture && fixture->GetNext() && skip > 0; --skip)
        {
            fixture = fixture->GetNext();
        }
        return fixture;
    }

    const char* DestroyFixture()
    {
        if (b2Fixture* fixture = Fixture())
        {
            fixture->GetBody()->DestroyFixture(fixture);
        }
        return "DestroyFixture";
    }

    const char* ChangeFixture()
    {
        if (b2Fixture* fixture = Fixture())
        {
            if (Number(0, 1) == 0)
            {
                fixture->SetSensor(Number(0, 1) == 1);
                return "SetSensor";
            }
            b2Filter filter;
            filter.groupIndex = int16(Number(-1, 1));
            fixture->SetFilterData(filter);
        }
        return "SetFilterData";
    }

    const char* CreateJoint()
    {
        b2Body* a = Body();
        b2Body* b = Body();
        if (a == b || m_scene.world.GetJointCount() > 20)
        {
            return "nothing";
        }
        if (Number(0, 1) == 0)
        {
            b2RevoluteJointDef def;
            def.Initialize(a, b, 0.5f * (a->GetPosition() + b->GetPosition()));
            def.collideConnected = Number(0, 1) == 1;
            def.enableMotor = Number(0, 1) == 1;
            def.motorSpeed = 5.0f;
            def.maxMotorTorque = 10.0f;
            m_scene.world.CreateJoint(&def);
            return "CreateJoint (revolute)";
        }
        b2DistanceJointDef def;
        def.Initialize(a, b, a->GetPosition(), b->GetPosition());
        def.collideConnected = Number(0, 1) == 1;
        def.frequencyHz = Number(0, 1) == 0 ? 0.0f : 3.0f;
        m_scene.world.CreateJoint(&def);
        return "CreateJoint (distance)";
    }

    const char* DestroyJoint()
    {
        b2Joint* joint = m_scene.world.GetJointList();
        for (int skip = Number(0, 5); joint && joint->GetNext() && skip > 0; --skip)
        {
            joint = joint->GetNext();
        }
        if (joint)
        {
            m_scene.world.DestroyJoint(joint);
        }
        return "DestroyJoint";
    }

    const char* Push()
    {
        b2Body* body = Body();
        const bool wake = Number(0, 1) == 1;
        switch (Number(0, 3))
        {
        case 0:
            body->ApplyForce(b2Vec2(Real(-50.0f, 50.0f), 50.0f), Place(), wake);
            return "ApplyForce";
        case 1:
            body->ApplyLinearImpulse(b2Vec2(Real(-5.0f, 5.0f), 5.0f), Place(), wake);
            return "ApplyLinearImpulse";
        case 2:
            body->SetLinearVelocity(b2Vec2(Real(-90.0f, 90.0f), Real(-90.0f, 90.0f)));
            return "SetLinearVelocity";
        default:
            body->SetAngularVelocity(Real(-50.0f, 50.0f));
            return "SetAngularVelocity";
        }
    }

    const char* Change()
    {
        b2World& world = m_scene.world;
        switch (Number(0, 6))
        {
        case 0:
            world.SetAllowSleeping(Number(0, 2) > 0);
            return "SetAllowSleeping";
        case 1:
            world.SetSubStepping(Number(0, 2) == 0);
            return "SetSubStepping";
        case 2:
            world.SetWarmStarting(Number(0, 2) > 0);
            return "SetWarmStarting";
        case 3:
            Body()->SetFixedRotation(Number(0, 1) == 1);
            return "SetFixedRotation";
        case 4:
            Body()->ResetMassData();
            return "ResetMassData";
        case 5:
            Body()->SetSleepingAllowed(Number(0, 2) > 0);
            return "SetSleepingAllowed";
        default:
            world.ShiftOrigin(b2Vec2(0.0f, 0.0f));
            return "ShiftOrigin";
        }
    }

    std::mt19937 m_random;
    Scene m_scene;
    std::vector<b2Body*> m_bodies;
    bool m_stepped = false;
    bool m_subStepped = false;
};

TEST(DynamicsRandomCalls, KeepTheBooksOfTheWorldInOrder)
{
    for (unsigned seed = 1; seed <= 40; ++seed)
    {
        RandomCaller caller(seed);
        for (int call = 0; call < 600; ++call)
        {
            const char* name = caller.Call();
            const std::string why = caller.WhyBroken();
            ASSERT_EQ(why, "") << "seed " << seed << ", call " << call << ": " << name;
        }
    }
}

} // namespace
