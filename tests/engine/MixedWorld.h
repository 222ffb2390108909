// SPDX-License-Identifier: MIT
#pragma once

#include <Box2D/Box2D.h>

#include <random>
#include <vector>

/// A random world, made from a number, with everything that can be drawn. It has all shapes, bodies
/// with many fixtures, long chains, and static, kinematic, sleeping and inactive bodies. Joints of
/// all kinds connect bodies at any distance. It spans about 80 m.
class MixedWorld
{
public:
    explicit MixedWorld(unsigned seed) : m_random(seed), world(b2Vec2(0.0f, -10.0f))
    {
        const int count = 30 + Below(40);
        for (int i = 0; i < count; ++i)
        {
            AddBody();
        }
        AddJoints();
        steps = Below(3) * 20;
        for (int i = 0; i < steps; ++i)
        {
            world.Step(1.0f / 60.0f, 8, 3);
        }
        Disturb();
    }

    /// 0 to count - 1.
    int Below(int count) { return int(m_random() % unsigned(count)); }
    float32 Between(float32 lower, float32 upper)
    {
        return lower + (upper - lower) * float32(m_random() % 65536u) / 65536.0f;
    }
    b2Vec2 Place() { return b2Vec2(Between(-40.0f, 40.0f), Between(-40.0f, 40.0f)); }

private:
    std::mt19937 m_random;
    std::vector<b2Body*> m_bodies;

public:
    b2World world;
    int steps = 0; ///< simulated so far

private:
    void AddFixture(b2Body& body)
    {
        const b2Vec2 place(Between(-2.0f, 2.0f), Between(-2.0f, 2.0f));
        const int kind = Below(8);
        if (kind < 3)
        {
            b2CircleShape circle;
            circle.m_p = place;
            circle.m_radius = Between(0.05f, 1.0f);
            body.CreateFixture(&circle, 1.0f);
        }
        else if (kind < 6)
        {
            b2PolygonShape box;
            box.SetAsBox(Between(0.05f, 1.0f), Between(0.05f, 1.0f), place, Between(0.0f, 3.0f));
            body.CreateFixture(&box, 1.0f);
        }
        else if (kind == 6)
        {
            b2EdgeShape edge;
            edge.Set(place, place + b2Vec2(Between(1.0f, 9.0f), Between(-5.0f, 5.0f)));
            body.CreateFixture(&edge, 1.0f);
        }
        else
        {
            std::vector<b2Vec2> points;
            for (int i = 0; i < 20; ++i)
            {
                points.push_back(b2Vec2(2.0f * float32(i) - 20.0f, Between(-1.0f, 1.0f)));
            }
            b2ChainShape chain;
            chain.CreateChain(points.data(), int32(points.size()));
            body.CreateFixture(&chain, 1.0f);
        }
    }

    void AddBody()
    {
        b2BodyDef definition;
        definition.type = static_cast<b2BodyType>(Below(3));
        definition.position = Place();
        definition.angle = Between(-3.0f, 3.0f);
        definition.linearVelocity.Set(Between(-5.0f, 5.0f), Between(-5.0f, 5.0f));
        definition.active = Below(6) > 0;
        definition.awake = Below(4) > 0;
        definition.bullet = Below(10) == 0;
        m_bodies.push_back(world.CreateBody(&definition));
        for (int i = Below(3) == 0 ? 12 : Below(3); i > 0; --i)
        {
            AddFixture(*m_bodies.back());
        }
    }

    b2Body* SomeBody() { return m_bodies[std::size_t(Below(int(m_bodies.size())))]; }

    template <class Definition>
    b2Joint* Join(Definition definition, b2Body* a, b2Body* b)
    {
        definition.bodyA = a;
        definition.bodyB = b;
        return world.CreateJoint(&definition);
    }

    void AddJoints()
    {
        for (int i = 0; i < 40; ++i)
        {
            b2Body* const a = SomeBody();
            b2Body* const b = SomeBody();
            if (a != b)
            {
                AddJoint(Below(10), a, b);
            }
        }
    }

    void AddJoint(int kind, b2Body* a, b2Body* b)
    {
        const b2Vec2 pa = a->GetPosition();
        const b2Vec2 pb = b->GetPosition();
        b2RevoluteJointDef revolute;
        revolute.Initialize(a, b, 0.5f * (pa + pb));
        revolute.enableMotor = Below(2) == 0;
        revolute.maxMotorTorque = 1.0f;
        revolute.motorSpeed = Between(-1.0f, 1.0f);
        b2PrismaticJointDef prismatic;
        prismatic.Initialize(a, b, pb, b2Vec2(0.6f, 0.8f));
        prismatic.enableLimit = Below(2) == 0;
        prismatic.lowerTranslation = -Between(0.0f, 9.0f);
        prismatic.upperTranslation = Between(0.0f, 9.0f);
        prismatic.enableMotor = Below(2) == 0;
        b2DistanceJointDef distance;
        distance.Initialize(a, b, pa, pb);
        distance.frequencyHz = Below(2) == 0 ? 0.0f : 2.0f;
        b2PulleyJointDef pulley;
        pulley.Initialize(a, b, pa + b2Vec2(0.0f, 9.0f), pb + b2Vec2(0.0f, 9.0f), pa, pb, 1.0f);
        b2WheelJointDef wheel;
        wheel.Initialize(a, b, pb, b2Vec2(0.0f, 1.0f));
        b2WeldJointDef weld;
        weld.Initialize(a, b, 0.5f * (pa + pb));
        b2RopeJointDef rope;
        rope.maxLength = (pb - pa).Length() * Between(0.8f, 1.5f) + 0.5f;
        b2FrictionJointDef friction;
        friction.Initialize(a, b, pb);
        b2MouseJointDef mouse;
        mouse.target = pb;
        mouse.maxForce = 1.0f;
        b2MotorJointDef motor;
        motor.Initialize(a, b);
        switch (kind)
        {
        case 0:
            Join(revolute, a, b);
            break;
        case 1:
            Join(prismatic, a, b);
            break;
        case 2:
            Join(distance, a, b);
            break;
        case 3:
            Join(pulley, a, b);
            break;
        case 4:
            Join(wheel, a, b);
            break;
        case 5:
            Join(weld, a, b);
            break;
        case 6:
            Join(rope, a, b);
            break;
        case 7:
            Join(friction, a, b);
            break;
        case 8:
            Join(mouse, a, b);
            break;
        default:
            Join(motor, a, b);
            break;
        }
    }

    /// Makes changes that lists of bodies and boxes have to follow.
    void Disturb()
    {
        for (int i = 0; i < 10; ++i)
        {
            SomeBody()->SetActive(Below(2) == 0);
            SomeBody()->SetTransform(Place(), Between(-3.0f, 3.0f));
            SomeBody()->SetAwake(false);
        }
        world.DestroyBody(m_bodies.back());
        m_bodies.pop_back();
    }
};
