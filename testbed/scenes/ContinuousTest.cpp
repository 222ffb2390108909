// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfLength = 2.0f;     ///< of the bar [m]
constexpr float32 kHalfThickness = 0.05f; ///< of the bar [m]
constexpr float32 kThrowEvery = 1.5f;     ///< [s]
constexpr float32 kSpeed = 100.0f;        ///< downwards: 1.7 m a step [m/s]
constexpr float32 kMaxSpin = 50.0f;       ///< [rad/s]
const b2Vec2 kStart(0.0f, 12.0f);         ///< [m]

constexpr KeyBinding kKeys[] = {{'c', "switches continuous collision off or on"},
                                {'t', "throws the bar"}};

/// Floor, walls and ceiling are edges, without thickness. With continuous collision off the bar
/// gets through.
class ContinuousTest : public Scene
{
public:
    explicit ContinuousTest(const SceneSettings& settings)
        : Scene(settings), m_random(settings.seed)
    {
        m_floor = AddGroundEdge(m_world, b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-10.0f, 0.0f), b2Vec2(-10.0f, 14.0f));
        AddGroundEdge(m_world, b2Vec2(10.0f, 0.0f), b2Vec2(10.0f, 14.0f));
        AddGroundEdge(m_world, b2Vec2(-10.0f, 14.0f), b2Vec2(10.0f, 14.0f));
        AddGroundBox(m_world, b2Vec2(0.0f, 0.5f), 0.2f, 0.5f);
        m_bar = AddBox(m_world, kStart, kHalfLength, kHalfThickness);
    }

    void Step(const StepSettings& settings) override
    {
        if (m_time >= kThrowEvery * static_cast<float32>(m_throws))
        {
            Throw();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'c')
        {
            m_world.SetContinuousPhysics(!m_world.GetContinuousPhysics());
        }
        if (key == 't')
        {
            Throw();
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"continuous", m_world.GetContinuousPhysics() ? "on" : "off"}};
    }

    void VisitState(SceneState& state) override
    {
        state(m_floor, m_bar, m_random, m_throws, m_time);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 7.0f), .halfSize = b2Vec2(10.5f, 7.5f)};
    }

private:
    void Throw()
    {
        const float32 angle = m_random.Between(-b2_pi, b2_pi);
        const float32 spin = m_random.Between(-kMaxSpin, kMaxSpin);
        m_bar->SetTransform(m_floor->GetWorldPoint(kStart), angle);
        m_bar->SetLinearVelocity(b2Vec2(0.0f, -kSpeed));
        m_bar->SetAngularVelocity(spin);
        m_bar->SetAwake(true);
        ++m_throws;
    }

    b2Body* m_floor;
    b2Body* m_bar;
    Random m_random;
    int32 m_throws = 0;
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeContinuousTest(const SceneSettings& settings)
{
    return std::make_unique<ContinuousTest>(settings);
}

} // namespace boxreel
