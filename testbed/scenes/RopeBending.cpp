// SPDX-License-Identifier: MIT
#include <scenes/JointParts.h>
#include <scenes/Parts.h>
#include <scenes/Scenes.h>

#include <string>

namespace boxreel
{

namespace
{

constexpr int32 kLinkCount = 6;
constexpr float32 kLinkLength = 1.05f; ///< from joint to joint [m]
constexpr float32 kRadius = 0.14f;     ///< half the thickness of a rope [m]
constexpr float32 kApart = 8.0f;       ///< from rope to rope [m]
constexpr float32 kSpringRow = 14.0f;  ///< height of the ropes with springs [m]
constexpr float32 kLimitRow = 6.5f;    ///< height of the ropes with limits [m]
constexpr Material kHemp{.density = 4.0f};

// Spring joints always bend, less if stiffer; limited ones turn freely up to
// their limit and then not at all.
constexpr float32 kHertz[] = {9.0f, 16.0f, 32.0f};
constexpr float32 kLimits[] = {0.45f, 0.24f, 0.08f}; ///< to each side [rad]

/// Ropes that a wall holds at one end. Above, the joints between their links are springs, below
/// they have limits; from left to right they bend less and less.
class RopeBending : public Scene
{
public:
    explicit RopeBending(const SceneSettings& settings) : Scene(settings)
    {
        m_world.SetSubStepCount(4); // stiff joints are as stiff as they say
        constexpr const char* kSprings[] = {"weak spring", "middling spring", "strong spring"};
        constexpr const char* kStops[] = {"wide limit", "middling limit", "narrow limit"};
        for (int32 i = 0; i < 3; ++i)
        {
            const float32 x = kApart * static_cast<float32>(i);
            const auto spring = [&](b2Body* a, b2Body* b, const b2Vec2& point) {
                AddWeld(m_world, a, b, point, kHertz[i], 5.0f);
            };
            const auto limit = [&](b2Body* a, b2Body* b, const b2Vec2& point) {
                AddLimitedHinge(m_world, a, b, point, -kLimits[i], kLimits[i]);
            };
            Name(*AddRope(b2Vec2(x, kSpringRow), spring), kSprings[i]);
            Name(*AddRope(b2Vec2(x, kLimitRow), limit), kStops[i]);
        }
    }

    std::optional<SceneArea> PreferredView() const override
    {
        return SceneArea{.center = b2Vec2(10.5f, 8.0f), .halfSize = b2Vec2(12.5f, 8.0f)};
    }

private:
    /// Level at the start; returns its last link.
    template <class Join>
    b2Body* AddRope(const b2Vec2& start, const Join& join)
    {
        b2Body* previous = AddGroundBox(m_world, start - b2Vec2(0.4f, 0.0f), 0.4f, 0.6f);
        for (int32 i = 0; i < kLinkCount; ++i)
        {
            const b2Vec2 joint = start + b2Vec2(kLinkLength * static_cast<float32>(i), 0.0f);
            const b2Vec2 half(0.5f * kLinkLength, 0.0f);
            b2Body* link = AddBox(m_world, joint + half, half.x + kRadius, kRadius, kHemp);
            SetGroup(*link, -1); // at the joints they bend into each other
            join(previous, link, joint);
            previous = link;
        }
        return previous;
    }
};

} // namespace

std::unique_ptr<Scene> MakeRopeBending(const SceneSettings& settings)
{
    return std::make_unique<RopeBending>(settings);
}

} // namespace boxreel
