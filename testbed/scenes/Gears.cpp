// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kTooth = 0.5f;          ///< half as deep, and as wide at the pitch circle [m]
constexpr float32 kPitch = 2.0f * kTooth; ///< from one tooth to the next along the pitch line [m]
constexpr int32 kSmallTeeth = 12;
constexpr int32 kLargeTeeth = 24;
constexpr int32 kRackTeeth = 16;
constexpr float32 kMotorSpeed = 1.5f; ///< of the small gear [rad/s]
constexpr float32 kTorque = 2000.0f;  ///< [N m]
constexpr float32 kTravel = 5.0f;  ///< of the rack to either side, before the motor turns round [m]
constexpr float32 kHeight = 14.0f; ///< of the axles [m]
constexpr Material kIron{.density = 1.0f};

constexpr KeyBinding kKeys[] = {{'m', "switches the motor"}, {'d', "turns the motor round"}};

/// Returns the radius of the circle on which gears touch like plain wheels [m].
float32 PitchRadius(int32 teeth)
{
    return 0.5f * kPitch * static_cast<float32>(teeth) / b2_pi;
}

/// A small gear with a motor turns a large one, which moves a rack up and down. The teeth are for
/// the eye: gear joints keep the angles, and nothing here touches anything.
class Gears : public Scene
{
public:
    explicit Gears(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-16.0f, 0.0f), b2Vec2(16.0f, 0.0f));
        const float32 small = PitchRadius(kSmallTeeth);
        const float32 large = PitchRadius(kLargeTeeth);
        const b2Vec2 largeHub(0.0f, kHeight);
        const b2Vec2 smallHub(-small - large, kHeight);

        // At the contact, a tooth of one gear is between two of the other.
        b2Body* smallGear = AddGear(smallHub, kSmallTeeth, 0.0f);
        b2Body* largeGear =
            AddGear(largeHub, kLargeTeeth, b2_pi / static_cast<float32>(kLargeTeeth));
        b2Body* rack = AddRack(b2Vec2(large, kHeight));
        Name(*smallGear, "small gear");
        Name(*largeGear, "large gear");
        Name(*rack, "rack");
        m_motor =
            AddMotorHinge(m_world, AddAxle(smallHub), smallGear, smallHub, kMotorSpeed, kTorque);
        m_hinge = AddHinge(m_world, AddAxle(largeHub), largeGear, largeHub);
        m_slide = AddSlide(m_world, AddAxle(rack->GetPosition()), rack, rack->GetPosition(),
                           b2Vec2(0.0f, 1.0f));
        Couple(m_motor, m_hinge, large / small);
        Couple(m_hinge, m_slide, -1.0f / large);
    }

    void Step(const StepSettings& settings) override
    {
        const float32 at = static_cast<b2PrismaticJoint*>(m_slide)->GetJointTranslation();
        if (b2Abs(at) > kTravel)
        {
            // Up with the large gear, that is against the small one.
            Motor().SetMotorSpeed(at > 0.0f ? kMotorSpeed : -kMotorSpeed);
        }
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        Motor().GetBodyB()->SetAwake(true);
        if (key == 'm')
        {
            Motor().EnableMotor(!Motor().IsMotorEnabled());
        }
        if (key == 'd')
        {
            Motor().SetMotorSpeed(-Motor().GetMotorSpeed());
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const auto* large = static_cast<const b2RevoluteJoint*>(m_hinge);
        const auto* rack = static_cast<const b2PrismaticJoint*>(m_slide);
        return {{"small gear", Rounded(Motor().GetJointAngle()) + " rad"},
                {"large gear", Rounded(large->GetJointAngle()) + " rad"},
                {"rack", Rounded(rack->GetJointTranslation()) + " m"}};
    }

    void VisitState(SceneState& state) override { state(m_motor, m_hinge, m_slide); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(-0.5f, 13.5f), .halfSize = b2Vec2(10.0f, 14.0f)};
    }

private:
    b2RevoluteJoint& Motor() const { return *static_cast<b2RevoluteJoint*>(m_motor); }

    b2Body* AddAxle(const b2Vec2& place)
    {
        b2Body* axle = AddGroundBox(m_world, place, 0.2f, 0.2f);
        SetGroup(*axle, -1);
        return axle;
    }

    b2Body* AddGear(const b2Vec2& hub, int32 teeth, float32 firstTooth)
    {
        const float32 radius = PitchRadius(teeth);
        b2Body* gear = AddBody(m_world, b2_dynamicBody, hub);
        AttachCircle(*gear, radius - 0.5f * kTooth, kIron);
        for (int32 i = 0; i < teeth; ++i)
        {
            const float32 angle =
                firstTooth + 2.0f * b2_pi * static_cast<float32>(i) / static_cast<float32>(teeth);
            const b2Rot turn(angle);
            AttachBox(*gear, 0.5f * kTooth, 0.45f * kTooth, kIron, radius * b2Vec2(turn.c, turn.s),
                      angle);
        }
        SetGroup(*gear, -1);
        return gear;
    }

    // The rack's teeth are half a tooth below those of the gear on its right.
    b2Body* AddRack(const b2Vec2& place)
    {
        b2Body* rack = AddBody(m_world, b2_dynamicBody, place);
        const float32 half = 0.5f * kPitch * static_cast<float32>(kRackTeeth);
        AttachBox(*rack, 0.5f * kTooth, half, kIron, b2Vec2(kTooth, 0.0f));
        for (int32 i = 0; i < kRackTeeth; ++i)
        {
            const float32 y = -half + kPitch * static_cast<float32>(i);
            AttachBox(*rack, 0.5f * kTooth, 0.45f * kTooth, kIron, b2Vec2(0.0f, y));
        }
        SetGroup(*rack, -1);
        return rack;
    }

    void Couple(b2Joint* first, b2Joint* second, float32 ratio)
    {
        b2GearJointDef gear;
        gear.bodyA = first->GetBodyB();
        gear.bodyB = second->GetBodyB();
        gear.joint1 = first;
        gear.joint2 = second;
        gear.ratio = ratio;
        m_world.CreateJoint(&gear);
    }

    b2Joint* m_motor = nullptr; ///< of the small gear, a revolute joint
    b2Joint* m_hinge = nullptr; ///< of the large gear, a revolute joint
    b2Joint* m_slide = nullptr; ///< of the rack, a prismatic joint
};

} // namespace

std::unique_ptr<Scene> MakeGears(const SceneSettings& settings)
{
    return std::make_unique<Gears>(settings);
}

} // namespace boxreel
