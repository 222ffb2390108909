// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kReach = 6.0f;        ///< of the eight, to either side [m]
constexpr float32 kRise = 2.5f;         ///< of the eight [m]
const b2Vec2 kMiddle(0.0f, 7.0f);       ///< [m]
constexpr float32 kPace = 1.0f;         ///< along the eight [rad/s]
constexpr float32 kMaxForce = 1000.0f;  ///< [N]; the plate weighs 160 N
constexpr float32 kMaxTorque = 1000.0f; ///< [N m]

constexpr KeyBinding kKeys[] = {{'s', "stops and goes on"}};

/// A plate is driven along an eight and rotated, with a limited force. It pushes light boxes aside.
/// The cross shows its target.
class MotorJoint : public Scene
{
public:
    explicit MotorJoint(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* ground = AddGroundEdge(m_world, b2Vec2(-16.0f, 0.0f), b2Vec2(16.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-16.0f, 0.0f), b2Vec2(-16.0f, 4.0f));
        AddGroundEdge(m_world, b2Vec2(16.0f, 0.0f), b2Vec2(16.0f, 4.0f));
        b2Body* plate = AddBox(m_world, kMiddle, 2.0f, 0.5f, {.density = 4.0f});
        Name(*plate, "plate");
        for (int32 i = 0; i < 5; ++i)
        {
            for (float32 x : {-7.8f, 7.8f})
            {
                AddBox(m_world, b2Vec2(x, 0.8f + 1.6f * static_cast<float32>(i)), 0.8f, 0.8f,
                       {.density = 0.5f});
            }
        }
        b2MotorJointDef motor;
        motor.Initialize(ground, plate);
        motor.maxForce = kMaxForce;
        motor.maxTorque = kMaxTorque;
        m_motor = m_world.CreateJoint(&motor);
    }

    void Step(const StepSettings& settings) override
    {
        auto* motor = static_cast<b2MotorJoint*>(m_motor);
        if (!m_stopped)
        {
            m_time += settings.timeStep;
        }
        motor->SetLinearOffset(Target());
        motor->SetAngularOffset(2.0f * kPace * m_time);
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 's')
        {
            m_stopped = !m_stopped;
        }
    }

    void Draw(b2Draw& draw) const override
    {
        const b2Color color(0.9f, 0.9f, 0.4f);
        draw.DrawSegment(Target() - b2Vec2(0.5f, 0.0f), Target() + b2Vec2(0.5f, 0.0f), color);
        draw.DrawSegment(Target() - b2Vec2(0.0f, 0.5f), Target() + b2Vec2(0.0f, 0.5f), color);
    }

    void VisitState(SceneState& state) override { state(m_motor, m_stopped, m_time); }

private:
    // b2Rot, not the library's sine: the same bits everywhere.
    b2Vec2 Target() const
    {
        const b2Rot once(kPace * m_time);
        const b2Rot twice(2.0f * kPace * m_time);
        return kMiddle + b2Vec2(kReach * once.s, kRise * twice.s);
    }

    b2Joint* m_motor; ///< a motor joint
    bool m_stopped = false;
    float32 m_time = 0.0f; ///< along the path [s]
};

} // namespace

std::unique_ptr<Scene> MakeMotorJoint(const SceneSettings& settings)
{
    return std::make_unique<MotorJoint>(settings);
}

} // namespace boxreel
