// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <cmath>

namespace boxreel
{

namespace
{

constexpr int32 kStages = 3;
constexpr float32 kBar = 5.0f;       ///< from end to end [m]
constexpr float32 kFlattest = 0.2f;  ///< of the bars, against the ground [rad]
constexpr float32 kSteepest = 0.95f; ///< [rad]
constexpr float32 kFoot = 0.6f;      ///< height of the lowest hinges [m]
constexpr float32 kLeft = -2.5f;     ///< where the hinges are that do not slide [m]
constexpr float32 kRise = 1.5f;      ///< how fast the platform goes up and down [m/s]
constexpr float32 kForce = 2e4f;     ///< of the motor; folded up, the bars take most of it [N]
constexpr int16 kLiftGroup = -1;     ///< bars pass each other
constexpr Material kSteel{.density = 1.0f};
constexpr Material kCrate{.density = 2.0f};

// By itself it goes up, waits there, and comes down again.
constexpr float32 kUp = 6.0f;      ///< [s]
constexpr float32 kWait = 2.0f;    ///< [s]
constexpr float32 kPeriod = 14.0f; ///< [s]

constexpr KeyBinding kKeys[] = {{'w', "raises the platform"}, {'s', "lowers the platform"}};

/// Bars crossed in stages: a motor draws their feet together, and the platform rises with its load.
/// The ratio of the platform's speed to that of the feet depends on the angle of the bars. The
/// motor speed is set so that the platform rises evenly.
class ScissorLift : public Scene
{
public:
    explicit ScissorLift(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // bars and hinges make loops, which share the load exactly
        b2Body* ground = AddGroundEdge(m_world, b2Vec2(-12.0f, 0.0f), b2Vec2(12.0f, 0.0f));
        AttachBox(*ground, 4.0f, 0.15f, {}, b2Vec2(kLeft + 3.0f, 0.15f));
        b2Body* leftFoot = ground;
        b2Body* rightFoot = AddCarriage(RightHinge(0));
        m_motor =
            AddMotorSlide(m_world, ground, rightFoot, RightHinge(0), b2Vec2(1.0f, 0.0f),
                          kBar * (b2Rot(kSteepest).c - b2Rot(kFlattest).c), 0.0f, 0.0f, kForce);
        for (int32 stage = 0; stage < kStages; ++stage)
        {
            b2Body* up = AddBar(LeftHinge(stage), RightHinge(stage + 1), kFlattest);
            b2Body* down = AddBar(LeftHinge(stage + 1), RightHinge(stage), -kFlattest);
            AddHinge(m_world, up, down, up->GetPosition());
            AddHinge(m_world, leftFoot, up, LeftHinge(stage));
            AddHinge(m_world, rightFoot, down, RightHinge(stage));
            leftFoot = down;
            rightFoot = up;
            m_bar = up;
        }
        AddPlatform(leftFoot, rightFoot);
    }

    void Step(const StepSettings& settings) override
    {
        if (!m_isSteered)
        {
            const float32 time = m_time - kPeriod * std::floor(m_time / kPeriod);
            m_direction = time < kUp ? 1 : time < kUp + kWait ? 0 : -1;
        }
        const b2Rot& turned = m_bar->GetTransform().q;
        const float32 perMetre = turned.s / (turned.c * static_cast<float32>(kStages));
        static_cast<b2PrismaticJoint*>(m_motor)->SetMotorSpeed(-kRise * perMetre *
                                                               static_cast<float32>(m_direction));
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'w' || key == 's')
        {
            m_isSteered = true;
            m_direction = key == 'w' ? 1 : -1;
            m_platform->SetAwake(true);
        }
    }

    void KeyUp(char key) override { m_direction = key == 'w' || key == 's' ? 0 : m_direction; }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const auto* motor = static_cast<const b2PrismaticJoint*>(m_motor);
        return {{"platform", m_direction > 0   ? "rises"
                             : m_direction < 0 ? "comes down"
                                               : "is held"},
                {"motor", WithUnit(b2Abs(motor->GetMotorForce()), "N")}};
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.5f), .halfSize = b2Vec2(8.0f, 8.0f)};
    }

    void VisitState(SceneState& state) override
    {
        state(m_motor, m_bar, m_platform, m_time, m_pace, m_direction, m_isSteered);
    }

private:
    // Returns the point where the ends of the bars meet before the first step; stage 0 is the
    // lowest.
    static b2Vec2 LeftHinge(int32 stage)
    {
        return {kLeft, kFoot + kBar * b2Rot(kFlattest).s * static_cast<float32>(stage)};
    }
    static b2Vec2 RightHinge(int32 stage)
    {
        return LeftHinge(stage) + b2Vec2(kBar * b2Rot(kFlattest).c, 0.0f);
    }

    b2Body* AddBar(const b2Vec2& from, const b2Vec2& to, float32 angle)
    {
        b2Body* bar = AddBox(m_world, 0.5f * (from + to), 0.5f * kBar + 0.1f, 0.1f, kSteel, angle);
        SetGroup(*bar, kLiftGroup);
        return bar;
    }

    b2Body* AddCarriage(const b2Vec2& place)
    {
        b2Body* carriage = AddBox(m_world, place, 0.25f, 0.12f, kSteel);
        SetGroup(*carriage, kLiftGroup);
        return carriage;
    }

    /// A hinge on the left, a slide on the right, and crates on top.
    void AddPlatform(b2Body* left, b2Body* right)
    {
        const b2Vec2 middle = 0.5f * (LeftHinge(kStages) + RightHinge(kStages));
        m_platform = AddBox(m_world, middle, 3.0f, 0.15f, kSteel);
        for (const float32 side : {-1.0f, 1.0f})
        {
            AttachBox(*m_platform, 0.1f, 0.4f, kSteel, b2Vec2(side * 2.9f, 0.5f));
        }
        SetGroup(*m_platform, kLiftGroup);
        Name(*m_platform, "platform");
        AddHinge(m_world, m_platform, left, LeftHinge(kStages));
        b2Body* carriage = AddCarriage(RightHinge(kStages));
        AddSlide(m_world, m_platform, carriage, RightHinge(kStages), b2Vec2(1.0f, 0.0f));
        AddHinge(m_world, carriage, right, RightHinge(kStages));
        for (const b2Vec2& place :
             {b2Vec2(-1.6f, 0.8f), b2Vec2(0.0f, 0.8f), b2Vec2(1.6f, 0.8f), b2Vec2(0.0f, 2.0f)})
        {
            AddBox(m_world, middle + place, 0.6f, 0.6f, kCrate);
        }
    }

    b2Joint* m_motor = nullptr; ///< of the lowest slide
    b2Body* m_bar = nullptr;    ///< one that rises to the right; all are as steep
    b2Body* m_platform = nullptr;
    float32 m_time = 0.0f; ///< [s]
    float32 m_pace = 0.0f; ///< share of the full one, up or down
    int32 m_direction = 0; ///< it goes to: 1 up, -1 down
    bool m_isSteered = false;
};

} // namespace

std::unique_ptr<Scene> MakeScissorLift(const SceneSettings& settings)
{
    return std::make_unique<ScissorLift>(settings);
}

} // namespace boxreel
