// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kPerRow = 15;
constexpr float32 kHalfThickness = 0.1f; ///< [m]
constexpr float32 kHalfHeight = 1.0f;    ///< [m]
constexpr float32 kStep = 1.0f;          ///< from domino to domino [m]
constexpr float32 kStart = 0.6f;         ///< of the first ones, from the middle [m]

/// Two rows that lean away from each other as soon as a wedge falls between their first ones.
class DoubleDomino : public Scene
{
public:
    explicit DoubleDomino(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundEdge(m_world, b2Vec2(-25.0f, 0.0f), b2Vec2(25.0f, 0.0f));
        for (const float32 side : {-1.0f, 1.0f})
        {
            for (int32 i = 0; i < kPerRow; ++i)
            {
                const float32 x = side * (kStart + kStep * static_cast<float32>(i));
                AddBox(m_world, b2Vec2(x, kHalfHeight), kHalfThickness, kHalfHeight);
            }
        }
        b2Body* wedge = AddBody(m_world, b2_dynamicBody, b2Vec2(0.0f, 6.0f));
        AttachPolygon(*wedge, {{0.0f, -1.0f}, {0.8f, 1.0f}, {-0.8f, 1.0f}},
                      {.density = 4.0f, .friction = 0.1f});
    }
};

} // namespace

std::unique_ptr<Scene> MakeDoubleDomino(const SceneSettings& settings)
{
    return std::make_unique<DoubleDomino>(settings);
}

} // namespace boxreel
