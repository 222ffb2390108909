// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kLevels = 5;
constexpr float32 kHalfLength = 0.5f;             ///< of a card [m]
constexpr float32 kHalfThickness = 0.02f;         ///< [m]
constexpr float32 kLean = 24.0f * b2_pi / 180.0f; ///< of a card against the vertical [rad]
constexpr float32 kPitch = 1.0f;                  ///< from ridge to ridge [m]
constexpr Material kCard{.density = 0.5f, .friction = 0.8f};

// Cards keep the skins of their shapes clear of each other: pushed apart at the start, the house
// might fall.
constexpr float32 kRoom = 2.0f * b2_polygonRadius - 0.002f; ///< [m]

class CardHouse : public Scene
{
public:
    explicit CardHouse(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // leaning cards stand by friction alone
        AddGroundEdge(m_world, b2Vec2(-10.0f, 0.0f), b2Vec2(10.0f, 0.0f));
        const b2Rot lean(kLean);
        const float32 halfHeight = kHalfLength * lean.c + kHalfThickness * lean.s;
        const float32 halfWidth = kHalfLength * lean.s + kHalfThickness * lean.c;
        float32 floor = kRoom;
        for (int32 tents = kLevels; tents > 0; --tents)
        {
            const float32 left = -0.5f * kPitch * static_cast<float32>(tents - 1);
            AddTents(left, tents, b2Vec2(halfWidth + 0.5f * kRoom, floor + halfHeight));
            floor += 2.0f * halfHeight + kRoom;
            AddCeiling(left, tents - 1, floor + kHalfThickness);
            floor += 2.0f * kHalfThickness + kRoom;
        }
    }

private:
    /// Two cards each; `half`: from the ridge sideways and up from the ground to a card's centre.
    void AddTents(float32 left, int32 tents, const b2Vec2& half)
    {
        for (int32 i = 0; i < tents; ++i)
        {
            const float32 ridge = left + kPitch * static_cast<float32>(i);
            AddCard(b2Vec2(ridge - half.x, half.y), -kLean);
            AddCard(b2Vec2(ridge + half.x, half.y), kLean);
        }
    }

    /// Cards that lie from ridge to ridge.
    void AddCeiling(float32 left, int32 cards, float32 y)
    {
        for (int32 i = 0; i < cards; ++i)
        {
            const float32 middle = left + kPitch * (static_cast<float32>(i) + 0.5f);
            AddBox(m_world, b2Vec2(middle, y), 0.5f * (kPitch - kRoom), kHalfThickness, kCard);
        }
    }

    void AddCard(const b2Vec2& center, float32 angle)
    {
        AddBox(m_world, center, kHalfThickness, kHalfLength, kCard, angle);
    }
};

} // namespace

std::unique_ptr<Scene> MakeCardHouse(const SceneSettings& settings)
{
    return std::make_unique<CardHouse>(settings);
}

} // namespace boxreel
