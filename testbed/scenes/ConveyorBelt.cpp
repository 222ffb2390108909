// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <cmath>

namespace boxreel
{

namespace
{

constexpr float32 kSpeed = 4.0f;          ///< [m/s]
constexpr float32 kHalfLength = 7.0f;     ///< of a belt [m]
constexpr float32 kHalfThickness = 0.25f; ///< [m]
constexpr float32 kMarkStep = 1.0f;       ///< from mark to mark on the belts [m]

constexpr int32 kCrateCount = 14;
constexpr float32 kCrateEvery = 0.7f; ///< [s]
constexpr float32 kHalfSize = 0.45f;  ///< of a crate [m]

constexpr KeyBinding kKeys[] = {{'s', "stops the belts or lets them run"},
                                {'t', "turns them round"}};

/// Belts are static: their surface moves because their contacts have a tangent speed.
class ConveyorBelt : public Scene, private b2ContactListener
{
public:
    explicit ConveyorBelt(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(14.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-14.0f, 0.0f), b2Vec2(-14.0f, 4.0f));
        AddGroundEdge(m_world, b2Vec2(14.0f, 0.0f), b2Vec2(14.0f, 10.0f));
        m_upper = AddGroundBox(m_world, b2Vec2(-3.0f, 8.0f), kHalfLength, kHalfThickness);
        m_lower = AddGroundBox(m_world, b2Vec2(3.0f, 4.0f), kHalfLength, kHalfThickness);
        m_world.SetContactListener(this);
    }

    ~ConveyorBelt() override { m_world.SetContactListener(nullptr); }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        if (m_crates < kCrateCount && m_time >= kCrateEvery * static_cast<float32>(m_crates))
        {
            AddBox(m_world, b2Vec2(-9.0f, 10.0f), kHalfSize, kHalfSize);
            ++m_crates;
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
        m_wayRun += settings.timeStep * m_speed;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 's')
        {
            m_speed = m_speed == 0.0f ? m_direction * kSpeed : 0.0f;
        }
        if (key == 't')
        {
            m_direction = -m_direction;
            m_speed = -m_speed;
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"belts", WithUnit(m_speed, "m/s")}};
    }

    void Draw(b2Draw& draw) const override
    {
        DrawMarks(draw, *m_upper, m_wayRun);
        DrawMarks(draw, *m_lower, -m_wayRun);
    }

    void VisitState(SceneState& state) override
    {
        state(m_upper, m_lower, m_time, m_crates, m_speed, m_direction, m_wayRun);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 5.25f), .halfSize = b2Vec2(14.5f, 6.0f)};
    }

private:
    // Friction drives B's velocity relative to A's, along the normal turned clockwise, to this
    // speed. The normal points to B. A belt below therefore moves bodies to the right, for either
    // order of the two.
    void PreSolve(b2Contact* contact, const b2Manifold*) override
    {
        const b2Body* a = contact->GetFixtureA()->GetBody();
        const b2Body* b = contact->GetFixtureB()->GetBody();
        contact->SetTangentSpeed(SpeedOf(a) + SpeedOf(b));
    }

    /// Returns the speed of its upper side to the right [m/s]. The lower belt runs in the opposite
    /// direction.
    float32 SpeedOf(const b2Body* body) const
    {
        return body == m_upper ? m_speed : body == m_lower ? -m_speed : 0.0f;
    }

    void DrawMarks(b2Draw& draw, const b2Body& belt, float32 way) const
    {
        const float32 phase = way / kMarkStep - std::floor(way / kMarkStep);
        const int32 count = static_cast<int32>(2.0f * kHalfLength / kMarkStep);
        for (int32 i = 0; i < count; ++i)
        {
            const float32 x = -kHalfLength + kMarkStep * (static_cast<float32>(i) + phase);
            draw.DrawSegment(belt.GetWorldPoint(b2Vec2(x, kHalfThickness)),
                             belt.GetWorldPoint(b2Vec2(x, -kHalfThickness)), kOrange);
        }
    }

    b2Body* m_upper;
    b2Body* m_lower;
    float32 m_time = 0.0f; ///< [s]
    int32 m_crates = 0;
    float32 m_speed = kSpeed;   ///< of the upper belt, to the right [m/s]
    float32 m_direction = 1.0f; ///< in which they run when they do not stand
    float32 m_wayRun = 0.0f;    ///< of the upper belt [m]
};

} // namespace

std::unique_ptr<Scene> MakeConveyorBelt(const SceneSettings& settings)
{
    return std::make_unique<ConveyorBelt>(settings);
}

} // namespace boxreel
