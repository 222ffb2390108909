// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Random.h>
#include <scenes/Scenes.h>

#include <array>

namespace boxreel
{

namespace
{

constexpr std::size_t kPlankCount = 24;
constexpr float32 kPlankLength = 1.0f;      ///< from hinge to hinge [m]
constexpr float32 kPlankHalfHeight = 0.15f; ///< [m]
constexpr float32 kDeckHeight = 8.0f;       ///< of the hinges at both ends [m]

// The planks start along an arc that is this steep at the banks [rad]. A bridge as long as its span
// could not sag: any load would pull at the hinges without bound.
constexpr float32 kEndSlope = 0.3f;

// Planks much heavier than what falls on them keep the mass ratio in the chain of hinges low, and
// with it the gaps that the solver leaves.
constexpr Material kWood{.density = 4.0f, .friction = 0.6f};
constexpr Material kLoad{.density = 1.0f, .friction = 0.5f, .restitution = 0.1f};

constexpr int32 kLoadCount = 12;
constexpr float32 kLoadReach = 8.0f; ///< how far from the middle they fall at most [m]

class Bridge : public Scene
{
public:
    explicit Bridge(const SceneSettings& settings) : Scene(settings)
    {
        std::array<b2Vec2, kPlankCount + 1> hinges = ArcOfHinges();
        const float32 halfSpan = hinges.back().x;
        b2Body* leftBank = AddGroundBox(m_world, b2Vec2(-halfSpan - 3.0f, 4.0f), 3.0f, 4.0f);
        b2Body* rightBank = AddGroundBox(m_world, b2Vec2(halfSpan + 3.0f, 4.0f), 3.0f, 4.0f);
        AddGroundEdge(m_world, b2Vec2(-halfSpan, 0.0f), b2Vec2(halfSpan, 0.0f));

        b2Body* previous = leftBank;
        for (std::size_t i = 0; i < kPlankCount; ++i)
        {
            b2Body* plank = AddBox(m_world, 0.5f * (hinges[i] + hinges[i + 1]), 0.5f * kPlankLength,
                                   kPlankHalfHeight, kWood, SlopeOf(i));
            AddHinge(m_world, previous, plank, hinges[i]);
            previous = plank;
        }
        AddHinge(m_world, previous, rightBank, hinges.back());

        DropLoads(settings.seed);
    }

private:
    /// Returns the angle of a plank to the horizontal [rad]. It grows by the same angle per plank.
    static float32 SlopeOf(std::size_t plank)
    {
        const float32 middle = 0.5f * static_cast<float32>(kPlankCount - 1);
        return kEndSlope * (static_cast<float32>(plank) - middle) / middle;
    }

    /// The ends of the planks, from bank to bank, with the middle of the bridge at x = 0.
    static std::array<b2Vec2, kPlankCount + 1> ArcOfHinges()
    {
        std::array<b2Vec2, kPlankCount + 1> hinges;
        hinges[0] = b2Vec2(0.0f, kDeckHeight);
        for (std::size_t i = 0; i < kPlankCount; ++i)
        {
            const b2Rot slope(SlopeOf(i));
            hinges[i + 1] = hinges[i] + kPlankLength * b2Vec2(slope.c, slope.s);
        }
        const float32 halfSpan = 0.5f * hinges.back().x;
        for (b2Vec2& hinge : hinges)
        {
            hinge.x -= halfSpan;
        }
        return hinges;
    }

    // One above the other with room between, so that they arrive one by one.
    void DropLoads(uint32 seed)
    {
        Random random(seed);
        for (int32 i = 0; i < kLoadCount; ++i)
        {
            const float32 x = random.Between(-kLoadReach, kLoadReach);
            const float32 y = kDeckHeight + 3.0f + 0.75f * static_cast<float32>(i);
            // One draw a statement: the order of arguments is each compiler's own.
            const float32 size = random.Between(0.4f, 0.6f);
            const float32 angle = random.Between(-1.0f, 1.0f);
            AddLoad(b2Vec2(x, y), i % 3, size, angle);
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
