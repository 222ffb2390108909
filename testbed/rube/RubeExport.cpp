// SPDX-License-Identifier: MIT
#include "RubeExport.h"

#include "RubeBuilder.h"
#include "RubeFile.h"
#include "RubeNames.h"
#include "RubePolygons.h"
#include "RubeText.h"

#include <algorithm>
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

decltype(RubeFixture::shape) ShapeOf(const b2Shape& shape)
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
    said.restitution = fixture.GetRestitution();
    said.friction = fixture.GetFriction();
    said.density = fixture.GetDensity();
    said.isSensor = fixture.IsSensor();
    said.categoryBits = fixture.GetFilterData().categoryBits;
    said.maskBits = fixture.GetFilterData().maskBits;
    said.groupIndex = fixture.GetFilterData().groupIndex;
    said.shape = ShapeOf(*fixture.GetShape());
    return said;
}

RubeBody BodyOf(b2Body& body)
{
    RubeBody said;
    said.type = body.GetType();
    said.position = body.GetPosition();
    said.angle = body.GetAngle();
    said.linearVelocity = body.GetLinearVelocity();
    said.angularVelocity = body.GetAngularVelocity();
    said.linearDamping = body.GetLinearDamping();
    said.angularDamping = body.GetAngularDamping();
    said.gravityScale = body.GetGravityScale();
    said.isBullet = body.IsBullet();
    said.allowSleep = body.IsSleepingAllowed();
    said.isAwake = body.IsAwake();
    said.isActive = body.IsActive();
    said.fixedRotation = body.IsFixedRotation();
    for (const b2Fixture* fixture : InOrder(body.GetFixtureList()))
    {
        said.fixtures.push_back(FixtureOf(*fixture));
    }
    return said;
}

// ---- Joints

template <class Joint>
void SetAnchors(RubeJoint& said, const Joint& joint)
{
    said.anchorA = joint.GetLocalAnchorA();
    said.anchorB = joint.GetLocalAnchorB();
}

template <class Said, class Joint>
void SetLimitAndMotor(Said& said, const Joint& joint)
{
    said.referenceAngle = joint.GetReferenceAngle();
    said.enableLimit = joint.IsLimitEnabled();
    said.lowerLimit = joint.GetLowerLimit();
    said.upperLimit = joint.GetUpperLimit();
    said.enableMotor = joint.IsMotorEnabled();
    said.motorSpeed = joint.GetMotorSpeed();
}

void Describe(RubeJoint& said, b2RevoluteJoint& joint)
{
    RubeRevolute revolute;
    SetLimitAndMotor(revolute, joint);
    revolute.maxMotorTorque = joint.GetMaxMotorTorque();
    SetAnchors(said, joint);
    said.type = "revolute";
    said.details = revolute;
}

void Describe(RubeJoint& said, b2PrismaticJoint& joint)
{
    RubePrismatic prismatic;
    SetLimitAndMotor(prismatic, joint);
    prismatic.axis = joint.GetLocalAxisA();
    prismatic.maxMotorForce = joint.GetMaxMotorForce();
    SetAnchors(said, joint);
    said.type = "prismatic";
    said.details = prismatic;
}

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

void Describe(RubeJoint& said, b2DistanceJoint& joint)
{
    SetAnchors(said, joint);
    if (IsRope(joint))
    {
        said.type = "rope";
        said.details = RubeRope{joint.GetMaxLength()};
        return;
    }
    const bool isRod = joint.GetMinLength() == joint.GetMaxLength();
    said.type = "distance";
    said.details = RubeDistance{isRod ? joint.GetMinLength() : joint.GetLength(),
                                isRod ? 0.0f : joint.GetFrequency(), joint.GetDampingRatio()};
}

void Describe(RubeJoint& said, b2PulleyJoint& joint)
{
    SetAnchors(said, joint);
    said.type = "pulley";
    said.details =
        RubePulley{joint.GetGroundAnchorA(), joint.GetGroundAnchorB(), joint.GetDefinedLengthA(),
                   joint.GetDefinedLengthB(), joint.GetRatio()};
}

void Describe(RubeJoint& said, b2MouseJoint& joint)
{
    said.anchorB = joint.GetAnchorB(); // in the world
    said.type = "mouse";
    said.details = RubeMouse{joint.GetTarget(), joint.GetMaxForce(), joint.GetFrequency(),
                             joint.GetDampingRatio()};
}

void Describe(RubeJoint& said, b2WheelJoint& joint)
{
    SetAnchors(said, joint);
    said.type = "wheel";
    said.details = RubeWheel{joint.GetLocalAxisA(),        joint.IsMotorEnabled(),
                             joint.GetMotorSpeed(),        joint.GetMaxMotorTorque(),
                             joint.GetSpringFrequencyHz(), joint.GetSpringDampingRatio()};
}

void Describe(RubeJoint& said, b2MotorJoint& joint)
{
    said.type = "motor";
    said.details = RubeMotor{joint.GetLinearOffset(), joint.GetAngularOffset(), joint.GetMaxForce(),
                             joint.GetMaxTorque(), joint.GetCorrectionFactor()};
}

void Describe(RubeJoint& said, b2WeldJoint& joint)
{
    SetAnchors(said, joint);
    said.type = "weld";
    said.details =
        RubeWeld{joint.GetReferenceAngle(), joint.GetFrequency(), joint.GetDampingRatio()};
}

void Describe(RubeJoint& said, b2FrictionJoint& joint)
{
    SetAnchors(said, joint);
    said.type = "friction";
    said.details = RubeFriction{joint.GetMaxForce(), joint.GetMaxTorque()};
}

void Describe(RubeJoint& said, b2RopeJoint& joint)
{
    SetAnchors(said, joint);
    said.type = "rope";
    said.details = RubeRope{joint.GetMaxLength()};
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
        m_said.gravity = world.GetGravity();
        m_said.allowSleep = world.GetAllowSleeping();
        m_said.autoClearForces = world.GetAutoClearForces();
        m_said.warmStarting = world.GetWarmStarting();
        m_said.continuousPhysics = world.GetContinuousPhysics();
        m_said.subStepping = world.GetSubStepping();
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
        switch (joint.GetType())
        {
        case e_revoluteJoint:
            Describe(said, static_cast<b2RevoluteJoint&>(joint));
            break;
        case e_prismaticJoint:
            Describe(said, static_cast<b2PrismaticJoint&>(joint));
            break;
        case e_distanceJoint:
            Describe(said, static_cast<b2DistanceJoint&>(joint));
            if (HasUnsaidLimits(static_cast<b2DistanceJoint&>(joint)))
            {
                m_leftOut.push_back(
                    {"minimum and maximum length of " + WithName("joint", m_said.joints.size(), ""),
                     kNoWord});
            }
            break;
        case e_pulleyJoint:
            Describe(said, static_cast<b2PulleyJoint&>(joint));
            break;
        case e_mouseJoint:
            Describe(said, static_cast<b2MouseJoint&>(joint));
            break;
        case e_gearJoint: {
            auto& gear = static_cast<b2GearJoint&>(joint);
            said.type = "gear";
            said.details = RubeGear{m_joints.at(gear.GetJoint1()), m_joints.at(gear.GetJoint2()),
                                    gear.GetRatio()};
            break;
        }
        case e_wheelJoint:
            Describe(said, static_cast<b2WheelJoint&>(joint));
            break;
        case e_weldJoint:
            Describe(said, static_cast<b2WeldJoint&>(joint));
            break;
        case e_frictionJoint:
            Describe(said, static_cast<b2FrictionJoint&>(joint));
            break;
        case e_ropeJoint:
            Describe(said, static_cast<b2RopeJoint&>(joint));
            break;
        default:
            Describe(said, static_cast<b2MotorJoint&>(joint));
            break;
        }
        m_said.joints.push_back(std::move(said));
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
