// SPDX-License-Identifier: MIT
#include <scenes/MobileTree.h>

#include <scenes/JointParts.h>
#include <scenes/Parts.h>

namespace boxreel
{

namespace
{

// A tree of order n carries one of order n - 1 and one of order n - 2. Those of orders 0 and 1 are
// balls. The number of balls is a Fibonacci number.
constexpr int32 kOrder = 5;
constexpr int32 kBalls = 8;
constexpr float32 kBallStep = 2.0f;    ///< from ball to ball [m]
constexpr float32 kRadius = 0.5f;      ///< of a ball [m]
constexpr float32 kString = 1.6f;      ///< from the end of a rod to what hangs there [m]
constexpr float32 kHalfString = 0.03f; ///< half the thickness of a string [m]
constexpr float32 kHalfRod = 0.07f;    ///< half the thickness of a rod [m]
constexpr Material kWood{.density = 1.0f};
constexpr Material kLead{.density = 4.0f};
constexpr int16 kGroup = -1; ///< what swings about does not hit each other

/// A branch with its string.
struct Branch
{
    b2Body* body;
    b2Vec2 top;   ///< of the string [m]
    float32 load; ///< of the body and all that hangs from it [kg]
};

class Mobile
{
public:
    Mobile(b2World& world, HeldAt held) : m_world(world), m_held(held) {}

    /// Built from the balls up: where a rod hangs depends on what hangs from it.
    Branch Add(int32 order, float32 height, bool isGreaterOnTheLeft)
    {
        if (order < 2)
        {
            return AddWeight(height);
        }
        const int32 leftOrder = isGreaterOnTheLeft ? order - 1 : order - 2;
        const int32 rightOrder = isGreaterOnTheLeft ? order - 2 : order - 1;
        const float32 below = height - kString;
        const Branch left = Add(leftOrder, below, !isGreaterOnTheLeft);
        const Branch right = Add(rightOrder, below, !isGreaterOnTheLeft);
        return AddRod(left, right, height);
    }

private:
    Branch AddWeight(float32 height)
    {
        const b2Vec2 top(m_nextBall, height);
        const b2Vec2 center = top - b2Vec2(0.0f, kString + kRadius);
        b2Body* weight = AddBall(m_world, center, kRadius, kLead);
        AddString(*weight, top);
        m_nextBall += kBallStep;
        return {weight, top, weight->GetMass()};
    }

    Branch AddRod(const Branch& left, const Branch& right, float32 height)
    {
        const b2Vec2 middle = 0.5f * (left.top + right.top);
        const float32 halfLength = 0.5f * (right.top.x - left.top.x);
        b2Body* rod = AddBox(m_world, middle, halfLength, kHalfRod, kWood);
        const float32 carried = rod->GetMass() + left.load + right.load;
        const float32 balance =
            (rod->GetMass() * middle.x + left.load * left.top.x + right.load * right.top.x) /
            carried;
        const b2Vec2 top(m_held == HeldAt::Balance ? balance : middle.x, height);
        AddString(*rod, top);
        AddHinge(m_world, rod, left.body, left.top);
        AddHinge(m_world, rod, right.body, right.top);
        return {rod, top, rod->GetMass() + left.load + right.load};
    }

    static void AddString(b2Body& body, const b2Vec2& top)
    {
        const b2Vec2 middle = top - b2Vec2(0.0f, 0.5f * kString) - body.GetPosition();
        AttachBox(body, kHalfString, 0.5f * kString, kWood, middle);
        SetGroup(body, kGroup);
    }

    b2World& m_world;
    HeldAt m_held;
    float32 m_nextBall = -0.5f * kBallStep * static_cast<float32>(kBalls - 1); ///< its place [m]
};

} // namespace

b2Body* AddMobile(b2World& world, float32 height, HeldAt held)
{
    const Branch mobile = Mobile(world, held).Add(kOrder, height, true);
    b2Body* ceiling = AddGroundBox(world, mobile.top + b2Vec2(0.0f, 0.2f), 1.0f, 0.2f);
    AddHinge(world, ceiling, mobile.body, mobile.top);
    return mobile.body;
}

} // namespace boxreel
