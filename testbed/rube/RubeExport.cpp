// SPDX-License-Identifier: MIT
#include "RubeExport.h"

#include "RubeBuilder.h"
#include "RubeFields.h"
#include "RubeFile.h"
#include "RubeNames.h"
#include "RubePolygons.h"
#include "RubeText.h"

#include <algorithm>
#include <functional>
#include <map>

namespace boxreel
{

namespace
{

constexpr const char* kNoWord = "scene files cannot contain this";

/// A list of the engine's, which begins with the newest, in the order of creation.
template <class Part>
std::vector<Part*> InOrder(Part* newest)
{
    std::vector<Part*> parts;
    for (Part* part = newest; part != nullptr; part = part->GetNext())
    {
        parts.push_back(part);
    }
    std::reverse(parts.begin(), parts.end());
    return parts;
}

/// Sets the members that VisitFields names to what a part of the engine says.
void Take(auto& said, const auto& part)
{
    VisitFields(said, [&part](const char*, auto& member, const auto&, const auto& getter) {
        if constexpr (!std::is_null_pointer_v<std::decay_t<decltype(getter)>>)
        {
            member = std::invoke(getter, part);
        }
    });
}

// ---- Shapes

RubeEdge EdgeOf(const b2EdgeShape& shape)
{
    RubeEdge edge{shape.m_vertex1, shape.m_vertex2, {}, {}};
    if (shape.m_hasVertex0)
    {
        edge.vertex0 = shape.m_vertex0;
    }
    if (shape.m_hasVertex3)
    {
        edge.vertex3 = shape.m_vertex3;
    }
    return edge;
}

/// A loop's last vertex is its first: said so, its neighbours follow from it.
RubeChain ChainOf(const b2ChainShape& shape)
{
    RubeChain chain;
    chain.vertices.assign(shape.m_vertices, shape.m_vertices + shape.m_count);
    const bool isLoop = shape.m_count > 3 && chain.vertices.front() == chain.vertices.back();
    if (!isLoop && shape.m_hasPrevVertex)
    {
        chain.previous = shape.m_prevVertex;
    }
    if (!isLoop && shape.m_hasNextVertex)
    {
        chain.next = shape.m_nextVertex;
    }
    return chain;
}

bool IsOneSided(const b2Shape& shape)
{
    return (shape.GetType() == b2Shape::e_edge &&
            static_cast<const b2EdgeShape&>(shape).m_oneSided) ||
           (shape.GetType() == b2Shape::e_chain &&
            static_cast<const b2ChainShape&>(shape).m_oneSided);
}

decltype(RubeFixture::geometry) ShapeOf(const b2Shape& shape)
{
    switch (shape.GetType())
    {
    case b2Shape::e_circle: {
        const auto& circle = static_cast<const b2CircleShape&>(shape);
        return RubeCircle{circle.m_p, circle.m_radius};
    }
    case b2Shape::e_edge:
        return EdgeOf(static_cast<const b2EdgeShape&>(shape));
    case b2Shape::e_chain:
        return ChainOf(static_cast<const b2ChainShape&>(shape));
    default: {
        const auto& polygon = static_cast<const b2PolygonShape&>(shape);
        return PolygonOf(polygon);
    }
    }
}

RubeFixture FixtureOf(const b2Fixture& fixture)
{
    RubeFixture said;
    Take(said, fixture);
    said.geometry = ShapeOf(*fixture.GetShape());
    return said;
}

RubeBody BodyOf(b2Body& body)
{
    RubeBody said;
    Take(said, body);
    for (const b2Fixture* fixture : InOrder(body.GetFixtureList()))
    {
        said.fixtures.push_back(FixtureOf(*fixture));
    }
    return said;
}

// ---- Joints

/// True if a distance joint is a rope: it has a maximum length and nothing else.
bool IsRope(const b2DistanceJoint& joint)
{
    const float32 minimum = joint.GetMinLength();
    const float32 maximum = joint.GetMaxLength();
    return !joint.IsSpring() && minimum <= b2_linearSlop && minimum < maximum &&
           maximum < b2_maxFloat;
}

/// True if it has limits that the format cannot express. Other joints are ropes or rods.
bool HasUnsaidLimits(const b2DistanceJoint& joint)
{
    const float32 minimum = joint.GetMinLength();
    const float32 maximum = joint.GetMaxLength();
    return !IsRope(joint) && minimum < maximum && (minimum > 0.0f || maximum < b2_maxFloat);
}

void DescribeKind(RubeJoint&, std::monostate, b2Joint&) {}

void DescribeKind(RubeJoint& said, auto kind, b2Joint& engineJoint)
{
    const auto& joint = static_cast<typename decltype(kind)::Joint&>(engineJoint);
    Take(kind, joint);
    if constexpr (requires { joint.GetLocalAnchorA(); })
    {
        said.anchorA = joint.GetLocalAnchorA();
        said.anchorB = joint.GetLocalAnchorB();
    }
    said.details = kind;
}

class Exporter
{
public:
    Exporter(b2World& world, RubeNotes& leftOut) : m_world(world), m_leftOut(leftOut) {}

    RubeScene Export(const std::map<std::uint32_t, std::string>& bodyNames,
                     const std::map<const b2Joint*, std::string>& jointNames, const Scene* file)
    {
        DescribeWorld();
        for (b2Body* body : InOrder(m_world.GetBodyList()))
        {
            m_bodies[body] = m_said.bodies.size();
            m_said.bodies.push_back(BodyOf(*body));
            const auto name = bodyNames.find(std::uint32_t(body->GetNumber()));
            m_said.bodies.back().name = name != bodyNames.end() ? name->second : "";
            DescribeMass(*body);
            NoteOneSided(*body);
        }
        for (b2Joint* joint : InOrder(m_world.GetJointList()))
        {
            m_joints[joint] = m_said.joints.size();
            DescribeJoint(*joint);
            const auto name = jointNames.find(joint);
            m_said.joints.back().name = name != jointNames.end() ? name->second : "";
        }
        if (file != nullptr && ContentOfFile(*file) != nullptr)
        {
            KeepFrom(*file);
        }
        return std::move(m_said);
    }

private:
    void DescribeWorld()
    {
        const b2World& world = m_world;
        Take(m_said, world);
        if (world.GetSubStepCount() != 1)
        {
            m_leftOut.push_back({std::to_string(world.GetSubStepCount()) + " sub-steps", kNoWord});
        }
        if (world.GetRestitutionThreshold() != b2_velocityThreshold)
        {
            m_leftOut.push_back({"restitution threshold", kNoWord});
        }
    }

    void NoteOneSided(b2Body& body)
    {
        const std::vector<b2Fixture*> fixtures = InOrder(body.GetFixtureList());
        for (std::size_t i = 0; i < fixtures.size(); ++i)
        {
            if (IsOneSided(*fixtures[i]->GetShape()))
            {
                m_leftOut.push_back({"one-sidedness of " + WithName("fixture", i, "") + " of " +
                                         NameOfBody(m_said, m_said.bodies.size() - 1),
                                     kNoWord});
            }
        }
    }

    void DescribeJoint(b2Joint& joint)
    {
        RubeJoint said;
        said.bodyA = m_bodies.at(joint.GetBodyA());
        said.bodyB = m_bodies.at(joint.GetBodyB());
        said.collideConnected = joint.GetCollideConnected();
        const auto* const kind =
            std::find_if(std::begin(kRubeKinds), std::end(kRubeKinds),
                         [&](const RubeKindName& each) { return each.type == joint.GetType(); });
        said.type = kind->name;
        std::visit([&](const auto& empty) { DescribeKind(said, empty, joint); }, kind->empty);
        if (auto* const gear = std::get_if<RubeGear>(&said.details))
        {
            gear->index1 = m_joints.at(static_cast<b2GearJoint&>(joint).GetJoint1());
            gear->index2 = m_joints.at(static_cast<b2GearJoint&>(joint).GetJoint2());
        }
        else if (joint.GetType() == e_mouseJoint)
        {
            said.anchorB = joint.GetAnchorB(); // in the world
        }
        else if (joint.GetType() == e_distanceJoint)
        {
            DescribeLengths(said, static_cast<b2DistanceJoint&>(joint));
        }
        m_said.joints.push_back(std::move(said));
    }

    void DescribeLengths(RubeJoint& said, const b2DistanceJoint& joint)
    {
        if (IsRope(joint))
        {
            RubeRope rope;
            rope.maxLength = joint.GetMaxLength();
            said.type = "rope";
            said.details = rope;
        }
        else if (joint.GetMinLength() == joint.GetMaxLength()) // a rod
        {
            auto& distance = std::get<RubeDistance>(said.details);
            distance.length = joint.GetMinLength();
            distance.frequencyHz = 0.0f;
        }
        else if (HasUnsaidLimits(joint))
        {
            m_leftOut.push_back(
                {"minimum and maximum length of " + WithName("joint", m_said.joints.size(), ""),
                 kNoWord});
        }
    }

    /// Copies the parts of the file that the engine does not use, if nothing was added or removed
    /// since.
    void KeepFrom(const Scene& scene)
    {
        const RubeScene* const file = ContentOfFile(scene);
        m_said.images = file->images;
        m_said.properties = file->properties;
        for (std::size_t i = 0; i < std::min(m_said.bodies.size(), file->bodies.size()); ++i)
        {
            KeepOfBody(m_said.bodies[i], file->bodies[i]);
        }
        const auto built = JointsOfFile(scene);
        for (std::size_t i = 0; i < built.size(); ++i)
        {
            const auto found = m_joints.find(built[i]);
            if (found != m_joints.end())
            {
                m_said.joints[found->second].properties = file->joints[i].properties;
            }
        }
    }

    static void KeepOfBody(RubeBody& said, const RubeBody& file)
    {
        said.properties = file.properties;
        if (said.fixtures.size() != file.fixtures.size())
        {
            return; // some could not be built, and which is which is not known
        }
        for (std::size_t i = 0; i < said.fixtures.size(); ++i)
        {
            said.fixtures[i].name = file.fixtures[i].name;
            said.fixtures[i].properties = file.fixtures[i].properties;
        }
    }

    /// Writes the mass of all dynamic bodies, even if it equals that of the fixtures. Other readers
    /// set the mass data of the file, and use 1 kg at the origin if it has none.
    void DescribeMass(b2Body& body)
    {
        RubeBody& said = m_said.bodies.back();
        b2MassData data;
        body.GetMassData(&data);
        if (body.GetType() == b2_dynamicBody && IsReadableMass(data))
        {
            said.massData = data;
        }
        else if (body.GetType() == b2_dynamicBody)
        {
            m_leftOut.push_back({"mass of " + NameOfBody(m_said, m_said.bodies.size() - 1),
                                 "more than a scene file allows"});
        }
    }

    b2World& m_world;
    RubeNotes& m_leftOut;
    RubeScene m_said;
    std::map<const b2Body*, std::size_t> m_bodies; ///< only to look up: addresses
    std::map<const b2Joint*, std::size_t> m_joints;
};

} // namespace

RubeScene ExportScene(Scene& scene, const StepSettings& steps, float32 stepsPerSecond,
                      RubeNotes& leftOut)
{
    RubeScene said =
        Exporter(scene.World(), leftOut).Export(scene.Names(), scene.JointNames(), &scene);
    said.stepsPerSecond = stepsPerSecond;
    said.velocityIterations = steps.velocityIterations;
    said.positionIterations = steps.positionIterations;
    return said;
}

RubeScene ExportWorld(b2World& world, const std::map<std::uint32_t, std::string>& bodyNames,
                      const std::map<const b2Joint*, std::string>& jointNames, RubeNotes& leftOut)
{
    return Exporter(world, leftOut).Export(bodyNames, jointNames, nullptr);
}

} // namespace boxreel
