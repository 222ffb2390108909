// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalfExtent = 8.0f; ///< of the room [m]
constexpr float32 kRadius = 0.5f;     ///< of a ball [m]
constexpr float32 kSpeed = 20.0f;     ///< of a new ball [m/s]
constexpr int32 kBallCount = 80;
constexpr float32 kBallEvery = 0.1f; ///< [s]
constexpr KeyBinding kKeys[] = {{'c', "throws in another ball"}};

// They keep their speed, at the walls and among each other.
constexpr Material kBall{.density = 1.0f, .friction = 0.0f, .restitution = 1.0f};

/// A closed room of edges without thickness, without gravity, ever more fast balls: none gets out.
class Confined : public Scene
{
public:
    explicit Confined(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        const b2Vec2 corners[] = {{-kHalfExtent, -kHalfExtent},
                                  {kHalfExtent, -kHalfExtent},
                                  {kHalfExtent, kHalfExtent},
                                  {-kHalfExtent, kHalfExtent}};
        for (int32 i = 0; i < 4; ++i)
        {
            AddGroundEdge(m_world, corners[i], corners[(i + 1) % 4]);
        }
        ThrowIn();
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        const bool isTime = m_time >= kBallEvery * static_cast<float32>(m_balls);
        if (m_balls < kBallCount && isTime && IsDoorFree())
        {
            ThrowIn();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'c' && IsDoorFree())
        {
            ThrowIn();
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"balls", std::to_string(m_balls)}};
    }

    void ShiftOrigin(const b2Vec2& newOrigin) override
    {
        Scene::ShiftOrigin(newOrigin);
        m_door -= newOrigin;
    }

    void VisitState(SceneState& state) override
    {
        state(m_random, m_balls, m_time, m_door.x, m_door.y);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(8.5f, 8.5f)};
    }

private:
    /// No ball is where a new one would be.
    bool IsDoorFree() const
    {
        for (const b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            if (body->GetType() == b2_dynamicBody &&
                b2Distance(body->GetPosition(), m_door) < 2.0f * kRadius)
            {
                return false;
            }
        }
        return true;
    }

    void ThrowIn()
    {
        const b2Rot direction(m_random.Between(0.25f * b2_pi, 0.75f * b2_pi));
        b2Body* ball = AddBall(m_world, m_door, kRadius, kBall);
        ball->SetLinearVelocity(kSpeed * direction.GetXAxis());
        ++m_balls;
    }

    Random m_random;
    int32 m_balls = 0;
    float32 m_time = 0.0f;                              ///< [s]
    b2Vec2 m_door{0.0f, -kHalfExtent + 2.0f * kRadius}; ///< where balls come in [m]
};

} // namespace

std::unique_ptr<Scene> MakeConfined(const SceneSettings& settings)
{
    return std::make_unique<Confined>(settings);
}

} // namespace boxreel
