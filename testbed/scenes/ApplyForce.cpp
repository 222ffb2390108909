// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kHalf = 16.0f;      ///< of the room [m]
const b2Vec2 kMiddle(0.0f, 16.0f);    ///< of the room [m]
constexpr float32 kThrust = 60.0f;    ///< [N]
constexpr float32 kTorque = 30.0f;    ///< [N m]
constexpr float32 kAutoTorque = 3.0f; ///< of the pilot who flies until a key is pressed [N m]
constexpr float32 kDamping = 1.2f;    ///< [1/s]
constexpr int32 kRows = 4;
constexpr Material kHull{.density = 2.0f, .friction = 0.2f};

constexpr KeyBinding kKeys[] = {{'w', "pushes the ship forward"},
                                {'a', "turns it to the left"},
                                {'d', "turns it to the right"}};

/// Top view, without gravity. A force at the ship's stern drives it, and a torque turns it. Damping
/// stops the ship and the boxes it hits. Until a key is pressed, the ship flies in a wide turn.
class ApplyForce : public Scene
{
public:
    explicit ApplyForce(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetGravity(b2Vec2(0.0f, 0.0f));
        AddRoom();
        m_ship = AddBody(m_world, b2_dynamicBody, b2Vec2(-8.0f, 5.0f));
        AttachPolygon(*m_ship, {{0.0f, 1.8f}, {-1.2f, -1.0f}, {0.0f, -0.6f}, {1.2f, -1.0f}}, kHull);
        Name(*m_ship, "ship");
        Slow(m_ship);
        for (int32 i = 0; i < kRows * kRows; ++i)
        {
            const b2Vec2 place(1.3f * static_cast<float32>(i % kRows),
                               1.3f * static_cast<float32>(i / kRows));
            Slow(AddBox(m_world, b2Vec2(-8.0f, 13.0f) + place, 0.5f, 0.5f, {.density = 1.0f}));
        }
    }

    void Step(const StepSettings& settings) override
    {
        const bool pushes = m_auto || m_pushes;
        const float32 torque = m_auto ? -kAutoTorque : kTorque * static_cast<float32>(m_turns);
        if (pushes)
        {
            m_ship->ApplyForce(kThrust * Forward(), Stern(), true);
        }
        if (torque != 0.0f)
        {
            m_ship->ApplyTorque(torque, true);
        }
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }
    void KeyDown(char key) override { Steer(key, 1); }
    void KeyUp(char key) override { Steer(key, -1); }

    void Draw(b2Draw& draw) const override
    {
        if (m_auto || m_pushes)
        {
            draw.DrawSegment(Stern(), Stern() - 2.0f * Forward(), b2Color(0.9f, 0.6f, 0.2f));
        }
    }

    void VisitState(SceneState& state) override { state(m_ship, m_auto, m_pushes, m_turns); }

private:
    b2Vec2 Forward() const { return m_ship->GetWorldVector(b2Vec2(0.0f, 1.0f)); }
    b2Vec2 Stern() const { return m_ship->GetWorldPoint(b2Vec2(0.0f, -0.8f)); }

    void Steer(char key, int32 change)
    {
        m_auto = false;
        if (key == 'w')
        {
            m_pushes = change > 0;
        }
        if (key == 'a' || key == 'd')
        {
            m_turns += key == 'a' ? change : -change;
        }
    }

    void AddRoom()
    {
        b2Body* room = AddBody(m_world, b2_staticBody, kMiddle);
        const b2Vec2 corners[] = {
            {-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}};
        b2ChainShape walls;
        walls.CreateLoop(corners, 4);
        room->CreateFixture(&walls, 0.0f)->SetRestitution(0.3f);
    }

    // Slows a body down like a thin film of oil.
    static void Slow(b2Body* body)
    {
        body->SetLinearDamping(kDamping);
        body->SetAngularDamping(2.0f * kDamping);
    }

    b2Body* m_ship = nullptr;
    bool m_auto = true;    ///< no key has been pressed
    bool m_pushes = false; ///< by key
    int32 m_turns = 0;     ///< by keys: 1 to the left, -1 to the right
};

} // namespace

std::unique_ptr<Scene> MakeApplyForce(const SceneSettings& settings)
{
    return std::make_unique<ApplyForce>(settings);
}

} // namespace boxreel
