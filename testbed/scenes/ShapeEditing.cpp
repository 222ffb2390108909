// SPDX-License-Identifier: MIT
#include <scenes/Notes.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kFirstEdit = 1.0f; ///< [s]
constexpr float32 kEditEvery = 2.5f; ///< until a key is pressed [s]
constexpr float32 kRadius = 2.0f;    ///< of the round foot [m]
const b2Vec2 kLoadPlace(1.1f, 3.6f); ///< in the frame of the foot's centre [m]

constexpr KeyBinding kKeys[] = {{'c', "adds the load"},
                                {'d', "takes the load away"},
                                {'s', "makes the load a sensor, or solid again"}};

/// A tumbler toy, heavy at the bottom: it rights itself. With a load at the side of its mast it
/// leans; a load that is a sensor still weighs, but nothing touches it.
class ShapeEditing : public Scene
{
public:
    explicit ShapeEditing(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-9.0f, 0.0f), b2Vec2(9.0f, 0.0f));
        AddGroundBox(m_world, b2Vec2(-7.0f, 1.0f), 0.3f, 1.0f);
        AddGroundBox(m_world, b2Vec2(7.0f, 1.0f), 0.3f, 1.0f);
        m_toy = AddBody(m_world, b2_dynamicBody, b2Vec2(0.0f, kRadius));
        m_toy->SetAngularDamping(1.0f);
        AttachCircle(*m_toy, kRadius, {.density = 1.0f, .friction = 0.9f});
        AttachBox(*m_toy, 1.0f, 0.3f, {.density = 8.0f}, b2Vec2(0.0f, -1.3f));
        AttachBox(*m_toy, 0.2f, 1.3f, {.density = 0.5f}, b2Vec2(0.0f, 3.0f));
    }

    void Step(const StepSettings& settings) override
    {
        if (!m_isSteered && m_time >= kFirstEdit + kEditEvery * static_cast<float32>(m_edits))
        {
            Load() == nullptr ? AddLoad() : TakeLoad();
            ++m_edits;
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        b2Fixture* load = Load();
        m_isSteered = true;
        if (key == 'c' && load == nullptr)
        {
            AddLoad();
        }
        if (key == 'd' && load != nullptr)
        {
            TakeLoad();
        }
        if (key == 's' && load != nullptr)
        {
            load->SetSensor(!load->IsSensor());
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const b2Fixture* load = Load();
        return {{"load", load == nullptr    ? "none"
                         : load->IsSensor() ? "a sensor"
                                            : "solid"},
                {"mass", WithUnit(m_toy->GetMass(), "kg")}};
    }

    void Draw(b2Draw& draw) const override { DrawDot(draw, m_toy->GetWorldCenter(), kOrange); }

    void VisitState(SceneState& state) override { state(m_toy, m_time, m_edits, m_isSteered); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 3.5f), .halfSize = b2Vec2(8.0f, 4.0f)};
    }

private:
    /// Returns the circle that is not in the middle; null if there is none.
    b2Fixture* Load() const
    {
        for (b2Fixture* fixture = m_toy->GetFixtureList(); fixture; fixture = fixture->GetNext())
        {
            if (fixture->GetType() == b2Shape::e_circle &&
                static_cast<const b2CircleShape*>(fixture->GetShape())->m_p.x > 0.0f)
            {
                return fixture;
            }
        }
        return nullptr;
    }

    void AddLoad()
    {
        AttachCircle(*m_toy, 0.9f, {.density = 2.5f}, kLoadPlace);
        m_toy->SetAwake(true);
    }

    void TakeLoad()
    {
        m_toy->DestroyFixture(Load());
        m_toy->SetAwake(true);
    }

    b2Body* m_toy;
    float32 m_time = 0.0f; ///< [s]
    int32 m_edits = 0;     ///< that the scene has made by itself
    bool m_isSteered = false;
};

} // namespace

std::unique_ptr<Scene> MakeShapeEditing(const SceneSettings& settings)
{
    return std::make_unique<ShapeEditing>(settings);
}

} // namespace boxreel
