// SPDX-License-Identifier: MIT
#include "RubeJoints.h"

#include "RubeNames.h"

#include <utility>

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

    std::string Create(const RubeJoint& source, auto& definition)
    {
        if constexpr (requires { definition.localAnchorA; })
        {
            definition.localAnchorA = source.anchorA;
            definition.localAnchorB = source.anchorB;
        }
        definition.bodyA = m_bodies[source.bodyA];
        definition.bodyB = m_bodies[source.bodyB];
        definition.collideConnected = source.collideConnected;
        m_joints[m_index] = m_world.CreateJoint(&definition);
        return "";
    }

    /// Removes a limit that no joint can have.
    void CheckLimit(bool& isEnabled, float32& lower, float32& upper)
    {
        if (!(lower <= upper))
        {
            m_leaveOut({"limit of " + m_who, "its lower end is above its upper end"});
            isEnabled = false;
            lower = upper = 0.0f;
        }
    }

    // Empty if the joint was made, otherwise the reason why not.

    static std::string Make(const RubeJoint&, std::monostate)
    {
        return "joints of this kind cannot be built";
    }

    std::string Make(const RubeJoint& source, auto definition)
    {
        return Create(source, definition);
    }

    std::string Make(const RubeJoint& source, RubeRevolute revolute)
    {
        CheckLimit(revolute.enableLimit, revolute.lowerAngle, revolute.upperAngle);
        return Create(source, revolute);
    }

    std::string Make(const RubeJoint& source, RubePrismatic prismatic)
    {
        if (!(prismatic.localAxisA.Normalize() > 0.0f))
        {
            return kNoDirection;
        }
        CheckLimit(prismatic.enableLimit, prismatic.lowerTranslation, prismatic.upperTranslation);
        return Create(source, prismatic);
    }

    // The manual warns of short lengths; shorter than the tolerance has no direction at all.
    std::string Make(const RubeJoint& source, RubeDistance distance)
    {
        return distance.length < b2_linearSlop ? kNoLength : Create(source, distance);
    }

    std::string Make(const RubeJoint& source, RubePulley pulley)
    {
        return pulley.ratio > b2_epsilon ? Create(source, pulley)
                                         : "a pulley needs a ratio above zero";
    }

    // The body is held where it is, and pulled from the next step on.
    std::string Make(const RubeJoint& source, RubeMouse mouse)
    {
        if (!(mouse.frequencyHz > 0.0f))
        {
            return "a mouse joint needs a frequency above zero";
        }
        const b2Vec2 target = std::exchange(mouse.target, source.anchorB);
        Create(source, mouse);
        static_cast<b2MouseJoint*>(m_joints[m_index])->SetTarget(target);
        return "";
    }

    std::string Make(const RubeJoint& source, RubeGear gear)
    {
        gear.joint1 = GearedJoint(gear.index1);
        gear.joint2 = GearedJoint(gear.index2);
        if (gear.joint1 == nullptr || gear.joint2 == nullptr || gear.ratio == 0.0f ||
            gear.joint1 == gear.joint2)
        {
            return "a gear needs two joints, each revolute or prismatic, and a ratio other than "
                   "zero";
        }
        for (const std::size_t body : {source.bodyA, source.bodyB})
        {
            if (!Holds(*gear.joint1, m_bodies[body]) && !Holds(*gear.joint2, m_bodies[body]))
            {
                return "its " + NameOfBody(m_scene, body) + " is not of its two joints";
            }
        }
        return Create(source, gear);
    }

    std::string Make(const RubeJoint& source, RubeWheel wheel)
    {
        return wheel.localAxisA.Normalize() > 0.0f ? Create(source, wheel) : kNoDirection;
    }

    std::string Make(const RubeJoint& source, RubeRope rope)
    {
        return rope.maxLength > b2_linearSlop ? Create(source, rope) : kNoLength;
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
