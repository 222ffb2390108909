// SPDX-License-Identifier: MIT
#include "Sim.h"

#include <chipmunk/chipmunk.h>

#include <cstdio>
#include <vector>

namespace bench
{
namespace
{

cpVect Vector(double x, double y)
{
    return cpv(cpFloat(x), cpFloat(y));
}

/// Chipmunk takes the product of two frictions and of two restitutions; the square root makes those
/// of two equal materials theirs.
double Share(double coefficient)
{
    return cpfsqrt(coefficient);
}

/// Debian's build warns in every step of some scenes, which would add to the time. Call it before
/// the first space is created, which also warns.
cpSpace* MakeQuietSpace()
{
    static const bool quiet = std::freopen("/dev/null", "w", stderr) != nullptr;
    return quiet ? cpSpaceNew() : nullptr;
}

class SimChipmunk final : public Sim
{
public:
    explicit SimChipmunk(const SimSettings& settings)
        : m_space(MakeQuietSpace()), m_step(1.0 / settings.hz)
    {
        cpSpaceSetIterations(m_space, IterationsOfASubStep(settings).velocity);
        cpSpaceSetGravity(m_space, Vector(0.0, settings.gravity));
        if (settings.sleep)
        {
            cpSpaceSetSleepTimeThreshold(m_space, 0.5);
        }
    }
    ~SimChipmunk() override
    {
        while (!m_bodies.empty())
        {
            RemoveLastBody();
        }
        for (cpConstraint* joint : m_joints)
        {
            cpSpaceRemoveConstraint(m_space, joint);
            cpConstraintFree(joint);
        }
        cpSpaceFree(m_space);
    }
    SimChipmunk(const SimChipmunk&) = delete;
    SimChipmunk& operator=(const SimChipmunk&) = delete;

    BodyId AddBody(const BodySpec& spec) override
    {
        cpBody* body = spec.kind == Kind::Static      ? cpBodyNewStatic()
                       : spec.kind == Kind::Kinematic ? cpBodyNewKinematic()
                                                      : cpBodyNew(0.0, 0.0);
        cpBodySetPosition(body, Vector(spec.x, spec.y));
        cpBodySetAngle(body, spec.angle);
        if (spec.kind != Kind::Static)
        {
            cpBodySetVelocity(body, Vector(spec.vx, spec.vy));
            cpBodySetAngularVelocity(body, spec.angularVelocity);
        }
        cpSpaceAddBody(m_space, body);
        m_bodies.push_back(body);
        m_shapes.emplace_back();
        return BodyId(m_bodies.size()) - 1;
    }

    void AddBox(BodyId id, double hx, double hy, double cx, double cy,
                const Material& material) override
    {
        const cpBB box = cpBBNew(cx - hx, cy - hy, cx + hx, cy + hy);
        Add(id, cpBoxShapeNew2(m_bodies[std::size_t(id)], box, 0.0), 4.0 * hx * hy, material);
    }

    void AddCircle(BodyId id, double radius, const Material& material) override
    {
        cpShape* shape = cpCircleShapeNew(m_bodies[std::size_t(id)], radius, cpvzero);
        Add(id, shape, CP_PI * radius * radius, material);
    }

    void AddEdge(BodyId id, double x1, double y1, double x2, double y2,
                 const Material& material) override
    {
        cpShape* shape =
            cpSegmentShapeNew(m_bodies[std::size_t(id)], Vector(x1, y1), Vector(x2, y2), 0.0);
        Add(id, shape, 0.0, material);
    }

    void AddRevolute(BodyId a, BodyId b, double x, double y) override
    {
        cpConstraint* joint =
            cpPivotJointNew(m_bodies[std::size_t(a)], m_bodies[std::size_t(b)], Vector(x, y));
        cpConstraintSetCollideBodies(joint, cpFalse);
        m_joints.push_back(cpSpaceAddConstraint(m_space, joint));
    }

    void RemoveLastBody() override
    {
        for (cpShape* shape : m_shapes.back())
        {
            cpSpaceRemoveShape(m_space, shape);
            cpShapeFree(shape);
        }
        m_shapes.pop_back();
        cpSpaceRemoveBody(m_space, m_bodies.back());
        cpBodyFree(m_bodies.back());
        m_bodies.pop_back();
    }

    void Step() override { cpSpaceStep(m_space, m_step); }

    double CastRay(double x1, double y1, double x2, double y2) override
    {
        cpSegmentQueryInfo info;
        const cpShape* hit = cpSpaceSegmentQueryFirst(m_space, Vector(x1, y1), Vector(x2, y2), 0.0,
                                                      CP_SHAPE_FILTER_ALL, &info);
        return hit ? info.alpha : 1.0;
    }

    void PutToSleep(BodyId body) override { cpBodySleep(m_bodies[std::size_t(body)]); }

    bool IsAsleep(BodyId body) const override
    {
        return cpBodyIsSleeping(m_bodies[std::size_t(body)]);
    }

    int BodyCount() const override { return int(m_bodies.size()); }

    BodyState State(BodyId id) const override
    {
        cpBody* body = m_bodies[std::size_t(id)];
        const cpVect p = cpBodyGetPosition(body);
        const cpVect v = cpBodyGetVelocity(body);
        return BodyState{p.x,
                         p.y,
                         cpBodyGetAngle(body),
                         v.x,
                         v.y,
                         cpBodyGetAngularVelocity(body),
                         cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC};
    }

    Touching LookAtContacts() override
    {
        Touching touching;
        for (cpBody* body : m_bodies)
        {
            if (cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC)
            {
                cpBodyEachArbiter(body, AddArbiter, &touching);
            }
        }
        return touching;
    }

    int Threads() const override { return 1; }

private:
    /// Two bodies that move both tell of their pair.
    static void AddArbiter(cpBody* self, cpArbiter* arbiter, void* touching)
    {
        cpBody *a = nullptr, *b = nullptr;
        cpArbiterGetBodies(arbiter, &a, &b);
        const bool isTwice = cpBodyGetType(a == self ? b : a) == CP_BODY_TYPE_DYNAMIC;
        const double weight = isTwice ? 0.5 : 1.0;
        auto& target = *static_cast<Touching*>(touching);
        target.pairs += weight;
        for (int i = 0; i < cpArbiterGetCount(arbiter); ++i)
        {
            target.AddPoint(cpArbiterGetDepth(arbiter, i), weight);
        }
    }

    void Add(BodyId id, cpShape* shape, double area, const Material& material)
    {
        cpShapeSetFriction(shape, Share(material.friction));
        cpShapeSetElasticity(shape, Share(material.restitution));
        cpShapeSetFilter(shape, cpShapeFilterNew(CP_NO_GROUP, material.category, material.mask));
        if (area > 0.0 && cpBodyGetType(m_bodies[std::size_t(id)]) == CP_BODY_TYPE_DYNAMIC)
        {
            cpShapeSetDensity(shape, material.density);
        }
        cpSpaceAddShape(m_space, shape);
        m_shapes[std::size_t(id)].push_back(shape);
    }

    cpSpace* m_space;
    double m_step; ///< [s]
    std::vector<cpBody*> m_bodies;
    std::vector<std::vector<cpShape*>> m_shapes; ///< by body
    std::vector<cpConstraint*> m_joints;
};

} // namespace

std::string EngineName()
{
    return std::string("Chipmunk ") + cpVersionString;
}

Iterations IterationsOfASubStep(const SimSettings& settings)
{
    return {(settings.velocityIterations * 10 + 4) / 8, 0};
}

int MostSubSteps()
{
    return 1;
}

std::unique_ptr<Sim> CreateSim(const SimSettings& settings)
{
    return std::make_unique<SimChipmunk>(settings);
}

} // namespace bench
