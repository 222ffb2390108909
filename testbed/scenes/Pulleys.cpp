// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/SceneState.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr float32 kRatio = 1.5f;        ///< metres that the basket moves for one of the weight
constexpr float32 kWheelHeight = 20.0f; ///< of the points where the rope leaves the wheels [m]
constexpr float32 kAside = 7.0f;        ///< [m]
constexpr float32 kBasketHeight = 8.0f; ///< at first [m]
constexpr float32 kWeightHeight = 2.0f;
constexpr int32 kBallCount = 8;
constexpr Material kIron{.density = 10.0f};

/// A weight holds a basket up over two wheels until enough balls have fallen into it. A block and
/// tackle on the weight's side: it moves less and pulls with more.
class Pulleys : public Scene
{
public:
    explicit Pulleys(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-18.0f, 0.0f), b2Vec2(18.0f, 0.0f));
        for (float32 x : {-18.0f, 18.0f})
        {
            AddGroundEdge(m_world, b2Vec2(x, 0.0f), b2Vec2(x, 3.0f));
        }
        for (float32 x : {-kAside, kAside})
        {
            b2Body* wheel = AddBody(m_world, b2_staticBody, b2Vec2(x, kWheelHeight + 1.0f));
            AttachCircle(*wheel, 1.0f, {});
        }
        b2Body* basket = AddBasket(b2Vec2(-kAside, kBasketHeight));
        b2Body* weight = AddBox(m_world, b2Vec2(kAside, kWeightHeight), 1.5f, 1.5f, kIron);
        weight->SetFixedRotation(true);

        b2PulleyJointDef rope;
        rope.Initialize(basket, weight, b2Vec2(-kAside, kWheelHeight), b2Vec2(kAside, kWheelHeight),
                        b2Vec2(-kAside, kBasketHeight), b2Vec2(kAside, kWeightHeight + 1.5f),
                        kRatio);
        m_rope = m_world.CreateJoint(&rope);
        for (int32 i = 0; i < kBallCount; ++i)
        {
            const float32 x = -kAside + (i % 2 == 0 ? -1.1f : 1.1f);
            AddBall(m_world, b2Vec2(x, 11.0f + 1.6f * static_cast<float32>(i / 2)), 0.6f,
                    {.density = 4.0f});
        }
    }

    std::vector<std::pair<std::string, std::string>> Describe() const override
    {
        const auto* rope = static_cast<const b2PulleyJoint*>(m_rope);
        const float32 basket = rope->GetCurrentLengthA();
        const float32 weight = rope->GetCurrentLengthB();
        return {{"basket", Rounded(basket) + " m"},
                {"weight", Rounded(weight) + " m"},
                {"basket + 1.5 weight", Rounded(basket + kRatio * weight) + " m"}};
    }

    void VisitState(SceneState& state) override { state(m_rope); }

private:
    // Does not turn, else the first ball would tip it over.
    b2Body* AddBasket(const b2Vec2& place)
    {
        b2Body* basket = AddBody(m_world, b2_dynamicBody, place);
        AttachBox(*basket, 2.5f, 0.2f, kIron);
        AttachBox(*basket, 0.2f, 1.5f, kIron, b2Vec2(-2.5f, 1.3f));
        AttachBox(*basket, 0.2f, 1.5f, kIron, b2Vec2(2.5f, 1.3f));
        basket->SetFixedRotation(true);
        return basket;
    }

    b2Joint* m_rope; ///< a pulley joint
};

} // namespace

std::unique_ptr<Scene> MakePulleys(const SceneSettings& settings)
{
    return std::make_unique<Pulleys>(settings);
}

} // namespace boxreel
