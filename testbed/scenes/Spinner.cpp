// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfExtent = 10.0f;     ///< of the container [m]
constexpr float32 kMotorSpeed = 4.0f;      ///< [rad/s]
constexpr float32 kMotorTorque = 20000.0f; ///< [N m]
constexpr int32 kPerRow = 20;
constexpr int32 kRows = 12;
constexpr float32 kSize = 0.3f; ///< half the size of what is stirred [m]

/// A motor turns a bar in a box full of small things.
class Spinner : public Scene
{
public:
    explicit Spinner(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* box = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        for (const float32 side : {-1.0f, 1.0f})
        {
            const float32 wall = side * (kHalfExtent + 0.5f);
            AttachBox(*box, 0.5f, kHalfExtent + 1.0f, {}, b2Vec2(wall, 0.0f));
            AttachBox(*box, kHalfExtent + 1.0f, 0.5f, {}, b2Vec2(0.0f, wall));
        }
        b2Body* bar = AddBox(m_world, b2Vec2(0.0f, -2.5f), 6.5f, 0.3f, {.density = 20.0f});
        b2RevoluteJointDef hinge;
        hinge.Initialize(box, bar, bar->GetPosition());
        hinge.enableMotor = true;
        hinge.motorSpeed = kMotorSpeed;
        hinge.maxMotorTorque = kMotorTorque;
        m_motor = m_world.CreateJoint(&hinge);
        Fill();
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const auto* motor = static_cast<const b2RevoluteJoint*>(m_motor);
        const float32 turns = motor->GetJointAngle() / (2.0f * b2_pi);
        return {{"turns", std::to_string(static_cast<int32>(turns))}};
    }

    void VisitState(SceneState& state) override { state(m_motor); }

private:
    /// Balls, boxes and sticks by turns, above the bar.
    void Fill()
    {
        for (int32 i = 0; i < kPerRow * kRows; ++i)
        {
            const float32 x = 0.9f * (static_cast<float32>(i % kPerRow) - 0.5f * (kPerRow - 1));
            const b2Vec2 place(x, -1.5f + 0.9f * static_cast<float32>(i / kPerRow));
            switch (i % 3)
            {
            case 0:
                AddBall(m_world, place, kSize);
                break;
            case 1:
                AddBox(m_world, place, kSize, kSize);
                break;
            default:
                AddBox(m_world, place, 1.3f * kSize, 0.5f * kSize);
                break;
            }
        }
    }

    b2Joint* m_motor; ///< a hinge
};

} // namespace

std::unique_ptr<Scene> MakeSpinner(const SceneSettings& settings)
{
    return std::make_unique<Spinner>(settings);
}

} // namespace boxreel
