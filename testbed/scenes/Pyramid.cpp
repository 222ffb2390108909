// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

namespace boxreel
{

namespace
{

constexpr int32 kBaseCount = 20;
constexpr float32 kHalfSize = 0.5f; ///< [m]

// The boxes start a little apart, so that the pyramid is seen to settle: a column of twenty gaps
// lowers the top box by 2 m. Much wider gaps would let a row arrive hard enough to shove the one
// below.
constexpr float32 kColumnStep = 1.12f; ///< between the centres of neighbours in a row [m]
constexpr float32 kRowStep = 1.1f;     ///< between the centres of two rows [m]

class Pyramid : public Scene
{
public:
    explicit Pyramid(const SceneSettings& settings) : Scene(settings)
    {
        AddGroundBox(m_world, b2Vec2(0.0f, -0.5f), 20.0f, 0.5f);
        for (int32 row = 0; row < kBaseCount; ++row)
        {
            const int32 boxes = kBaseCount - row;
            const float32 left = -0.5f * kColumnStep * static_cast<float32>(boxes - 1);
            const float32 y = kHalfSize + kRowStep * static_cast<float32>(row);
            for (int32 column = 0; column < boxes; ++column)
            {
                const float32 x = left + kColumnStep * static_cast<float32>(column);
                AddBox(m_world, b2Vec2(x, y), kHalfSize, kHalfSize);
            }
        }
    }
};

} // namespace

std::unique_ptr<Scene> MakePyramid(const SceneSettings& settings)
{
    return std::make_unique<Pyramid>(settings);
}

} // namespace boxreel
