// SPDX-License-Identifier: MIT
#include "RubeBuilder.h"

namespace boxreel
{

namespace
{

constexpr std::size_t kMostFindings = 1000; ///< nobody reads more, and memory stays bounded

// Names come from the file: long ones would drown the message, control characters could garble the
// terminal. Bytes of other scripts pass; a name is cut between characters only.
std::string Quoted(const std::string& name)
{
    constexpr std::size_t kMost = 60;
    std::size_t length = name.size();
    if (length > kMost)
    {
        length = kMost;
        while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xC0) == 0x80)
        {
            --length;
        }
    }
    std::string result = "\"";
    result.append(name, 0, length);
    for (char& c : result)
    {
        const unsigned char byte = static_cast<unsigned char>(c);
        c = byte < 0x20 || byte == 0x7F ? '?' : c;
    }
    return result + (length < name.size() ? "...\"" : "\"");
}

// Vertices closer to the one before than the engine can tell apart add nothing but asserts.
std::vector<b2Vec2> WithoutRepeats(const std::vector<b2Vec2>& vertices)
{
    std::vector<b2Vec2> kept;
    for (const b2Vec2& vertex : vertices)
    {
        if (kept.empty() || b2Distance(kept.back(), vertex) > b2_linearSlop)
        {
            kept.push_back(vertex);
        }
    }
    return kept;
}

class Builder
{
public:
    Builder(const RubeScene& scene, b2World& world, std::vector<std::string>& leftOut)
        : m_scene(scene), m_world(world), m_leftOut(leftOut)
    {}

    void Build()
    {
        ApplyWorldSettings();
        for (const RubeBody& body : m_scene.bodies)
        {
            BuildBody(body);
        }
        for (std::size_t i = 0; i < m_scene.joints.size(); ++i)
        {
            BuildJoint(m_scene.joints[i], i);
        }
        if (m_findings > kMostFindings)
        {
            m_leftOut.push_back("And so are " + std::to_string(m_findings - kMostFindings) +
                                " more parts.");
        }
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

    void Report(const std::string& sentence)
    {
        if (++m_findings <= kMostFindings)
        {
            m_leftOut.push_back(sentence + ".");
        }
    }

    std::string NameOfBody(std::size_t index) const
    {
        return "body " + std::to_string(index) + " " + Quoted(m_scene.bodies[index].name);
    }

    // ---- Bodies and fixtures

    void BuildBody(const RubeBody& source)
    {
        b2BodyDef definition;
        definition.type = source.type;
        definition.position = source.position;
        definition.angle = source.angle;
        definition.linearVelocity = source.linearVelocity;
        definition.angularVelocity = source.angularVelocity;
        definition.linearDamping = source.linearDamping;
        definition.angularDamping = source.angularDamping;
        definition.gravityScale = source.gravityScale;
        definition.bullet = source.isBullet;
        definition.allowSleep = source.allowSleep;
        definition.awake = source.isAwake;
        definition.active = source.isActive;
        definition.fixedRotation = source.fixedRotation;
        b2Body* body = m_world.CreateBody(&definition);
        m_bodies.push_back(body);

        for (std::size_t i = 0; i < source.fixtures.size(); ++i)
        {
            const std::string why = BuildFixture(source.fixtures[i], *body);
            if (!why.empty())
            {
                Report("fixture " + std::to_string(i) + " " + Quoted(source.fixtures[i].name) +
                       " of " + NameOfBody(m_bodies.size() - 1) + " is left out: " + why);
            }
        }
        if (source.massData && source.type == b2_dynamicBody)
        {
            ApplyMassData(*source.massData, *body);
        }
    }

    // The inertia is about the body's origin; what is left about the centre of mass must be
    // positive.
    void ApplyMassData(const b2MassData& data, b2Body& body)
    {
        const float32 ofCenter = data.mass * data.center.LengthSquared();
        if (data.I > 0.0f && !(data.I > ofCenter))
        {
            Report("the mass of " + NameOfBody(m_bodies.size() - 1) +
                   " is left out: its inertia is too small for a centre of mass so far from the "
                   "origin");
            return;
        }
        body.SetMassData(&data);
    }

    /// Empty when built, else the reason why it was not.
    std::string BuildFixture(const RubeFixture& source, b2Body& body)
    {
        const auto attach = [&](const b2Shape& shape) { Attach(source, shape, body); };
        if (const auto* circle = std::get_if<RubeCircle>(&source.shape))
        {
            return BuildCircle(*circle, attach);
        }
        if (const auto* edge = std::get_if<RubeEdge>(&source.shape))
        {
            return BuildEdge(*edge, attach);
        }
        if (const auto* chain = std::get_if<RubeChain>(&source.shape))
        {
            return BuildChain(*chain, attach);
        }
        if (const auto* polygon = std::get_if<RubePolygon>(&source.shape))
        {
            return BuildPolygon(*polygon, attach);
        }
        return "it has no circle, edge, chain, loop or polygon";
    }

    static void Attach(const RubeFixture& source, const b2Shape& shape, b2Body& body)
    {
        b2FixtureDef definition;
        definition.shape = &shape;
        definition.friction = source.friction;
        definition.restitution = source.restitution;
        definition.density = source.density;
        definition.isSensor = source.isSensor;
        definition.filter.categoryBits = source.categoryBits;
        definition.filter.maskBits = source.maskBits;
        definition.filter.groupIndex = source.groupIndex;
        body.CreateFixture(&definition);
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
        if (!(b2Distance(edge.vertex1, edge.vertex2) > b2_linearSlop))
        {
            return "the ends of the edge lie on each other";
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
        if (vertices.size() > 3 && b2Distance(vertices.front(), vertices.back()) <= b2_linearSlop)
        {
            vertices.pop_back();
            isLoop = true;
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
        if (count < 2 || count > static_cast<std::size_t>(b2_maxPolygonVertices))
        {
            return "a polygon has 3 to " + std::to_string(b2_maxPolygonVertices) +
                   " vertices, this one has " + std::to_string(count);
        }
        const int32 asInt = static_cast<int32>(count);
        if (const char* why = b2PolygonShape::WhyNotConvex(polygon.vertices.data(), asInt))
        {
            return std::string("the engine says of its vertices: ") + why;
        }
        b2PolygonShape shape;
        shape.Set(polygon.vertices.data(), asInt);
        attach(shape);
        return "";
    }

    // ---- Joints

    void BuildJoint(const RubeJoint& source, std::size_t index)
    {
        const std::string who = "joint " + std::to_string(index) + " " + Quoted(source.name) +
                                " (" + Shown(source.type) + ", between " +
                                NameOfBody(source.bodyA) + " and " + NameOfBody(source.bodyB) + ")";
        if (source.bodyA == source.bodyB)
        {
            Report(who + " is left out: it connects a body with itself");
        }
        else if (const auto* revolute = std::get_if<RubeRevolute>(&source.details))
        {
            BuildRevolute(source, *revolute, who);
        }
        else if (const auto* distance = std::get_if<RubeDistance>(&source.details))
        {
            BuildDistance(source, *distance, who);
        }
        else if (const auto* prismatic = std::get_if<RubePrismatic>(&source.details))
        {
            BuildPrismatic(source, *prismatic, who);
        }
        else
        {
            Report(who + " is left out: joints of this kind cannot be built");
        }
    }

    // The kind without the quotes that a name has.
    static std::string Shown(const std::string& type)
    {
        const std::string quoted = Quoted(type);
        return type.empty() ? "no kind" : quoted.substr(1, quoted.size() - 2);
    }

    void FillCommon(const RubeJoint& source, b2JointDef& definition)
    {
        definition.bodyA = m_bodies[source.bodyA];
        definition.bodyB = m_bodies[source.bodyB];
        definition.collideConnected = source.collideConnected;
    }

    void BuildRevolute(const RubeJoint& source, const RubeRevolute& revolute,
                       const std::string& who)
    {
        b2RevoluteJointDef definition;
        FillCommon(source, definition);
        definition.localAnchorA = source.anchorA;
        definition.localAnchorB = source.anchorB;
        definition.referenceAngle = revolute.referenceAngle;
        if (revolute.lowerLimit <= revolute.upperLimit)
        {
            definition.enableLimit = revolute.enableLimit;
            definition.lowerAngle = revolute.lowerLimit;
            definition.upperAngle = revolute.upperLimit;
        }
        else
        {
            ReportLimit(who);
        }
        definition.enableMotor = revolute.enableMotor;
        definition.motorSpeed = revolute.motorSpeed;
        definition.maxMotorTorque = revolute.maxMotorTorque;
        m_world.CreateJoint(&definition);
    }

    void BuildPrismatic(const RubeJoint& source, const RubePrismatic& prismatic,
                        const std::string& who)
    {
        b2PrismaticJointDef definition;
        FillCommon(source, definition);
        definition.localAnchorA = source.anchorA;
        definition.localAnchorB = source.anchorB;
        definition.localAxisA = prismatic.axis;
        if (!(definition.localAxisA.Normalize() > 0.0f))
        {
            Report(who + " is left out: its axis has no direction");
            return;
        }
        definition.referenceAngle = prismatic.referenceAngle;
        if (prismatic.lowerLimit <= prismatic.upperLimit)
        {
            definition.enableLimit = prismatic.enableLimit;
            definition.lowerTranslation = prismatic.lowerLimit;
            definition.upperTranslation = prismatic.upperLimit;
        }
        else
        {
            ReportLimit(who);
        }
        definition.enableMotor = prismatic.enableMotor;
        definition.motorSpeed = prismatic.motorSpeed;
        definition.maxMotorForce = prismatic.maxMotorForce;
        m_world.CreateJoint(&definition);
    }

    void ReportLimit(const std::string& who)
    {
        Report("the limit of " + who + " is left out: its lower end is above its upper end");
    }

    // The manual warns of short lengths; shorter than the tolerance has no direction at all.
    void BuildDistance(const RubeJoint& source, const RubeDistance& distance,
                       const std::string& who)
    {
        if (distance.length < b2_linearSlop)
        {
            Report(who +
                   " is left out: its length is zero; a revolute joint keeps points together");
            return;
        }
        b2DistanceJointDef definition;
        FillCommon(source, definition);
        definition.localAnchorA = source.anchorA;
        definition.localAnchorB = source.anchorB;
        definition.length = distance.length;
        definition.frequencyHz = distance.frequency;
        definition.dampingRatio = distance.dampingRatio;
        m_world.CreateJoint(&definition);
    }

    const RubeScene& m_scene;
    b2World& m_world;
    std::vector<std::string>& m_leftOut;
    std::size_t m_findings = 0;
    std::vector<b2Body*> m_bodies; ///< in the order of the file
};

} // namespace

void BuildRubeScene(const RubeScene& scene, b2World& world, std::vector<std::string>& leftOut)
{
    Builder(scene, world, leftOut).Build();
}

} // namespace boxreel
