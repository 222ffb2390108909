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
constexpr float32 kBallEvery = 0.8f;   ///< [s]
constexpr float32 kBallHeight = 15.0f; ///< from which they fall [m]
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
            m_wheel = AddBody(m_world, b2_staticBody, b2Vec2(x, kWheelHeight + 1.0f));
            AttachCircle(*m_wheel, 1.0f, {});
        }
        b2Body* basket = AddBasket(b2Vec2(-kAside, kBasketHeight));
        b2Body* weight = AddBox(m_world, b2Vec2(kAside, kWeightHeight), 1.5f, 1.5f, kIron);
        weight->SetFixedRotation(true);

        b2PulleyJointDef rope;
        rope.Initialize(basket, weight, b2Vec2(-kAside, kWheelHeight), b2Vec2(kAside, kWheelHeight),
                        b2Vec2(-kAside, kBasketHeight), b2Vec2(kAside, kWeightHeight + 1.5f),
                        kRatio);
        m_rope = m_world.CreateJoint(&rope);
    }

    bool MakesBodiesLater() const override { return true; }

    void Step(const StepSettings& settings) override
    {
        if (m_balls < kBallCount && m_time >= kBallEvery * static_cast<float32>(m_balls))
        {
            // Into the basket on the left; the wheel that is kept is the right one.
            const b2Vec2 aside(m_balls % 2 == 0 ? -1.1f : 1.1f, 0.0f);
            const b2Vec2 fromWheel(-2.0f * kAside, kBallHeight - kWheelHeight - 1.0f);
            AddBall(m_world, m_wheel->GetPosition() + fromWheel + aside, 0.6f, {.density = 4.0f});
            ++m_balls;
        }
        Scene::Step(settings);
        m_time += settings.timeStep;
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

    void VisitState(SceneState& state) override { state(m_wheel, m_rope, m_balls, m_time); }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(0.0f, 10.75f), .halfSize = b2Vec2(18.5f, 11.5f)};
    }

private:
    // Has a fixed rotation, because the first ball would tip it over.
    b2Body* AddBasket(const b2Vec2& place)
    {
        b2Body* basket = AddBody(m_world, b2_dynamicBody, place);
        AttachBox(*basket, 2.5f, 0.2f, kIron);
        AttachBox(*basket, 0.2f, 1.5f, kIron, b2Vec2(-2.5f, 1.3f));
        AttachBox(*basket, 0.2f, 1.5f, kIron, b2Vec2(2.5f, 1.3f));
        basket->SetFixedRotation(true);
        return basket;
    }

    b2Body* m_wheel = nullptr; ///< the right one
    b2Joint* m_rope;           ///< a pulley joint
    int32 m_balls = 0;
    float32 m_time = 0.0f; ///< [s]
};

} // namespace

std::unique_ptr<Scene> MakePulleys(const SceneSettings& settings)
{
    return std::make_unique<Pulleys>(settings);
}

} // namespace boxreel
