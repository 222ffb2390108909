// SPDX-License-Identifier: MIT
// Our engine, and Debian's Box2D 2.4 when BENCHMARK_BOX2D_24 (its version) is defined: nearly one
// interface.
#include "Sim.h"

#ifdef BENCHMARK_BOX2D_24
#include <box2d/box2d.h>
using float32 = float;
#else
#include <Box2D/Box2D.h>
#endif

#include <vector>

namespace bench
{
namespace
{

/// The nearest hit along a ray.
struct NearestHit : public b2RayCastCallback
{
    float32 ReportFixture(b2Fixture*, const b2Vec2&, const b2Vec2&, float32 at) override
    {
        fraction = at;
        return at;
    }
    float32 fraction = 1.0f;
};

b2Vec2 Vector(double x, double y)
{
    return b2Vec2(float32(x), float32(y));
}

class SimBox2D final : public Sim
{
public:
    explicit SimBox2D(const SimSettings& settings)
        : m_world(Vector(0.0, settings.gravity)), m_settings(settings)
    {
        m_world.SetAllowSleeping(settings.sleep);
#ifndef BENCHMARK_BOX2D_24
        m_world.SetThreadCount(settings.threads);
        m_world.SetSubStepCount(settings.subSteps);
#endif
    }

    BodyId AddBody(const BodySpec& spec) override
    {
        b2BodyDef def;
        def.type = spec.kind == Kind::Static      ? b2_staticBody
                   : spec.kind == Kind::Kinematic ? b2_kinematicBody
                                                  : b2_dynamicBody;
        def.position = Vector(spec.x, spec.y);
        def.angle = float32(spec.angle);
        def.linearVelocity = Vector(spec.vx, spec.vy);
        def.angularVelocity = float32(spec.angularVelocity);
        def.bullet = spec.bullet;
        m_bodies.push_back(m_world.CreateBody(&def));
        return BodyId(m_bodies.size()) - 1;
    }

    void AddBox(BodyId body, double hx, double hy, double cx, double cy,
                const Material& material) override
    {
        b2PolygonShape shape;
        if (cx == 0.0 && cy == 0.0)
        {
            shape.SetAsBox(float32(hx), float32(hy));
        }
        else
        {
            shape.SetAsBox(float32(hx), float32(hy), Vector(cx, cy), 0.0f);
        }
        Add(body, shape, material);
    }

    void AddCircle(BodyId body, double radius, const Material& material) override
    {
        b2CircleShape shape;
        shape.m_radius = float32(radius);
        Add(body, shape, material);
    }

    void AddEdge(BodyId body, double x1, double y1, double x2, double y2,
                 const Material& material) override
    {
        b2EdgeShape shape;
#ifdef BENCHMARK_BOX2D_24
        shape.SetTwoSided(Vector(x1, y1), Vector(x2, y2));
#else
        shape.Set(Vector(x1, y1), Vector(x2, y2));
#endif
        Add(body, shape, material);
    }

    void AddRevolute(BodyId a, BodyId b, double x, double y) override
    {
        b2RevoluteJointDef def;
        def.Initialize(m_bodies[std::size_t(a)], m_bodies[std::size_t(b)], Vector(x, y));
        m_world.CreateJoint(&def);
    }

    void RemoveLastBody() override
    {
        m_world.DestroyBody(m_bodies.back());
        m_bodies.pop_back();
    }

    void Step() override
    {
        m_world.Step(1.0f / float32(m_settings.hz), m_settings.velocityIterations,
                     m_settings.positionIterations);
    }

    double CastRay(double x1, double y1, double x2, double y2) override
    {
        NearestHit nearest;
        m_world.RayCast(&nearest, Vector(x1, y1), Vector(x2, y2));
        return double(nearest.fraction);
    }

    void PutToSleep(BodyId body) override
    {
        m_bodies[std::size_t(body)]->SetAwake(false);
    }

    bool IsAsleep(BodyId body) const override
    {
        return !m_bodies[std::size_t(body)]->IsAwake();
    }

    int BodyCount() const override
    {
        return m_world.GetBodyCount();
    }

    BodyState State(BodyId id) const override
    {
        const b2Body* body = m_bodies[std::size_t(id)];
        const b2Vec2 p = body->GetPosition();
        const b2Vec2 v = body->GetLinearVelocity();
        return BodyState{double(p.x),
                         double(p.y),
                         double(body->GetAngle()),
                         double(v.x),
                         double(v.y),
                         double(body->GetAngularVelocity()),
                         body->GetType() == b2_dynamicBody};
    }

    Touching LookAtContacts() override
    {
        Touching touching;
        for (b2Contact* contact = m_world.GetContactList(); contact; contact = contact->GetNext())
        {
            if (!contact->IsTouching())
            {
                continue;
            }
            touching.pairs += 1.0;
            b2WorldManifold manifold;
            contact->GetWorldManifold(&manifold);
            for (int i = 0; i < contact->GetManifold()->pointCount; ++i)
            {
                touching.AddPoint(double(manifold.separations[i]));
            }
        }
        return touching;
    }

    int Threads() const override
    {
#ifdef BENCHMARK_BOX2D_24
        return 1;
#else
        return m_world.GetThreadCount();
#endif
    }

private:
    void Add(BodyId body, const b2Shape& shape, const Material& material)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = float32(material.density);
        def.friction = float32(material.friction);
        def.restitution = float32(material.restitution);
        def.filter.categoryBits = material.category;
        def.filter.maskBits = material.mask;
        m_bodies[std::size_t(body)]->CreateFixture(&def);
    }

    b2World m_world;
    SimSettings m_settings;
    std::vector<b2Body*> m_bodies;
};

} // namespace

std::string EngineName()
{
#ifdef BENCHMARK_BOX2D_24
    return "Box2D " BENCHMARK_BOX2D_24;
#else
    return "boxreel " BOXREEL_VERSION;
#endif
}

Iterations IterationsOfASubStep(const SimSettings& settings)
{
#ifdef BENCHMARK_BOX2D_24
    return {settings.velocityIterations, settings.positionIterations};
#else
    return {b2IterationsOfASubStep(settings.velocityIterations, settings.subSteps),
            b2IterationsOfASubStep(settings.positionIterations, settings.subSteps)};
#endif
}

int MostSubSteps()
{
#ifdef BENCHMARK_BOX2D_24
    return 1;
#else
    return 64;
#endif
}

std::unique_ptr<Sim> CreateSim(const SimSettings& settings)
{
    return std::make_unique<SimBox2D>(settings);
}

} // namespace bench
