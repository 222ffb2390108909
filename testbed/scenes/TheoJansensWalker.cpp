// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

#include <array>
#include <cmath>

namespace boxreel
{

namespace
{

// T. Jansen's "eleven holy numbers" (The Great Pretender, 010 Publishers, 2007), the lengths of the
// bars of his walking animals, here in metres at this scale.
constexpr float32 kScale = 0.06f;               ///< metres for one of his units
constexpr float32 kPivotAside = 38.0f * kScale; ///< a: from the crank to the leg's fixed pivot
constexpr float32 kPivotBelow = 7.8f * kScale;  ///< l
constexpr float32 kCrank = 15.0f * kScale;      ///< m
constexpr float32 kUpperPush = 50.0f * kScale;  ///< j: crank to shoulder
constexpr float32 kLowerPush = 61.9f * kScale;  ///< k: crank to knee
constexpr float32 kShoulder = 41.5f * kScale;   ///< b: pivot to shoulder
constexpr float32 kHip = 40.1f * kScale;        ///< d: pivot to hip
constexpr float32 kBack = 55.8f * kScale;       ///< e: shoulder to hip
constexpr float32 kThigh = 39.3f * kScale;      ///< c: pivot to knee
constexpr float32 kTendon = 39.4f * kScale;     ///< f: hip to ankle
constexpr float32 kCalf = 36.7f * kScale;       ///< g: knee to ankle
constexpr float32 kHeel = 65.7f * kScale;       ///< h: ankle to foot
constexpr float32 kShin = 49.0f * kScale;       ///< i: knee to foot

const b2Vec2 kCrankCenter(-8.0f, 6.0f); ///< so that the lowest foot just clears the ground [m]
constexpr float32 kSpeed = 2.0f;        ///< of the crank [rad/s]
constexpr float32 kTorque = 800.0f;     ///< [N m]
constexpr int32 kLegPairs = 3;          ///< a third of a turn apart: one always stands on each side
constexpr int16 kWalkerGroup = -1;      ///< legs pass each other
constexpr Material kLimb{.density = 0.6f, .friction = 0.9f};
constexpr Material kTrunk{.density = 1.0f};

constexpr KeyBinding kKeys[] = {{'a', "walks to the left"},
                                {'s', "stands"},
                                {'d', "walks to the right"},
                                {'m', "cuts the motor"}};

/// Returns the third corner of a triangle, at these distances from `from` and `to`. It is on the
/// left of the line from `from` to `to`.
b2Vec2 Corner(const b2Vec2& from, const b2Vec2& to, float32 distanceFrom, float32 distanceTo)
{
    const float32 base = b2Distance(from, to);
    const float32 along =
        (distanceFrom * distanceFrom - distanceTo * distanceTo + base * base) / (2.0f * base);
    const float32 aside = std::sqrt(distanceFrom * distanceFrom - along * along);
    const b2Vec2 direction = (1.0f / base) * (to - from);
    return from + along * direction + aside * b2Vec2(-direction.y, direction.x);
}

class TheoJansensWalker : public Scene
{
public:
    explicit TheoJansensWalker(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-30.0f, 0.0f), b2Vec2(30.0f, 0.0f));
        AddGroundEdge(m_world, b2Vec2(-30.0f, 0.0f), b2Vec2(-30.0f, 8.0f));
        AddGroundEdge(m_world, b2Vec2(30.0f, 0.0f), b2Vec2(30.0f, 8.0f));
        for (int32 i = 0; i < 30; ++i)
        {
            AddBall(m_world, b2Vec2(-29.0f + 2.0f * static_cast<float32>(i), 0.15f), 0.15f);
        }
        m_trunk = AddBox(m_world, kCrankCenter, kPivotAside, 0.5f, kTrunk);
        m_wheel = AddBall(m_world, kCrankCenter, kCrank + 0.1f, kTrunk);
        SetGroup(*m_trunk, kWalkerGroup);
        Name(*m_trunk, "trunk");
        SetGroup(*m_wheel, kWalkerGroup);
        m_motor = AddMotorHinge(m_world, m_trunk, m_wheel, kCrankCenter, -kSpeed, kTorque);
        for (int32 i = 0; i < kLegPairs; ++i)
        {
            const b2Rot turn(2.0f * b2_pi * static_cast<float32>(i) /
                             static_cast<float32>(kLegPairs));
            const b2Vec2 pin(kCrank * turn.c, kCrank * turn.s);
            AddLeg(pin, -1.0f);
            AddLeg(pin, 1.0f);
        }
    }

    std::span<const KeyBinding> Keys() const override { return kKeys; }

    void KeyDown(char key) override
    {
        auto* motor = static_cast<b2RevoluteJoint*>(m_motor);
        m_trunk->SetAwake(true);
        switch (key)
        {
        case 'a':
            motor->SetMotorSpeed(kSpeed);
            break;
        case 's':
            motor->SetMotorSpeed(0.0f);
            break;
        case 'd':
            motor->SetMotorSpeed(-kSpeed);
            break;
        case 'm':
            motor->EnableMotor(!motor->IsMotorEnabled());
            break;
        default:
            break;
        }
    }

    void VisitState(SceneState& state) override { state(m_trunk, m_wheel, m_motor); }

private:
    // Adds a leg. The coordinates are those of the left one, with the crank's centre at the origin;
    // the right one is its mirror image. It has two rigid triangles. One rotates about the pivot,
    // the other is held by three rods.
    void AddLeg(const b2Vec2& pin, float32 side)
    {
        const b2Vec2 crank(-side * pin.x, pin.y);
        const b2Vec2 pivot(-kPivotAside, -kPivotBelow);
        const b2Vec2 shoulder = Corner(pivot, crank, kShoulder, kUpperPush);
        const b2Vec2 hip = Corner(pivot, shoulder, kHip, kBack);
        const b2Vec2 knee = Corner(crank, pivot, kLowerPush, kThigh);
        const b2Vec2 ankle = Corner(knee, hip, kCalf, kTendon);
        const b2Vec2 foot = Corner(knee, ankle, kShin, kHeel);
        const auto place = [&](const b2Vec2& point) {
            return kCrankCenter + b2Vec2(-side * point.x, point.y);
        };
        b2Body* upper = AddTriangle(place(pivot), place(shoulder), place(hip));
        b2Body* lower = AddTriangle(place(knee), place(ankle), place(foot));
        AddHinge(m_world, m_trunk, upper, place(pivot));
        AddRod(m_world, m_wheel, upper, place(crank), place(shoulder));
        AddRod(m_world, m_wheel, lower, place(crank), place(knee));
        AddRod(m_world, m_trunk, lower, place(pivot), place(knee));
        AddRod(m_world, upper, lower, place(hip), place(ankle));
    }

    b2Body* AddTriangle(const b2Vec2& a, const b2Vec2& b, const b2Vec2& c)
    {
        b2Body* triangle = AddBody(m_world, b2_dynamicBody, a);
        AttachPolygon(*triangle, {b2Vec2(0.0f, 0.0f), b - a, c - a}, kLimb);
        SetGroup(*triangle, kWalkerGroup);
        return triangle;
    }

    b2Body* m_trunk = nullptr;
    b2Body* m_wheel = nullptr;
    b2Joint* m_motor = nullptr; ///< a revolute joint
};

} // namespace

std::unique_ptr<Scene> MakeTheoJansensWalker(const SceneSettings& settings)
{
    return std::make_unique<TheoJansensWalker>(settings);
}

} // namespace boxreel
