// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kPlankCount = 24;
constexpr float32 kPlankLength = 1.0f;      ///< from hinge to hinge [m]
constexpr float32 kPlankHalfHeight = 0.15f; ///< [m]
constexpr float32 kDeckHeight = 8.0f;       ///< of the hinges at both ends [m]
constexpr float32 kHalfSpan = 0.5f * kPlankLength * static_cast<float32>(kPlankCount);

// Planks much heavier than what falls on them keep the mass ratio in the chain of hinges low, and
// with it the gaps that the solver leaves.
constexpr Material kWood{.density = 4.0f, .friction = 0.6f};
constexpr Material kLoad{.density = 1.0f, .friction = 0.5f, .restitution = 0.1f};

constexpr int32 kLoadCount = 12;

class Bridge : public Scene
{
public:
    explicit Bridge(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* leftBank = AddGroundBox(m_world, b2Vec2(-kHalfSpan - 3.0f, 4.0f), 3.0f, 4.0f);
        b2Body* rightBank = AddGroundBox(m_world, b2Vec2(kHalfSpan + 3.0f, 4.0f), 3.0f, 4.0f);
        AddGroundEdge(m_world, b2Vec2(-kHalfSpan, 0.0f), b2Vec2(kHalfSpan, 0.0f));

        b2Body* previous = leftBank;
        for (int32 i = 0; i < kPlankCount; ++i)
        {
            const float32 hinge = -kHalfSpan + kPlankLength * static_cast<float32>(i);
            const b2Vec2 center(hinge + 0.5f * kPlankLength, kDeckHeight);
            b2Body* plank = AddBox(m_world, center, 0.5f * kPlankLength, kPlankHalfHeight, kWood);
            AddHinge(m_world, previous, plank, b2Vec2(hinge, kDeckHeight));
            previous = plank;
        }
        AddHinge(m_world, previous, rightBank, b2Vec2(kHalfSpan, kDeckHeight));

        DropLoads(settings.seed);
    }

private:
    // One above the other with room between, so that they arrive one by one.
    void DropLoads(uint32 seed)
    {
        Random random(seed);
        for (int32 i = 0; i < kLoadCount; ++i)
        {
            const float32 x = random.Between(-0.7f * kHalfSpan, 0.7f * kHalfSpan);
            const float32 y = kDeckHeight + 3.0f + 0.9f * static_cast<float32>(i);
            AddLoad(b2Vec2(x, y), i % 3, random.Between(0.4f, 0.6f), random.Between(-1.0f, 1.0f));
        }
    }

    void AddLoad(const b2Vec2& position, int32 kind, float32 size, float32 angle)
    {
        b2Body* load = AddBody(m_world, b2_dynamicBody, position, angle);
        switch (kind)
        {
        case 0:
            AttachCircle(*load, size, kLoad);
            break;
        case 1:
            AttachBox(*load, size, size, kLoad);
            break;
        default:
            AttachPolygon(*load, {{-size, -0.6f * size}, {size, -0.6f * size}, {0.0f, 1.2f * size}},
                          kLoad);
            break;
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeBridge(const SceneSettings& settings)
{
    return std::make_unique<Bridge>(settings);
}

} // namespace boxreel
