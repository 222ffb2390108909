// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <array>
#include <string>

namespace boxreel
{

namespace
{

constexpr float32 kWheelRadius = 0.55f; ///< [m]
constexpr float32 kDriveSpeed = 25.0f;  ///< of the driven wheel [rad/s], 14 m/s
constexpr float32 kDriveTorque = 22.0f; ///< [N m]
constexpr float32 kBrakeTorque = 20.0f; ///< [N m]
constexpr float32 kSoftest = 1.0f;      ///< of the suspension [Hz]
constexpr float32 kHardest = 8.0f;      ///< [Hz]
constexpr int32 kPlankCount = 12;       ///< of the bridge, 1 m each
constexpr float32 kBridgeStart = 16.0f; ///< [m]
constexpr float32 kBridgeEnd = kBridgeStart + static_cast<float32>(kPlankCount);
constexpr Material kBodywork{.density = 1.0f, .friction = 0.3f};
constexpr Material kTyre{.density = 1.0f, .friction = 1.2f};
constexpr Material kPlank{.density = 2.0f, .friction = 0.7f};

// A slope to start from, waves, a seesaw's place, the ditch under the bridge, a wall [m].
const b2Vec2 kRoad[] = {{-32.0f, 12.0f},      {-32.0f, 6.0f},        {-28.0f, 6.0f},
                        {-24.0f, 4.5f},       {-18.0f, 1.2f},        {-14.0f, 0.0f},
                        {-11.5f, 0.5f},       {-9.0f, 0.0f},         {-6.5f, 0.9f},
                        {-4.0f, 0.0f},        {-2.0f, 0.6f},         {0.0f, 0.0f},
                        {kBridgeStart, 0.0f}, {kBridgeStart, -4.0f}, {kBridgeEnd, -4.0f},
                        {kBridgeEnd, 0.0f},   {42.0f, 0.0f},         {42.0f, 8.0f}};

constexpr KeyBinding kKeys[] = {{'a', "drives to the left"},
                                {'d', "drives to the right"},
                                {'s', "brakes"},
                                {'q', "makes the suspension softer"},
                                {'e', "makes the suspension harder"}};

/// Starts on a slope and rolls off it. After that the user drives.
class Car : public Scene
{
public:
    explicit Car(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* road = AddRoad();
        AddSeesaw(road);
        AddBridge(road);
        for (int32 i = 0; i < 5; ++i)
        {
            AddBox(m_world, b2Vec2(35.0f, 0.5f + static_cast<float32>(i)), 0.5f, 0.5f,
                   {.density = 0.3f});
        }
        AddCar(b2Vec2(-28.5f, 7.2f));
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        switch (key)
        {
        case 'a':
            Drive(kDriveSpeed);
            break;
        case 'd':
            Drive(-kDriveSpeed);
            break;
        case 's':
            Brake();
            break;
        case 'q':
            SetSuspension(m_hertz - 1.0f);
            break;
        case 'e':
            SetSuspension(m_hertz + 1.0f);
            break;
        default:
            break;
        }
    }

    // Without a foot on a pedal it rolls.
    void KeyUp(char key) override
    {
        if (key == 'a' || key == 'd' || key == 's')
        {
            Wheel(0).EnableMotor(false);
            Wheel(1).EnableMotor(false);
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"speed", Rounded(m_chassis->GetLinearVelocity().x) + " m/s"},
                {"suspension", Rounded(m_hertz) + " Hz"}};
    }

    void VisitState(SceneState& state) override
    {
        state(m_chassis, m_springs[0], m_springs[1], m_hertz);
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{
            .center = b2Vec2(0.0f, 0.0f), .halfSize = b2Vec2(14.0f, 7.0f), .followed = m_chassis};
    }

private:
    b2Body* AddRoad()
    {
        b2Body* road = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        b2ChainShape chain;
        chain.CreateChain(kRoad, static_cast<int32>(std::size(kRoad)));
        road->CreateFixture(&chain, 0.0f)->SetFriction(0.8f);
        return road;
    }

    void AddSeesaw(b2Body* road)
    {
        const b2Vec2 pivot(8.0f, 0.8f);
        b2Body* board = AddBox(m_world, pivot, 4.5f, 0.15f, {.density = 1.0f});
        AddLimitedHinge(m_world, road, board, pivot, -0.15f, 0.15f, 2.0f);
        board->SetAngularVelocity(0.5f); // its near end comes down
    }

    void AddBridge(b2Body* road)
    {
        b2Body* previous = road;
        for (int32 i = 0; i < kPlankCount; ++i)
        {
            const float32 x = kBridgeStart + static_cast<float32>(i);
            b2Body* plank = AddBox(m_world, b2Vec2(x + 0.5f, -0.12f), 0.52f, 0.12f, kPlank);
            AddHinge(m_world, previous, plank, b2Vec2(x, -0.12f));
            previous = plank;
        }
        AddHinge(m_world, previous, road, b2Vec2(kBridgeEnd, -0.12f));
    }

    void AddCar(const b2Vec2& place)
    {
        m_chassis = AddBody(m_world, b2_dynamicBody, place);
        Name(*m_chassis, "chassis");
        AttachPolygon(*m_chassis,
                      {{-2.0f, -0.3f}, {2.0f, -0.3f}, {2.1f, 0.1f}, {1.5f, 0.35f}, {-2.0f, 0.4f}},
                      kBodywork);
        AttachPolygon(*m_chassis, {{-1.4f, 0.38f}, {1.0f, 0.36f}, {0.4f, 1.0f}, {-1.1f, 1.0f}},
                      {.density = 0.3f});
        m_springs[0] = AddWheel(place + b2Vec2(-1.3f, -0.6f));
        m_springs[1] = AddWheel(place + b2Vec2(1.3f, -0.6f));
    }

    b2Joint* AddWheel(const b2Vec2& axle)
    {
        b2WheelJointDef spring;
        spring.Initialize(m_chassis, AddBall(m_world, axle, kWheelRadius, kTyre), axle,
                          b2Vec2(0.0f, 1.0f));
        spring.frequencyHz = m_hertz;
        return m_world.CreateJoint(&spring);
    }

    b2WheelJoint& Wheel(int32 i) const
    {
        return *static_cast<b2WheelJoint*>(m_springs[std::size_t(i)]);
    }

    void Turn(b2WheelJoint& wheel, float32 speed, float32 torque)
    {
        m_chassis->SetAwake(true);
        wheel.SetMotorSpeed(speed);
        wheel.SetMaxMotorTorque(torque);
        wheel.EnableMotor(true);
    }

    // By the rear wheel only.
    void Drive(float32 speed) { Turn(Wheel(0), speed, kDriveTorque); }

    void Brake()
    {
        Turn(Wheel(0), 0.0f, kBrakeTorque);
        Turn(Wheel(1), 0.0f, kBrakeTorque);
    }

    void SetSuspension(float32 hertz)
    {
        m_hertz = b2Clamp(hertz, kSoftest, kHardest);
        Wheel(0).SetSpringFrequencyHz(m_hertz);
        Wheel(1).SetSpringFrequencyHz(m_hertz);
    }

    b2Body* m_chassis = nullptr;
    std::array<b2Joint*, 2> m_springs{}; ///< wheel joints, the rear one first
    float32 m_hertz = 4.0f;              ///< of the suspension
};

} // namespace

std::unique_ptr<Scene> MakeCar(const SceneSettings& settings)
{
    return std::make_unique<Car>(settings);
}

} // namespace boxreel
