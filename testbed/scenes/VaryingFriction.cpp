// SPDX-License-Identifier: MIT
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <vector>

namespace boxreel
{

namespace
{

constexpr float32 kSlope = b2_pi / 6.0f; ///< of the slides [rad]
constexpr float32 kSlideLength = 5.0f;   ///< [m]
constexpr float32 kBendRadius = 4.0f;    ///< from the slope to the level [m]
constexpr int32 kBendParts = 8;
constexpr float32 kLevelEnd = 16.0f;   ///< [m]
constexpr float32 kLevelStart = -5.0f; ///< [m]
constexpr float32 kTierStep = 4.5f;    ///< from slide to slide [m]
constexpr float32 kHalfSize = 0.5f;    ///< of a box [m]

// With the slides' 0.6 the effective coefficients are the roots of the products. 0.67 holds on a
// slope of 30 degrees, whose tangent is 0.58. 0.55, 0.42 and 0.24 slide ever farther, and 0 without
// end.
constexpr float32 kFrictions[] = {0.75f, 0.5f, 0.3f, 0.1f, 0.0f};

/// From the top of the slope, around the bend, along the level, to the wall at its end.
std::vector<b2Vec2> SlideLine(float32 height)
{
    std::vector<b2Vec2> line;
    for (int32 i = 0; i <= kBendParts; ++i)
    {
        const float32 share = static_cast<float32>(i) / static_cast<float32>(kBendParts);
        const b2Rot slope(kSlope * (1.0f - share));
        line.emplace_back(kLevelStart - kBendRadius * slope.s,
                          height + kBendRadius * (1.0f - slope.c));
    }
    const b2Rot slope(kSlope);
    line.insert(line.begin(), line.front() + kSlideLength * b2Vec2(-slope.c, slope.s));
    line.emplace_back(kLevelEnd, height);
    line.emplace_back(kLevelEnd, height + 1.5f);
    return line;
}

class VaryingFriction : public Scene
{
public:
    explicit VaryingFriction(const SceneSettings& settings) : Scene(settings)
    {
        const b2Rot slope(kSlope);
        float32 height = kTierStep * static_cast<float32>(std::size(kFrictions));
        for (const float32 friction : kFrictions)
        {
            height -= kTierStep;
            const std::vector<b2Vec2> line = SlideLine(height);
            AddSlide(line);
            const b2Vec2 foot = line.front() + 1.2f * b2Vec2(slope.c, -slope.s);
            AddBox(m_world, foot + kHalfSize * b2Vec2(slope.s, slope.c), kHalfSize, kHalfSize,
                   {.friction = friction}, -kSlope);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(2.5f, 10.5f), .halfSize = b2Vec2(14.5f, 11.5f)};
    }

private:
    void AddSlide(const std::vector<b2Vec2>& line)
    {
        b2ChainShape shape;
        shape.CreateChain(line.data(), static_cast<int32>(line.size()));
        b2FixtureDef definition;
        definition.shape = &shape;
        definition.friction = Material{}.friction;
        AddBody(m_world, b2_staticBody, b2Vec2(0.0f, 0.0f))->CreateFixture(&definition);
    }
};

} // namespace

std::unique_ptr<Scene> MakeVaryingFriction(const SceneSettings& settings)
{
    return std::make_unique<VaryingFriction>(settings);
}

} // namespace boxreel
