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

const b2Vec2 kCenter(0.0f, 9.0f);       ///< of the sensor [m]
constexpr float32 kSensorRadius = 5.0f; ///< [m]

// Four times gravity, so caught bodies stay. The drag takes the speed of the fall.
constexpr float32 kPull = 40.0f; ///< towards the centre [m/s^2]
constexpr float32 kDrag = 1.5f;  ///< within the sensor [1/s]

constexpr int32 kBallCount = 20;
constexpr float32 kBallEvery = 0.4f; ///< [s]
constexpr float32 kReach = 8.0f;     ///< how far from the middle they fall at most [m]

bool IsTouchingSensor(const b2Contact& contact)
{
    return contact.IsTouching() &&
           (contact.GetFixtureA()->IsSensor() || contact.GetFixtureB()->IsSensor());
}

/// A sensor detects the bodies in it and does not collide. The scene applies the pull.
class SensorTest : public Scene
{
public:
    explicit SensorTest(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        AddGroundEdge(m_world, b2Vec2(-11.0f, 0.0f), b2Vec2(11.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-11.0f, 0.0f), b2Vec2(-11.0f, 16.0f));
        AddGroundEdge(m_world, b2Vec2(11.0f, 0.0f), b2Vec2(11.0f, 16.0f));
        m_trap = AddBody(m_world, b2_staticBody, kCenter);
        AttachCircle(*m_trap, kSensorRadius, {})->SetSensor(true);
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        if (m_balls < kBallCount && m_time >= kBallEvery * static_cast<float32>(m_balls))
        {
            const float32 x = m_random.Between(-kReach, kReach);
            const float32 radius = m_random.Between(0.3f, 0.6f);
            AddBall(m_world, b2Vec2(x, 17.0f), radius);
            ++m_balls;
        }
        ForEachCaught([this](b2Body& body) {
            b2Vec2 inward = m_trap->GetPosition() - body.GetWorldCenter();
            const float32 distance = inward.Length();
            // Even close to the centre it does not jump from side to side.
            const float32 pull = kPull * b2Min(distance, 1.0f);
            inward.Normalize();
            body.ApplyForceToCenter(body.GetMass() *
                                    (pull * inward - kDrag * body.GetLinearVelocity()));
        });
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        int32 count = 0;
        ForEachCaught([&count](b2Body&) { ++count; });
        return {{"in the sensor", std::to_string(count)}};
    }

    void Draw(b2Draw& draw) const override
    {
        ForEachCaught([&](b2Body& body) {
            draw.DrawSegment(m_trap->GetPosition(), body.GetWorldCenter(), kOrange);
        });
    }

    void VisitState(SceneState& state) override { state(m_trap, m_random, m_balls, m_time); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 8.75f), .halfSize = b2Vec2(11.5f, 9.25f)};
    }

private:
    template <class Do>
    void ForEachCaught(const Do& act) const
    {
        for (b2ContactEdge* edge = m_trap->GetContactList(); edge != nullptr; edge = edge->next)
        {
            if (IsTouchingSensor(*edge->contact))
            {
                act(*edge->other);
            }
        }
    }

    b2Body* m_trap;
    Random m_random;
    int32 m_balls = 0;
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeSensorTest(const SceneSettings& settings)
{
    return std::make_unique<SensorTest>(settings);
}

} // namespace boxreel
