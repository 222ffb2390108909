// SPDX-License-Identifier: MIT
#include "RubeBuilder.h"

#include "RubeJoints.h"
#include "RubeNames.h"
#include "RubePolygons.h"

namespace boxreel
{

namespace
{

/// More of a body are weighed together, not again with each that comes.
constexpr std::size_t kManyFixtures = 100;

/// True if two points have the distance that chains require, with the same rounding.
bool AreApart(const b2Vec2& a, const b2Vec2& b)
{
    return b2DistanceSquared(a, b) > b2_linearSlop * b2_linearSlop;
}

// Omits vertices closer to the previous one than the engine can distinguish, because they cause
// asserts.
std::vector<b2Vec2> WithoutRepeats(const std::vector<b2Vec2>& vertices)
{
    std::vector<b2Vec2> kept;
    for (const b2Vec2& vertex : vertices)
    {
        if (kept.empty() || AreApart(kept.back(), vertex))
        {
            kept.push_back(vertex);
        }
    }
    return kept;
}

class Builder
{
public:
    Builder(const RubeScene& scene, b2World& world, RubeNotes& leftOut)
        : m_scene(scene), m_world(world), m_leftOut(leftOut)
    {}

    std::vector<const b2Joint*> Build()
    {
        ApplyWorldSettings();
        for (const RubeBody& body : m_scene.bodies)
        {
            BuildBody(body);
        }
        return BuildRubeJoints(m_scene, m_bodies, m_world,
                               [this](const RubeNote& note) { LeaveOut(note); });
    }

private:
    void ApplyWorldSettings()
    {
        m_world.SetGravity(m_scene.gravity);
        m_world.SetAllowSleeping(m_scene.allowSleep);
        m_world.SetAutoClearForces(m_scene.autoClearForces);
        m_world.SetWarmStarting(m_scene.warmStarting);
        m_world.SetContinuousPhysics(m_scene.continuousPhysics);
        m_world.SetSubStepping(m_scene.subStepping);
    }

    void LeaveOut(const RubeNote& note) { AddNote(m_leftOut, m_notes, note); }

    // ---- Bodies and fixtures

    void BuildBody(const RubeBody& source)
    {
        b2Body* body = m_world.CreateBody(&source);
        m_bodies.push_back(body);

        m_weighsTogether = source.fixtures.size() > kManyFixtures;
        for (std::size_t i = 0; i < source.fixtures.size(); ++i)
        {
            const std::string why = BuildFixture(source.fixtures[i], *body);
            if (!why.empty())
            {
                LeaveOut({WithName("fixture", i, source.fixtures[i].name) + " of " +
                              NameOfBody(m_scene, m_bodies.size() - 1),
                          why});
            }
        }
        if (m_weighsTogether)
        {
            body->ResetMassData();
        }
        if (source.massData && source.type == b2_dynamicBody)
        {
            ApplyMassData(*source.massData, *body);
        }
        RestoreVelocity(source, *body);
    }

    // It is that of the centre of mass, which has moved with each fixture. Setting it would wake a
    // body that sleeps, so such a one is put to rest.
    static void RestoreVelocity(const RubeBody& source, b2Body& body)
    {
        if (body.IsAwake())
        {
            body.SetLinearVelocity(source.linearVelocity); // the sign of a zero as well
        }
        else if (body.GetType() == b2_dynamicBody &&
                 body.GetLinearVelocity() != source.linearVelocity)
        {
            body.SetAwake(true);
            body.SetAwake(false);
        }
    }

    // The inertia is about the body's origin, and must not become negative about the centre of
    // mass. Values that equal those of the fixtures stay unchanged, to the last bit.
    void ApplyMassData(const b2MassData& data, b2Body& body)
    {
        b2MassData given;
        body.GetMassData(&given);
        if (data.mass == given.mass && data.center == given.center && data.I == given.I)
        {
            return;
        }
        const float32 ofCenter = data.mass * data.center.LengthSquared();
        if (data.I > 0.0f && !(data.I >= ofCenter))
        {
            LeaveOut({"mass of " + NameOfBody(m_scene, m_bodies.size() - 1),
                      "its inertia is too small for a centre of mass so far from the origin"});
            return;
        }
        body.SetMassData(&data);
    }

    /// Returns an empty text if the fixture was built, otherwise the reason why not.
    std::string BuildFixture(const RubeFixture& source, b2Body& body)
    {
        const auto attach = [&](const b2Shape& shape) { Attach(source, shape, body); };
        if (const auto* circle = std::get_if<RubeCircle>(&source.geometry))
        {
            return BuildCircle(*circle, attach);
        }
        if (const auto* edge = std::get_if<RubeEdge>(&source.geometry))
        {
            return BuildEdge(*edge, attach);
        }
        if (const auto* chain = std::get_if<RubeChain>(&source.geometry))
        {
            return BuildChain(*chain, attach);
        }
        if (const auto* polygon = std::get_if<RubePolygon>(&source.geometry))
        {
            return BuildPolygon(*polygon, attach);
        }
        return "it has no circle, edge, chain, loop or polygon";
    }

    void Attach(const RubeFixture& source, const b2Shape& shape, b2Body& body) const
    {
        b2FixtureDef definition(source);
        definition.shape = &shape;
        definition.density = m_weighsTogether ? 0.0f : source.density;
        if (b2Fixture* const fixture = body.CreateFixture(&definition))
        {
            fixture->SetDensity(source.density);
        }
    }

    static std::string BuildCircle(const RubeCircle& circle, const auto& attach)
    {
        if (!(circle.radius > 0.0f))
        {
            return "a circle needs a radius above zero";
        }
        b2CircleShape shape;
        shape.m_radius = circle.radius;
        shape.m_p = circle.center;
        attach(shape);
        return "";
    }

    static std::string BuildEdge(const RubeEdge& edge, const auto& attach)
    {
        if (!AreApart(edge.vertex1, edge.vertex2))
        {
            return "the ends of the edge coincide";
        }
        b2EdgeShape shape;
        shape.Set(edge.vertex1, edge.vertex2);
        shape.m_hasVertex0 = edge.vertex0.has_value();
        shape.m_vertex0 = edge.vertex0.value_or(b2Vec2(0.0f, 0.0f));
        shape.m_hasVertex3 = edge.vertex3.has_value();
        shape.m_vertex3 = edge.vertex3.value_or(b2Vec2(0.0f, 0.0f));
        attach(shape);
        return "";
    }

    static std::string BuildChain(const RubeChain& chain, const auto& attach)
    {
        std::vector<b2Vec2> vertices = WithoutRepeats(chain.vertices);
        bool isLoop = chain.isLoop;
        // A last vertex on the first says the same as a loop, and a loop must not repeat it.
        isLoop = isLoop || (vertices.size() > 3 && !AreApart(vertices.front(), vertices.back()));
        while (isLoop && vertices.size() > 1 && !AreApart(vertices.front(), vertices.back()))
        {
            vertices.pop_back();
        }
        const std::size_t needed = isLoop ? 3 : 2;
        if (vertices.size() < needed)
        {
            return std::string(isLoop ? "a loop" : "a chain") + " needs at least " +
                   std::to_string(needed) + " different vertices";
        }
        b2ChainShape shape;
        if (isLoop)
        {
            shape.CreateLoop(vertices.data(), static_cast<int32>(vertices.size()));
            attach(shape);
            return "";
        }
        shape.CreateChain(vertices.data(), static_cast<int32>(vertices.size()));
        if (chain.previous)
        {
            shape.SetPrevVertex(*chain.previous);
        }
        if (chain.next)
        {
            shape.SetNextVertex(*chain.next);
        }
        attach(shape);
        return "";
    }

    static std::string BuildPolygon(const RubePolygon& polygon, const auto& attach)
    {
        const std::size_t count = polygon.vertices.size();
        if (count == 2)
        {
            return BuildEdge({polygon.vertices[0], polygon.vertices[1], {}, {}}, attach);
        }
        if (count < 2 || count > static_cast<std::size_t>(b2_polygonCapacity))
        {
            return "a polygon must have 3 to " + std::to_string(b2_polygonCapacity) +
                   " vertices, this one has " + std::to_string(count);
        }
        const int32 asInt = static_cast<int32>(count);
        if (const char* why = b2PolygonShape::WhyNotConvex(polygon.vertices.data(), asInt))
        {
            return std::string("the engine refuses its vertices: ") + why;
        }
        b2PolygonShape shape;
        SetPolygon(polygon, shape);
        attach(shape);
        return "";
    }

    const RubeScene& m_scene;
    b2World& m_world;
    RubeNotes& m_leftOut;
    std::size_t m_notes = 0;       ///< with those that are not listed
    bool m_weighsTogether = false; ///< the body that is being built
    std::vector<b2Body*> m_bodies; ///< in the order of the file
};

} // namespace

std::vector<const b2Joint*> BuildRubeScene(const RubeScene& scene, b2World& world,
                                           RubeNotes& leftOut)
{
    return Builder(scene, world, leftOut).Build();
}

} // namespace boxreel
