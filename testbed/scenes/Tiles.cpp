// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kTileColumns = 60;
constexpr int32 kTileRows = 6;
constexpr float32 kTile = 0.5f; ///< [m]

constexpr int32 kBaseCount = 12;      ///< of the pyramid
constexpr float32 kHalfSize = 0.5f;   ///< of its boxes [m]
constexpr float32 kFallHeight = 3.0f; ///< [m]

/// A ground of many small tiles, all fixtures of one body, supports a falling pyramid.
class Tiles : public Scene
{
public:
    explicit Tiles(const SceneSettings& settings) : Scene(settings)
    {
        b2Body* ground = AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f));
        for (int32 row = 0; row < kTileRows; ++row)
        {
            for (int32 column = 0; column < kTileColumns; ++column)
            {
                const float32 fromMiddle = static_cast<float32>(2 * column - kTileColumns + 1);
                const b2Vec2 center(0.5f * kTile * fromMiddle,
                                    -kTile * (0.5f + static_cast<float32>(row)));
                AttachBox(*ground, 0.5f * kTile, 0.5f * kTile, {}, center);
            }
        }
        AddPyramid();
    }

    // Boxes apart by a tenth of their size.
    void AddPyramid()
    {
        const float32 step = 2.2f * kHalfSize;
        for (int32 row = 0; row < kBaseCount; ++row)
        {
            for (int32 i = 0; i < kBaseCount - row; ++i)
            {
                const float32 x = 0.5f * step * static_cast<float32>(2 * i - kBaseCount + row + 1);
                const float32 y = kFallHeight + kHalfSize + step * static_cast<float32>(row);
                AddBox(m_world, b2Vec2(x, y), kHalfSize, kHalfSize, {.density = 5.0f});
            }
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakeTiles(const SceneSettings& settings)
{
    return std::make_unique<Tiles>(settings);
}

} // namespace boxreel
