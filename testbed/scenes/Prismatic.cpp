// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

const b2Vec2 kStart(-8.0f, 5.0f);  ///< of the slide [m]
const b2Vec2 kAxis(0.8f, 0.6f);    ///< the 3-4-5 triangle: a unit vector as it stands
constexpr float32 kTravel = 18.0f; ///< from limit to limit [m]
constexpr float32 kSpeed = 4.0f;   ///< [m/s]
// The carriage and its load weigh down the slide with 120 N; more force would turn it round so
// hard that the load is thrown out.
constexpr float32 kForce = 220.0f; ///< [N]
constexpr float32 kNear = 1.6f;    ///< to a limit, where the motor turns round [m]

constexpr KeyBinding kKeys[] = {
    {'l', "switches the limits"}, {'m', "switches the motor"}, {'s', "turns the motor round"}};

/// A carriage goes up and down a slanting slide between two limits and carries boxes; it cannot
/// turn, however they lie.
class Prismatic : public Scene
{
public:
    explicit Prismatic(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-20.0f, 0.0f), b2Vec2(20.0f, 0.0f));
        // Marks its ends, below what the carriage and its load pass through.
        b2Body* ground = AddBody(m_world, b2_staticBody, kStart);
        AttachBox(*ground, 0.4f, 0.4f, {}, b2Vec2(0.0f, -3.0f));
        AttachBox(*ground, 0.4f, 0.4f, {}, kTravel * kAxis - b2Vec2(0.0f, 3.0f));
        b2Body* carriage = AddBody(m_world, b2_dynamicBody, kStart);
        Name(*carriage, "carriage");
        AttachBox(*carriage, 2.5f, 0.25f, {.density = 4.0f, .friction = 0.9f});
        AttachBox(*carriage, 0.25f, 0.6f, {.density = 4.0f}, b2Vec2(-2.25f, 0.8f));
        AttachBox(*carriage, 0.25f, 0.6f, {.density = 4.0f}, b2Vec2(2.25f, 0.8f));
        m_slide =
            AddMotorSlide(m_world, ground, carriage, kStart, kAxis, 0.0f, kTravel, kSpeed, kForce);
        for (int32 i = 0; i < 3; ++i)
        {
            AddBox(m_world, kStart + b2Vec2(1.2f * static_cast<float32>(i - 1), 0.8f), 0.5f, 0.5f,
                   {.density = 2.0f, .friction = 0.9f});
        }
    }

    void Step(const StepSettings& settings) override
    {
        TurnRoundAtLimits();
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        Slide().GetBodyB()->SetAwake(true);
        if (key == 'l')
        {
            Slide().EnableLimit(!Slide().IsLimitEnabled());
        }
        if (key == 'm')
        {
            Slide().EnableMotor(!Slide().IsMotorEnabled());
        }
        if (key == 's')
        {
            Slide().SetMotorSpeed(-Slide().GetMotorSpeed());
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"translation", Rounded(Slide().GetJointTranslation()) + " m"},
                {"motor force", Rounded(Slide().GetMotorForce()) + " N"}};
    }

    void Draw(b2Draw& draw) const override
    {
        draw.BeginLayer(b2Draw::e_jointBit); // themes give it their colour of joints
        draw.DrawSegment(kStart, kStart + kTravel * kAxis, b2Color(0.5f, 0.8f, 0.8f));
    }

    void VisitState(SceneState& state) override { state(m_slide); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 9.0f), .halfSize = b2Vec2(14.0f, 9.5f)};
    }

private:
    b2PrismaticJoint& Slide() const { return *static_cast<b2PrismaticJoint*>(m_slide); }

    void TurnRoundAtLimits()
    {
        const float32 at = Slide().GetJointTranslation();
        if (Slide().IsLimitEnabled() && at < kNear)
        {
            Slide().SetMotorSpeed(kSpeed);
        }
        if (Slide().IsLimitEnabled() && at > kTravel - kNear)
        {
            Slide().SetMotorSpeed(-kSpeed);
        }
    }

    b2Joint* m_slide; ///< a prismatic joint
};

} // namespace

std::unique_ptr<Scene> MakePrismatic(const SceneSettings& settings)
{
    return std::make_unique<Prismatic>(settings);
}

} // namespace boxreel
