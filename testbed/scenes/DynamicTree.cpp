// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Random.h>
#include <scenes/Samples.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBodyCount = 48;
constexpr float32 kReach = 10.0f;   ///< of the field they move in, from its middle [m]
constexpr float32 kMaxSpeed = 3.0f; ///< along each axis [m/s]

constexpr float32 kTurningSpeed = 0.6f; ///< of probe and ray [rad/s]
constexpr float32 kProbeOrbit = 5.0f;   ///< [m]
const b2Vec2 kProbeReach(2.5f, 2.0f);   ///< from its middle [m]

class Found : public b2QueryCallback
{
public:
    bool ReportFixture(b2Fixture* fixture) override
    {
        fixtures.push_back(fixture);
        return true;
    }

    std::vector<const b2Fixture*> fixtures;
};

class Closest : public b2RayCastCallback
{
public:
    float32 ReportFixture(b2Fixture* hit, const b2Vec2& where, const b2Vec2&,
                          float32 fraction) override
    {
        fixture = hit;
        point = where;
        return fraction;
    }

    const b2Fixture* fixture = nullptr;
    b2Vec2 point;
};

/// Bodies that collide with nothing move about; drawn are the boxes by which the world's tree knows
/// them, with their margins. Blue is what the tree holds, orange what the box finds, yellow what
/// the ray hits first.
class DynamicTree : public Scene
{
public:
    explicit DynamicTree(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        m_middle = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        Random random(settings.seed);
        for (int32 i = 0; i < kBodyCount; ++i)
        {
            AddMover(i, random);
        }
    }

    void Step(const StepSettings& settings) override
    {
        for (b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            TurnBack(*body);
        }
        Scene::Step(settings);
        m_angle += settings.timeStep * kTurningSpeed;
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"height", std::to_string(m_world.GetTreeHeight())},
                {"balance", std::to_string(m_world.GetTreeBalance())},
                {"quality", WithUnit(m_world.GetTreeQuality(), "roots")},
                {"in the box", std::to_string(Query().size())},
                {"on the ray", Cast().fixture != nullptr ? "one" : "none"}};
    }

    void Draw(b2Draw& draw) const override
    {
        for (const b2Body* body = m_world.GetBodyList(); body != nullptr; body = body->GetNext())
        {
            if (const b2Fixture* fixture = body->GetFixtureList())
            {
                DrawBox(draw, fixture->GetAABB(0), kSkyBlue);
            }
        }
        DrawBox(draw, Probe(), kOrange);
        for (const b2Fixture* fixture : Query())
        {
            DrawBox(draw, fixture->GetAABB(0), kOrange);
        }
        const Closest hit = Cast();
        draw.DrawSegment(m_middle->GetPosition(), hit.fixture ? hit.point : RayEnd(), kYellow);
        if (hit.fixture)
        {
            DrawBox(draw, hit.fixture->GetAABB(0), kYellow);
            DrawDot(draw, hit.point, kYellow);
        }
    }

    void VisitState(SceneState& state) override { state(m_middle, m_angle); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(11.0f, 11.0f)};
    }

private:
    void AddMover(int32 number, Random& random)
    {
        const float32 x = random.Between(-kReach, kReach);
        const float32 y = random.Between(-kReach, kReach);
        const float32 size = random.Between(0.3f, 0.8f);
        const float32 vx = random.Between(-kMaxSpeed, kMaxSpeed);
        const float32 vy = random.Between(-kMaxSpeed, kMaxSpeed);
        b2Body* body = AddSample(m_world, number % kSampleKinds, b2Vec2(x, y), 0.0f, size, {});
        body->GetFixtureList()->SetFilterData({.maskBits = 0});
        body->SetLinearVelocity(b2Vec2(vx, vy));
        body->SetAngularVelocity(0.3f * vx);
    }

    void TurnBack(b2Body& body) const
    {
        const b2Vec2 offset = body.GetPosition() - m_middle->GetPosition();
        b2Vec2 velocity = body.GetLinearVelocity();
        const bool leavesX = b2Abs(offset.x) > kReach && offset.x * velocity.x > 0.0f;
        const bool leavesY = b2Abs(offset.y) > kReach && offset.y * velocity.y > 0.0f;
        if (leavesX || leavesY)
        {
            velocity.Set(leavesX ? -velocity.x : velocity.x, leavesY ? -velocity.y : velocity.y);
            body.SetLinearVelocity(velocity);
        }
    }

    b2AABB Probe() const
    {
        const b2Vec2 center = m_middle->GetPosition() + kProbeOrbit * b2Rot(m_angle).GetYAxis();
        b2AABB probe;
        probe.lowerBound = center - kProbeReach;
        probe.upperBound = center + kProbeReach;
        return probe;
    }

    b2Vec2 RayEnd() const { return m_middle->GetPosition() - kReach * b2Rot(m_angle).GetYAxis(); }

    std::vector<const b2Fixture*> Query() const
    {
        Found found;
        m_world.QueryAABB(&found, Probe());
        return found.fixtures;
    }

    Closest Cast() const
    {
        Closest closest;
        m_world.RayCast(&closest, m_middle->GetPosition(), RayEnd());
        return closest;
    }

    b2Body* m_middle;       ///< of the field
    float32 m_angle = 0.0f; ///< of probe and ray [rad]
};

} // namespace

std::unique_ptr<Scene> MakeDynamicTree(const SceneSettings& settings)
{
    return std::make_unique<DynamicTree>(settings);
}

} // namespace boxreel
