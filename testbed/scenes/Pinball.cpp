// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <array>
#include <vector>

namespace boxreel
{

namespace
{

constexpr float32 kGravity = 6.0f; ///< along a table that leans back [m/s^2]
constexpr float32 kLeft = -9.0f;   ///< the table's left wall [m]
constexpr float32 kLane = 8.2f;    ///< from here to the right wall the ball is shot up [m]
constexpr float32 kRight = 9.8f;   ///< the right wall [m]
constexpr float32 kTop = 24.0f;    ///< [m]
constexpr float32 kBend = 6.0f;    ///< radius of both upper corners [m]
constexpr int32 kBendParts = 10;
constexpr float32 kBallRadius = 0.4f; ///< [m]
constexpr Material kSteel{.density = 2.0f, .friction = 0.1f, .restitution = 0.3f};
constexpr Material kRubber{.friction = 0.1f, .restitution = 1.0f};

const b2Vec2 kPivot(3.4f, 4.0f);    ///< of the right flipper; the left one is its mirror image [m]
constexpr float32 kFlipper = 2.75f; ///< length [m]
constexpr float32 kRest = 0.4f;     ///< how far it hangs [rad]
constexpr float32 kStroke = 0.9f;   ///< how far it turns up from there [rad]
constexpr float32 kFlipSpeed = 12.0f;    ///< [rad/s]
constexpr float32 kFlipTorque = 4000.0f; ///< [N m]

constexpr float32 kPush = 1.2f;      ///< displacement of the plunger [m]
constexpr float32 kWeakest = 18.0f;  ///< of its speeds [m/s]
constexpr float32 kHardest = 22.0f;  ///< of its speeds [m/s]
constexpr float32 kReturn = 2.0f;    ///< on its way back [m/s]
constexpr float32 kForce = 20000.0f; ///< of the plunger [N]

// In automatic play a flipper is up for a moment and then down for a while. Otherwise a ball could
// rest on it permanently.
constexpr float32 kUp = 0.2f;   ///< [s]
constexpr float32 kWait = 0.3f; ///< [s]

constexpr KeyBinding kKeys[] = {
    {'a', "the left flipper"}, {'d', "the right flipper"}, {'s', "shoots the ball up its lane"}};

/// The ball is shot up a lane on the right, falls through bumpers and a windmill, and is hit back
/// by two flippers. If they miss, it rolls back to the plunger. The scene plays automatically until
/// a key is pressed.
class Pinball : public Scene
{
public:
    explicit Pinball(const SceneSettings& settings) : Scene(settings), m_random(settings.seed)
    {
        m_world.SetGravity(b2Vec2(0.0f, -kGravity));
        AddTable();
        AddWindmill(b2Vec2(-0.4f, 12.5f));
        m_flippers = {AddFlipper(-1.0f, "left flipper"), AddFlipper(1.0f, "right flipper")};
        const b2Vec2 rest(0.5f * (kLane + kRight), -0.2f);
        b2Body* plunger = AddBox(m_world, rest, 0.7f, 1.0f, kSteel);
        m_plunger = AddMotorSlide(m_world, m_table, plunger, rest, b2Vec2(0.0f, 1.0f), 0.0f, kPush,
                                  -kReturn, kForce);
        m_ball = AddBall(m_world, rest + b2Vec2(0.0f, 1.45f), kBallRadius, kSteel);
        m_ball->SetBullet(true);
        Name(*m_ball, "ball");
    }

    void Step(const StepSettings& settings) override
    {
        const b2Vec2 ball = m_table->GetLocalPoint(m_ball->GetPosition());
        const bool lies =
            ball.x > kLane + kBallRadius && ball.y < 1.6f && m_ball->GetLinearVelocity().y < 0.1f;
        if (!m_isSteered && lies)
        {
            Shoot();
        }
        const auto& plunger = *static_cast<const b2PrismaticJoint*>(m_plunger);
        if (plunger.GetJointTranslation() > 0.9f * kPush)
        {
            MovePlunger(-kReturn);
        }
        for (std::size_t i = 0; i < 2; ++i)
        {
            const float32 side = i == 0 ? -1.0f : 1.0f;
            if (!m_isSteered && m_timers[i] <= 0.0f && IsInReach(ball, side))
            {
                m_timers[i] = kUp + kWait;
            }
            m_timers[i] = b2Max(m_timers[i] - settings.timeStep, 0.0f);
            Flip(i, m_isHeld[i] || m_timers[i] > kWait);
        }
        Scene::Step(settings);
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        m_isSteered = m_isSteered || key == 'a' || key == 'd' || key == 's';
        Hold(key, true);
        if (key == 's')
        {
            Shoot();
        }
    }

    void KeyUp(char key) override { Hold(key, false); }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        return {{"shots", std::to_string(m_shots)}};
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.4f, 11.3f), .halfSize = b2Vec2(10.0f, 13.2f)};
    }

    void VisitState(SceneState& state) override
    {
        state(m_table, m_ball, m_flippers[0], m_flippers[1], m_plunger, m_random, m_timers[0],
              m_timers[1], m_isHeld[0], m_isHeld[1], m_isSteered, m_shots);
    }

private:
    /// Around the table: the floor slopes to the plunger, and the walls to the flippers.
    void AddTable()
    {
        m_table = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        // The slopes end above the flippers' corners: between the two a ball would come to rest.
        const b2Vec2 slopeEnd = kPivot + b2Vec2(-0.1f, 0.25f);
        std::vector<b2Vec2> around{
            {kLane, -1.4f}, {kLane, 0.9f}, {-3.6f, 2.0f}, {-slopeEnd.x, slopeEnd.y}, {kLeft, 8.0f}};
        for (int32 i = 0; i <= kBendParts; ++i)
        {
            const b2Rot turned(0.5f * b2_pi * static_cast<float32>(i) / kBendParts);
            around.emplace_back(kLeft + kBend - kBend * turned.c, kTop - kBend + kBend * turned.s);
        }
        for (int32 i = 0; i <= kBendParts; ++i)
        {
            const b2Rot turned(0.5f * b2_pi * static_cast<float32>(i) / kBendParts);
            around.emplace_back(kRight - kBend + kBend * turned.s, kTop - kBend + kBend * turned.c);
        }
        around.emplace_back(kRight, -1.4f);
        AddWall(around);
        // Between the table and the lane, with the slope to the right flipper.
        AddWall(
            {{kLane, 2.4f}, {kLane, 17.0f}, {kLane - 0.2f, 17.0f}, {kLane - 0.2f, 8.0f}, slopeEnd});
        for (const b2Vec2& bumper :
             {b2Vec2(-4.2f, 17.0f), b2Vec2(0.4f, 19.5f), b2Vec2(4.2f, 16.5f)})
        {
            AttachCircle(*m_table, 0.9f, kRubber, bumper);
        }
        for (const b2Vec2& pin : {b2Vec2(-6.3f, 10.5f), b2Vec2(5.3f, 10.0f)})
        {
            AttachCircle(*m_table, 0.35f, kRubber, pin);
        }
    }

    void AddWall(const std::vector<b2Vec2>& corners)
    {
        b2ChainShape shape;
        shape.CreateLoop(corners.data(), static_cast<int32>(corners.size()));
        b2FixtureDef wall;
        wall.shape = &shape;
        wall.friction = kSteel.friction;
        m_table->CreateFixture(&wall);
    }

    void AddWindmill(const b2Vec2& hub)
    {
        b2Body* windmill = AddBox(m_world, hub, 1.7f, 0.12f, kSteel);
        AttachBox(*windmill, 0.12f, 1.7f, kSteel);
        AddMotorHinge(m_world, m_table, windmill, hub, 2.0f, 200.0f);
        Name(*windmill, "windmill");
    }

    /// From its pivot to the middle of the table; side 1 is the right one.
    b2Joint* AddFlipper(float32 side, const char* name)
    {
        const b2Vec2 pivot(side * kPivot.x, kPivot.y);
        b2Body* flipper = AddBody(m_world, b2_dynamicBody, pivot, side * kRest);
        AttachPolygon(
            *flipper,
            {{0.0f, -0.3f}, {0.0f, 0.2f}, {-side * kFlipper, 0.12f}, {-side * kFlipper, -0.12f}},
            kSteel);
        Name(*flipper, name);
        const float32 lower = side > 0.0f ? -kStroke : 0.0f;
        auto* hinge = static_cast<b2RevoluteJoint*>(
            AddLimitedHinge(m_world, m_table, flipper, pivot, lower, lower + kStroke));
        hinge->SetMaxMotorTorque(kFlipTorque);
        hinge->EnableMotor(true);
        return hinge;
    }

    void Flip(std::size_t i, bool isUp)
    {
        const float32 up = i == 0 ? kFlipSpeed : -kFlipSpeed;
        static_cast<b2RevoluteJoint*>(m_flippers[i])->SetMotorSpeed(isUp ? up : -up);
    }

    void Hold(char key, bool isHeld)
    {
        if (key == 'a' || key == 'd')
        {
            m_isHeld[key == 'a' ? 0 : 1] = isHeld;
        }
    }

    /// Over the flipper of this side or close beside it.
    static bool IsInReach(const b2Vec2& ball, float32 side)
    {
        const float32 along = kPivot.x - side * ball.x;
        const float32 above = ball.y - kPivot.y;
        return along > 0.8f && along < kFlipper + 0.2f && above > -1.2f && above < 0.4f;
    }

    void Shoot()
    {
        if (static_cast<b2PrismaticJoint*>(m_plunger)->GetMotorSpeed() < 0.0f)
        {
            MovePlunger(m_random.Between(kWeakest, kHardest));
            ++m_shots;
        }
    }

    void MovePlunger(float32 speed)
    {
        static_cast<b2PrismaticJoint*>(m_plunger)->SetMotorSpeed(speed);
    }

    b2Body* m_table = nullptr;
    b2Body* m_ball = nullptr;
    std::array<b2Joint*, 2> m_flippers{}; ///< hinges, the left one first
    b2Joint* m_plunger = nullptr;         ///< a slide
    Random m_random;
    std::array<float32, 2> m_timers{}; ///< until a flipper may go up again [s]
    std::array<bool, 2> m_isHeld{};    ///< up, by a key
    bool m_isSteered = false;
    int32 m_shots = 0;
};

} // namespace

std::unique_ptr<Scene> MakePinball(const SceneSettings& settings)
{
    return std::make_unique<Pinball>(settings);
}

} // namespace boxreel
