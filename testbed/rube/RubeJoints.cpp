// SPDX-License-Identifier: MIT
#include "RubeJoints.h"

#include "RubeNames.h"

namespace boxreel
{

namespace
{

constexpr const char* kNoDirection = "its axis has no direction";
constexpr const char* kNoLength = "its length is zero; a revolute joint keeps points together";

// The kind without the quotes that a name has.
std::string Shown(const std::string& type)
{
    const std::string quoted = QuotedName(type);
    return type.empty() ? "no kind" : quoted.substr(1, quoted.size() - 2);
}

/// Makes a joint of each kind, or says in a word why it cannot.
class JointBuilder
{
public:
    using LeaveOut = std::function<void(const RubeNote&)>;

    JointBuilder(const RubeScene& scene, const std::vector<b2Body*>& bodies, b2World& world,
                 const LeaveOut& leaveOut)
        : m_scene(scene), m_bodies(bodies), m_world(world), m_leaveOut(leaveOut),
          m_joints(scene.joints.size())
    {}

    /// Gears last, for they stand on other joints.
    std::vector<const b2Joint*> Build()
    {
        for (const bool gears : {false, true})
        {
            for (std::size_t i = 0; i < m_scene.joints.size(); ++i)
            {
                if (std::holds_alternative<RubeGear>(m_scene.joints[i].details) == gears)
                {
                    BuildJoint(i);
                }
            }
        }
        return {m_joints.begin(), m_joints.end()};
    }

private:
    void BuildJoint(std::size_t index)
    {
        const RubeJoint& source = m_scene.joints[index];
        m_index = index;
        m_who = WithName("joint", index, source.name) + " (" + Shown(source.type) + ", between " +
                NameOfBody(m_scene, source.bodyA) + " and " + NameOfBody(m_scene, source.bodyB) +
                ")";
        const std::string why =
            source.bodyA == source.bodyB
                ? "it connects a body with itself"
                : std::visit([&](const auto& details) { return Make(source, details); },
                             source.details);
        if (!why.empty())
        {
            m_leaveOut({m_who, why});
        }
    }

    std::string Create(const RubeJoint& source, b2JointDef& definition)
    {
        definition.bodyA = m_bodies[source.bodyA];
        definition.bodyB = m_bodies[source.bodyB];
        definition.collideConnected = source.collideConnected;
        m_joints[m_index] = m_world.CreateJoint(&definition);
        return "";
    }

    static void Anchor(const RubeJoint& source, auto& definition)
    {
        definition.localAnchorA = source.anchorA;
        definition.localAnchorB = source.anchorB;
    }

    void ReportLimit()
    {
        m_leaveOut({"limit of " + m_who, "its lower end is above its upper end"});
    }

    // Empty if the joint was made, otherwise the reason why not.

    static std::string Make(const RubeJoint&, std::monostate)
    {
        return "joints of this kind cannot be built";
    }

    std::string Make(const RubeJoint& source, const RubeRevolute& revolute)
    {
        b2RevoluteJointDef definition;
        Anchor(source, definition);
        definition.referenceAngle = revolute.referenceAngle;
        if (revolute.lowerLimit <= revolute.upperLimit)
        {
            definition.enableLimit = revolute.enableLimit;
            definition.lowerAngle = revolute.lowerLimit;
            definition.upperAngle = revolute.upperLimit;
        }
        else
        {
            ReportLimit();
        }
        definition.enableMotor = revolute.enableMotor;
        definition.motorSpeed = revolute.motorSpeed;
        definition.maxMotorTorque = revolute.maxMotorTorque;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubePrismatic& prismatic)
    {
        b2PrismaticJointDef definition;
        Anchor(source, definition);
        definition.localAxisA = prismatic.axis;
        if (!(definition.localAxisA.Normalize() > 0.0f))
        {
            return kNoDirection;
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
            ReportLimit();
        }
        definition.enableMotor = prismatic.enableMotor;
        definition.motorSpeed = prismatic.motorSpeed;
        definition.maxMotorForce = prismatic.maxMotorForce;
        return Create(source, definition);
    }

    // The manual warns of short lengths; shorter than the tolerance has no direction at all.
    std::string Make(const RubeJoint& source, const RubeDistance& distance)
    {
        if (distance.length < b2_linearSlop)
        {
            return kNoLength;
        }
        b2DistanceJointDef definition;
        Anchor(source, definition);
        definition.length = distance.length;
        definition.frequencyHz = distance.frequency;
        definition.dampingRatio = distance.dampingRatio;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubePulley& pulley)
    {
        if (!(pulley.ratio > b2_epsilon))
        {
            return "a pulley needs a ratio above zero";
        }
        b2PulleyJointDef definition;
        Anchor(source, definition);
        definition.groundAnchorA = pulley.groundAnchorA;
        definition.groundAnchorB = pulley.groundAnchorB;
        definition.lengthA = pulley.lengthA;
        definition.lengthB = pulley.lengthB;
        definition.ratio = pulley.ratio;
        return Create(source, definition);
    }

    // The body is held where it is, and pulled from the next step on.
    std::string Make(const RubeJoint& source, const RubeMouse& mouse)
    {
        if (!(mouse.frequency > 0.0f))
        {
            return "a mouse joint needs a frequency above zero";
        }
        b2MouseJointDef definition;
        definition.target = source.anchorB;
        definition.maxForce = mouse.maxForce;
        definition.frequencyHz = mouse.frequency;
        definition.dampingRatio = mouse.dampingRatio;
        Create(source, definition);
        static_cast<b2MouseJoint*>(m_joints[m_index])->SetTarget(mouse.target);
        return "";
    }

    std::string Make(const RubeJoint& source, const RubeGear& gear)
    {
        b2GearJointDef definition;
        definition.joint1 = GearedJoint(gear.joint1);
        definition.joint2 = GearedJoint(gear.joint2);
        definition.ratio = gear.ratio;
        if (definition.joint1 == nullptr || definition.joint2 == nullptr || gear.ratio == 0.0f ||
            definition.joint1 == definition.joint2)
        {
            return "a gear needs two joints, each revolute or prismatic, and a ratio other than "
                   "zero";
        }
        for (const std::size_t body : {source.bodyA, source.bodyB})
        {
            if (!Holds(*definition.joint1, m_bodies[body]) &&
                !Holds(*definition.joint2, m_bodies[body]))
            {
                return "its " + NameOfBody(m_scene, body) + " is not of its two joints";
            }
        }
        return Create(source, definition);
    }

    static bool Holds(b2Joint& joint, const b2Body* body)
    {
        return joint.GetBodyA() == body || joint.GetBodyB() == body;
    }

    b2Joint* GearedJoint(std::size_t index) const
    {
        b2Joint* const joint = index < m_joints.size() ? m_joints[index] : nullptr;
        const bool turnsOrSlides = joint != nullptr && (joint->GetType() == e_revoluteJoint ||
                                                        joint->GetType() == e_prismaticJoint);
        return turnsOrSlides ? joint : nullptr;
    }

    std::string Make(const RubeJoint& source, const RubeWheel& wheel)
    {
        b2WheelJointDef definition;
        Anchor(source, definition);
        definition.localAxisA = wheel.axis;
        if (!(definition.localAxisA.Normalize() > 0.0f))
        {
            return kNoDirection;
        }
        definition.enableMotor = wheel.enableMotor;
        definition.motorSpeed = wheel.motorSpeed;
        definition.maxMotorTorque = wheel.maxMotorTorque;
        definition.frequencyHz = wheel.frequency;
        definition.dampingRatio = wheel.dampingRatio;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubeMotor& motor)
    {
        b2MotorJointDef definition;
        definition.linearOffset = motor.linearOffset;
        definition.angularOffset = motor.angularOffset;
        definition.maxForce = motor.maxForce;
        definition.maxTorque = motor.maxTorque;
        definition.correctionFactor = motor.correctionFactor;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubeWeld& weld)
    {
        b2WeldJointDef definition;
        Anchor(source, definition);
        definition.referenceAngle = weld.referenceAngle;
        definition.frequencyHz = weld.frequency;
        definition.dampingRatio = weld.dampingRatio;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubeFriction& friction)
    {
        b2FrictionJointDef definition;
        Anchor(source, definition);
        definition.maxForce = friction.maxForce;
        definition.maxTorque = friction.maxTorque;
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, const RubeRope& rope)
    {
        if (!(rope.maxLength > b2_linearSlop))
        {
            return kNoLength;
        }
        b2RopeJointDef definition;
        Anchor(source, definition);
        definition.maxLength = rope.maxLength;
        return Create(source, definition);
    }

    const RubeScene& m_scene;
    const std::vector<b2Body*>& m_bodies;
    b2World& m_world;
    const LeaveOut& m_leaveOut;
    std::vector<b2Joint*> m_joints; ///< in the order of the file
    std::size_t m_index = 0;        ///< of the joint that is being made
    std::string m_who;              ///< its name in messages
};

} // namespace

std::vector<const b2Joint*> BuildRubeJoints(const RubeScene& scene,
                                            const std::vector<b2Body*>& bodies, b2World& world,
                                            const std::function<void(const RubeNote&)>& leaveOut)
{
    return JointBuilder(scene, bodies, world, leaveOut).Build();
}

} // namespace boxreel
