// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

const b2Vec2 kAxle(0.0f, 6.0f);       ///< [m]
constexpr float32 kCrank = 2.5f;      ///< [m]
constexpr float32 kRod = 7.0f;        ///< [m]
constexpr float32 kSpeed = b2_pi;     ///< half a turn a second [rad/s]
constexpr float32 kTorque = 6000.0f;  ///< [N m]
constexpr float32 kPistonHalf = 1.5f; ///< [m]
constexpr float32 kFriction = 400.0f; ///< of the piston when it is not greased [N]
constexpr Material kSteel{.density = 2.0f};

constexpr KeyBinding kKeys[] = {{'m', "switches the motor"},
                                {'f', "switches the piston's friction"}};

/// A crank turns, a rod pushes, a piston goes up and down in its guide and throws a box.
class SliderCrank : public Scene
{
public:
    explicit SliderCrank(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-12.0f, 0.0f), b2Vec2(12.0f, 0.0f));
        b2Body* guide = AddGuide();

        const b2Vec2 pin = kAxle + b2Vec2(0.0f, kCrank);
        const b2Vec2 head = pin + b2Vec2(0.0f, kRod);
        b2Body* axle = AddGroundBox(m_world, kAxle, 0.3f, 0.3f);
        b2Body* crank = AddBody(m_world, b2_dynamicBody, kAxle);
        AttachCircle(*crank, kCrank + 0.4f, kSteel);
        b2Body* rod = AddBox(m_world, 0.5f * (pin + head), 0.3f, 0.5f * kRod, kSteel);
        b2Body* piston = AddBox(m_world, head, kPistonHalf, kPistonHalf, kSteel);
        for (b2Body* part : {axle, crank, rod, piston})
        {
            SetGroup(*part, -1);
        }
        Name(*crank, "crank");
        Name(*piston, "piston");
        m_motor = AddMotorHinge(m_world, axle, crank, kAxle, kSpeed, kTorque);
        AddHinge(m_world, crank, rod, pin);
        AddHinge(m_world, rod, piston, head);
        m_slide = AddSlide(m_world, guide, piston, head, b2Vec2(0.0f, 1.0f));
        AddBox(m_world, head + b2Vec2(0.0f, kPistonHalf + 0.8f), 0.8f, 0.8f, {.density = 1.0f});
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        auto* motor = static_cast<b2RevoluteJoint*>(m_motor);
        auto* slide = static_cast<b2PrismaticJoint*>(m_slide);
        slide->GetBodyB()->SetAwake(true);
        if (key == 'm')
        {
            motor->EnableMotor(!motor->IsMotorEnabled());
        }
        if (key == 'f')
        {
            // A motor at rest is what holds back with a force of its own.
            slide->SetMaxMotorForce(kFriction);
            slide->EnableMotor(!slide->IsMotorEnabled());
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const auto* motor = static_cast<const b2RevoluteJoint*>(m_motor);
        return {{"motor torque", Rounded(motor->GetMotorTorque()) + " N m"}};
    }

    void VisitState(SceneState& state) override { state(m_motor, m_slide); }

private:
    // Higher than the box flies.
    b2Body* AddGuide()
    {
        const float32 wall = kPistonHalf + 0.3f;
        b2Body* guide = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 17.5f));
        AttachBox(*guide, 0.2f, 6.5f, {}, b2Vec2(-wall, 0.0f));
        AttachBox(*guide, 0.2f, 6.5f, {}, b2Vec2(wall, 0.0f));
        return guide;
    }

    b2Joint* m_motor = nullptr; ///< a revolute joint
    b2Joint* m_slide = nullptr; ///< a prismatic joint
};

} // namespace

std::unique_ptr<Scene> MakeSliderCrank(const SceneSettings& settings)
{
    return std::make_unique<SliderCrank>(settings);
}

} // namespace boxreel
