// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfLength = 1.5f;     ///< [m]
constexpr float32 kHalfThickness = 0.02f; ///< [m]
constexpr float32 kSpeed = 100.0f;        ///< downwards [m/s]
constexpr float32 kSpin = 60.0f;          ///< at most, to either side [rad/s]
constexpr float32 kPause = 1.0f;          ///< between two throws [s]
constexpr KeyBinding kKeys[] = {{'l', "throws the box again"}};

/// A box as thin as a rod, fast and spinning, thrown again and again on ground without thickness.
class SkinnyBox : public Scene
{
public:
    explicit SkinnyBox(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        AddGroundEdge(m_world, b2Vec2(-12.0f, 0.0f), b2Vec2(12.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-12.0f, 0.0f), b2Vec2(-12.0f, 12.0f));
        AddGroundEdge(m_world, b2Vec2(12.0f, 0.0f), b2Vec2(12.0f, 12.0f));
        AddGroundBox(m_world, b2Vec2(0.0f, 1.0f), 0.1f, 1.0f);
        m_box = AddBox(m_world, b2Vec2(0.0f, 10.0f), kHalfLength, kHalfThickness);
        Name(*m_box, "box");
        Throw();
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'l')
        {
            Throw();
        }
    }

    void Step(const StepSettings& settings) override
    {
        if (m_flown >= kPause)
        {
            Throw();
        }
        Scene::Step(settings);
        m_flown += settings.timeStep;
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"throws", std::to_string(m_throws)}};
    }

    void VisitState(SceneState& state) override { state(m_random, m_box, m_flown, m_throws); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 5.5f), .halfSize = b2Vec2(12.5f, 6.5f)};
    }

private:
    void Throw()
    {
        const float32 x = m_random.Between(-8.0f, 8.0f);
        const float32 angle = m_random.Between(-b2_pi, b2_pi);
        m_box->SetTransform(b2Vec2(x, 10.0f), angle);
        m_box->SetLinearVelocity(b2Vec2(0.0f, -kSpeed));
        m_box->SetAngularVelocity(m_random.Between(-kSpin, kSpin));
        m_box->SetAwake(true);
        m_flown = 0.0f;
        ++m_throws;
    }

    Random m_random;
    b2Body* m_box;
    float32 m_flown = 0.0f; ///< since the last throw [s]
    int32 m_throws = 0;
};

} // namespace

std::unique_ptr<Scene> MakeSkinnyBox(const SceneSettings& settings)
{
    return std::make_unique<SkinnyBox>(settings);
}

} // namespace boxreel
