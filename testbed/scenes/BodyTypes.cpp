// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHeight = 6.0f;      ///< of the platform [m]
constexpr float32 kHalfLength = 5.0f;  ///< of the platform [m]
constexpr float32 kReach = 8.0f;       ///< of its path, left and right [m]
constexpr float32 kSpeed = 2.0f;       ///< when it is kinematic [m/s]
constexpr float32 kRamSpeed = 9.0f;    ///< [m/s]
constexpr float32 kChangeEvery = 3.0f; ///< until a key is pressed [s]

constexpr KeyBinding kKeys[] = {{'d', "makes the platform dynamic"},
                                {'s', "makes the platform static"},
                                {'k', "makes the platform kinematic"}};

/// A platform on a slide, with crates on it. Kinematic, it moves to and fro under any load. Static,
/// it does not move. Dynamic, it is pushed by bodies that touch it and keeps its speed. The scene
/// switches between the three types in turn.
class BodyTypes : public Scene
{
public:
    explicit BodyTypes(const SceneSettings& settings) : Scene(settings)
    {
        m_ground = AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(18.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(-18.0f, 5.0f));
        AddGroundEdge(m_world, b2Vec2(18.0f, 0.0f), b2Vec2(18.0f, 5.0f));
        m_platform = AddBody(m_world, b2_kinematicBody, b2Vec2(0.0f, kHeight));
        AttachBox(*m_platform, kHalfLength, 0.4f, {.density = 2.0f});
        const b2Vec2 along(1.0f, 0.0f);
        AddMotorSlide(m_world, m_ground, m_platform, b2Vec2(0.0f, kHeight), along, -kReach - 2.0f,
                      kReach + 2.0f, 0.0f, 10.0f); // a brake, for when it is dynamic
        m_platform->SetLinearVelocity(kSpeed * along);
        for (const float32 x : {-3.0f, 0.0f, 3.0f})
        {
            AddBox(m_world, b2Vec2(x, kHeight + 1.1f), 0.7f, 0.7f)
                ->SetLinearVelocity(kSpeed * along);
        }
        // Hits the platform while it is dynamic.
        m_ram = AddBall(m_world, b2Vec2(-12.0f, kHeight), 0.8f, {.density = 4.0f});
        m_ram->SetGravityScale(0.0f);
    }

    void Step(const StepSettings& settings) override
    {
        if (!m_isSteered && m_time >= kChangeEvery * static_cast<float32>(m_changes + 1))
        {
            constexpr char kTurns[] = {'s', 'd', 'k'};
            Become(kTurns[m_changes % 3]);
            ++m_changes;
        }
        if (m_platform->GetType() == b2_kinematicBody)
        {
            TurnBackAtTheEnds();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        m_isSteered = true;
        Become(key);
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2BodyType type = m_platform->GetType();
        return {{"platform", type == b2_staticBody      ? "static"
                             : type == b2_kinematicBody ? "kinematic"
                                                        : "dynamic"}};
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 4.5f), .halfSize = b2Vec2(18.5f, 5.5f)};
    }

    void VisitState(SceneState& state) override
    {
        state(m_ground, m_platform, m_ram, m_time, m_changes, m_isSteered);
    }

private:
    void Become(char key)
    {
        if (key == 's')
        {
            m_platform->SetType(b2_staticBody);
        }
        if (key == 'd')
        {
            m_platform->SetType(b2_dynamicBody);
            m_ram->SetLinearVelocity(b2Vec2(kRamSpeed, 0.0f));
        }
        if (key == 'k')
        {
            m_platform->SetType(b2_kinematicBody);
            m_platform->SetLinearVelocity(b2Vec2(kSpeed, 0.0f));
            m_platform->SetAngularVelocity(0.0f);
        }
    }

    void TurnBackAtTheEnds()
    {
        const float32 x = m_platform->GetPosition().x - m_ground->GetPosition().x;
        const b2Vec2 velocity = m_platform->GetLinearVelocity();
        if (b2Abs(x) > kReach && x * velocity.x > 0.0f)
        {
            m_platform->SetLinearVelocity(-velocity);
        }
    }

    b2Body* m_ground;
    b2Body* m_platform;
    b2Body* m_ram;
    float32 m_time = 0.0f; ///< [s]
    int32 m_changes = 0;   ///< that the scene has made by itself
    bool m_isSteered = false;
};

} // namespace

std::unique_ptr<Scene> MakeBodyTypes(const SceneSettings& settings)
{
    return std::make_unique<BodyTypes>(settings);
}

} // namespace boxreel
