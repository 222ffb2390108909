// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <array>

namespace boxreel
{

namespace
{

constexpr std::size_t kPointCount = b2_maxPolygonVertices;
constexpr float32 kReach = 1.8f;     ///< of the points, from the middle of the set [m]
constexpr float32 kHullEvery = 1.0f; ///< [s]
constexpr int32 kHullCount = 12;
const b2Vec2 kPlace(0.0f, 10.0f); ///< where hulls are made [m]

constexpr KeyBinding kKeys[] = {{'g', "makes the next hull"}};

/// The newest polygon hangs where its points were thrown and touches nothing; those before it have
/// fallen.
class ConvexHull : public Scene
{
public:
    explicit ConvexHull(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        m_ground = AddGroundEdge(m_world, b2Vec2(-9.0f, 0.0f), b2Vec2(9.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-9.0f, 0.0f), b2Vec2(-9.0f, 3.0f));
        AddGroundEdge(m_world, b2Vec2(9.0f, 0.0f), b2Vec2(9.0f, 3.0f));
        MakeHull();
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        if (m_hulls < kHullCount && m_time >= kHullEvery * static_cast<float32>(m_hulls))
        {
            MakeHull();
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        if (key == 'g')
        {
            MakeHull();
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2Shape* shape = m_newest->GetFixtureList()->GetShape();
        const int32 corners = static_cast<const b2PolygonShape*>(shape)->GetVertexCount();
        return {{"points", std::to_string(kPointCount)}, {"corners", std::to_string(corners)}};
    }

    void Draw(b2Draw& draw) const override
    {
        for (const b2Vec2& point : m_points)
        {
            DrawDot(draw, m_newest->GetWorldPoint(point), kOrange);
        }
    }

    void VisitState(SceneState& state) override
    {
        state(m_ground, m_newest, m_random, m_hulls, m_time);
        for (b2Vec2& point : m_points)
        {
            state(point.x, point.y);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 6.0f), .halfSize = b2Vec2(9.5f, 6.5f)};
    }

private:
    void MakeHull()
    {
        if (m_newest != nullptr)
        {
            m_newest->SetGravityScale(1.0f);
            m_newest->GetFixtureList()->SetFilterData(b2Filter());
            m_newest->SetAwake(true);
        }
        ThrowPoints();
        m_newest = AddBody(m_world, b2_dynamicBody, m_ground->GetWorldPoint(kPlace));
        m_newest->SetGravityScale(0.0f);
        b2PolygonShape hull;
        hull.Set(m_points.data(), static_cast<int32>(kPointCount));
        m_newest->CreateFixture(&hull, 1.0f)->SetFilterData({.maskBits = 0});
        ++m_hulls;
    }

    // Repeated until they make a polygon; eight points are rarely collinear.
    void ThrowPoints()
    {
        do
        {
            for (b2Vec2& point : m_points)
            {
                point.x = m_random.Between(-kReach, kReach);
                point.y = m_random.Between(-kReach, kReach);
            }
        } while (b2PolygonShape::WhyNotConvex(m_points.data(), static_cast<int32>(kPointCount)));
    }

    b2Body* m_ground;
    b2Body* m_newest = nullptr;
    std::array<b2Vec2, kPointCount> m_points; ///< of the newest hull, in its frame [m]
    Random m_random;
    int32 m_hulls = 0;
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakeConvexHull(const SceneSettings& settings)
{
    return std::make_unique<ConvexHull>(settings);
}

} // namespace boxreel
