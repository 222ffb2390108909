// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kFloors = 3;
constexpr float32 kFloorStep = 4.0f;      ///< from top to top [m]
constexpr float32 kHalfThickness = 0.25f; ///< [m]
constexpr float32 kHalfWidth = 6.0f;      ///< [m]
constexpr float32 kRadius = 0.5f;         ///< of the climber [m]

constexpr float32 kLeap = 10.5f;     ///< 5.5 m high: past the next platform with room [m/s]
constexpr float32 kFirstLeap = 0.5f; ///< [s]
constexpr float32 kLeapEvery = 2.5f; ///< time to land and come to rest [s]
constexpr float32 kWalk = 4.0f;      ///< when a key is held [m/s]

// A body at rest on a platform overlaps it by the engine's slop, a landing body by a little more. A
// body from below overlaps it by its own size.
constexpr float32 kTolerance = 0.1f; ///< [m]

constexpr KeyBinding kKeys[] = {
    {'a', "rolls to the left"}, {'d', "rolls to the right"}, {'w', "leaps"}};

float32 LowestPoint(const b2Fixture& fixture)
{
    b2AABB box;
    fixture.GetShape()->ComputeAABB(&box, fixture.GetBody()->GetTransform(), 0);
    return box.lowerBound.y;
}

/// The only static boxes.
bool IsPlatform(const b2Fixture& fixture)
{
    return fixture.GetBody()->GetType() == b2_staticBody && fixture.GetType() == b2Shape::e_polygon;
}

bool IsAbove(const b2Fixture& fixture, const b2Fixture& platform)
{
    const float32 top = platform.GetBody()->GetPosition().y + kHalfThickness;
    return LowestPoint(fixture) > top - kTolerance;
}

/// Contacts with bodies that are not above a platform are disabled in each step.
class OneSidedPlatform : public Scene, private b2ContactListener
{
public:
    explicit OneSidedPlatform(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
        for (int32 i = 1; i <= kFloors; ++i)
        {
            const float32 top = kFloorStep * static_cast<float32>(i);
            AddGroundBox(m_world, b2Vec2(0.0f, top - kHalfThickness), kHalfWidth, kHalfThickness);
            const float32 side = i % 2 == 0 ? 1.0f : -1.0f;
            AddBox(m_world, b2Vec2(3.5f * side, top + 0.5f), 0.5f, 0.5f);
            AddBox(m_world, b2Vec2(3.5f * side, top + 1.5f), 0.5f, 0.5f);
            AddBox(m_world, b2Vec2(-3.0f * side, top + 0.35f), 1.2f, 0.35f);
        }
        // A brisk one: all three in one go, and it stays up there.
        b2Body* brisk = AddBall(m_world, b2Vec2(1.5f, kRadius), kRadius);
        brisk->SetLinearVelocity(b2Vec2(0.0f, 16.5f));
        m_climber = AddBall(m_world, b2Vec2(0.0f, kRadius), kRadius);
        m_climber->SetAngularDamping(2.0f);
        m_world.SetContactListener(this);
    }

    ~OneSidedPlatform() override { m_world.SetContactListener(nullptr); }

    void Step(const StepSettings& settings) override
    {
        if (!m_isSteered && m_time >= kFirstLeap + kLeapEvery * static_cast<float32>(m_leaps))
        {
            Leap();
        }
        if (m_walk != 0)
        {
            const float32 speed = kWalk * static_cast<float32>(m_walk);
            m_climber->SetAwake(true);
            m_climber->SetLinearVelocity(b2Vec2(speed, m_climber->GetLinearVelocity().y));
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        m_isSteered = m_isSteered || key == 'a' || key == 'd' || key == 'w';
        if (key == 'w')
        {
            Leap();
        }
        m_walk = key == 'a' ? -1 : key == 'd' ? 1 : m_walk;
    }

    void KeyUp(char key) override { m_walk = key == 'a' || key == 'd' ? 0 : m_walk; }

    void VisitState(SceneState& state) override
    {
        state(m_climber, m_time, m_leaps, m_walk, m_isSteered);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 8.75f), .halfSize = b2Vec2(10.5f, 9.75f)};
    }

private:
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        const b2Fixture& a = *contact->GetFixtureA();
        const b2Fixture& b = *contact->GetFixtureB();
        if ((IsPlatform(a) && !IsAbove(b, a)) || (IsPlatform(b) && !IsAbove(a, b)))
        {
            contact->SetEnabled(false);
        }
    }

    void Leap()
    {
        m_climber->SetLinearVelocity(b2Vec2(0.0f, kLeap));
        ++m_leaps;
    }

    b2Body* m_climber;
    float32 m_time = 0.0f; ///< [s]
    int32 m_leaps = 0;
    int32 m_walk = 0; ///< -1 to the left, 1 to the right
    bool m_isSteered = false;
};

} // namespace

std::unique_ptr<Scene> MakeOneSidedPlatform(const SceneSettings& settings)
{
    return std::make_unique<OneSidedPlatform>(settings);
}

} // namespace boxreel
