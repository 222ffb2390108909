// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kSpeed = 2.0f;     ///< of the wheel [rad/s]
constexpr float32 kTorque = 4000.0f; ///< enough for all balls on one paddle [N m]
constexpr int32 kBallCount = 12;
constexpr float32 kReach = 4.0f; ///< of the paddles [m]
const b2Vec2 kHub(-8.0f, 8.0f);  ///< [m]
const b2Vec2 kGateHinge(3.0f, 12.0f);
const b2Vec2 kPendulumHinge(14.0f, 15.0f);

constexpr KeyBinding kKeys[] = {{'m', "switches the wheel's motor"},
                                {'d', "turns the motor round"},
                                {'l', "switches the gate's limit"}};

/// A hinge with a motor, one with a limit, and one with neither.
class Revolute : public Scene
{
public:
    explicit Revolute(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(-20.0f, 6.0f));
        AddGroundEdge(m_world, b2Vec2(20.0f, 0.0f), b2Vec2(20.0f, 6.0f));
        AddWheel();
        AddGate();
        AddPendulum();
        for (int32 i = 0; i < kBallCount; ++i)
        {
            AddBall(m_world,
                    b2Vec2(-6.0f + 0.3f * static_cast<float32>(i % 3),
                           14.0f + 1.1f * static_cast<float32>(i)),
                    0.5f, {.density = 1.0f, .restitution = 0.2f});
        }
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        auto* motor = static_cast<b2RevoluteJoint*>(m_motor);
        auto* gate = static_cast<b2RevoluteJoint*>(m_gate);
        if (key == 'm')
        {
            motor->EnableMotor(!motor->IsMotorEnabled());
        }
        if (key == 'd')
        {
            motor->SetMotorSpeed(-motor->GetMotorSpeed());
        }
        if (key == 'l')
        {
            gate->EnableLimit(!gate->IsLimitEnabled());
        }
    }

    void VisitState(SceneState& state) override { state(m_motor, m_gate); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 8.0f), .halfSize = b2Vec2(20.5f, 9.0f)};
    }

private:
    b2Body* AddPost(const b2Vec2& top) { return AddGroundBox(m_world, top, 0.3f, 0.3f); }

    // Clockwise: what falls on its right side is hurled down.
    void AddWheel()
    {
        b2Body* wheel = AddBody(m_world, b2_dynamicBody, kHub);
        Name(*wheel, "wheel");
        for (int32 i = 0; i < 3; ++i)
        {
            AttachBox(*wheel, kReach, 0.2f, {.density = 2.0f}, b2Vec2(0.0f, 0.0f),
                      static_cast<float32>(i) * b2_pi / 3.0f);
        }
        m_motor = AddMotorHinge(m_world, AddPost(kHub), wheel, kHub, -kSpeed, kTorque);
    }

    // Let go from its upper limit it falls against its lower one.
    void AddGate()
    {
        b2Body* gate =
            AddBox(m_world, kGateHinge + b2Vec2(2.5f, 0.0f), 2.5f, 0.25f, {.density = 5.0f});
        Name(*gate, "gate");
        m_gate =
            AddLimitedHinge(m_world, AddPost(kGateHinge), gate, kGateHinge, -0.25f * b2_pi, 0.0f);
    }

    void AddPendulum()
    {
        const b2Vec2 ball = kPendulumHinge + b2Vec2(4.0f, -5.0f);
        b2Body* pendulum = AddBall(m_world, ball, 1.2f, {.density = 5.0f});
        Name(*pendulum, "pendulum");
        AddHinge(m_world, AddPost(kPendulumHinge), pendulum, kPendulumHinge);
    }

    b2Joint* m_motor = nullptr; ///< revolute joints both
    b2Joint* m_gate = nullptr;
};

} // namespace

std::unique_ptr<Scene> MakeRevolute(const SceneSettings& settings)
{
    return std::make_unique<Revolute>(settings);
}

} // namespace boxreel
